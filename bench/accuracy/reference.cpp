// SPDX-License-Identifier: MIT
#include "bench/accuracy/reference.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "bench/accuracy/accuracy_bodies.h"

namespace jostle::bench::accuracy {
namespace {

using physics::pi;

constexpr double reference_step = 1.0 / reference_hz;

std::size_t ticks_of(double seconds) {
    return static_cast<std::size_t>(std::llround(seconds * reference_hz));
}

// Solves A x = b with A dense, symmetric and positive definite; b becomes x.
void solve(std::vector<double>& a, double* b, std::size_t n) {
    for (std::size_t p = 0; p < n; p++)
        for (std::size_t row = p + 1; row < n; row++) {
            const double factor = a[row * n + p] / a[p * n + p];
            for (std::size_t k = p; k < n; k++) a[row * n + k] -= factor * a[p * n + k];
            b[row] -= factor * b[p];
        }
    for (std::size_t row = n; row-- > 0;) {
        for (std::size_t k = row + 1; k < n; k++) b[row] -= a[row * n + k] * b[k];
        b[row] /= a[row * n + row];
    }
}

// Lagrange's equations of a planar chain in absolute angles t_j:
//     sum_k A_jk cos(t_j - t_k) t_k'' + I_j t_j'' = -g G_j sin t_j - sum_k A_jk sin(t_j - t_k)
//     t_k'^2
// with A_jk = sum_i m_i c_ij c_ik, G_j = sum_i m_i c_ij, and c_ij the distance along link j of the
// centre of link i.
class ChainEquations {
public:
    explicit ChainEquations(const std::vector<ChainLink>& links)
        : links_(links), n_(links.size()), coupling_(n_ * n_), moment_(n_), mass_(n_ * n_) {
        for (std::size_t i = 0; i < n_; i++)
            for (std::size_t j = 0; j <= i; j++) {
                moment_[j] += links[i].mass * arm(i, j);
                for (std::size_t k = 0; k <= i; k++)
                    coupling_[j * n_ + k] += links[i].mass * arm(i, j) * arm(i, k);
            }
    }

    void rate(const State& y, State& dy) {
        dy.resize(2 * n_);
        for (std::size_t j = 0; j < n_; j++) {
            dy[j] = y[n_ + j];
            double push = -g * moment_[j] * std::sin(y[j]);
            for (std::size_t k = 0; k < n_; k++) {
                const double angle = y[j] - y[k], c = coupling_[j * n_ + k];
                mass_[j * n_ + k] = c * std::cos(angle) + (j == k ? links_[j].inertia : 0);
                push -= c * std::sin(angle) * y[n_ + k] * y[n_ + k];
            }
            dy[n_ + j] = push;
        }
        solve(mass_, dy.data() + n_, n_);
    }

    Vec3 center(const State& y, std::size_t which) const {
        Vec3 at;
        for (std::size_t j = 0; j <= which; j++)
            at += Vec3{std::sin(y[j]), 0, -std::cos(y[j])} * arm(which, j);
        return at;
    }

private:
    double arm(std::size_t i, std::size_t j) const {
        return j < i ? links_[j].length : links_[j].center;
    }

    const std::vector<ChainLink>& links_;
    std::size_t n_;
    std::vector<double> coupling_, moment_, mass_;
};

}  // namespace

Vec3 at_time(const Trajectory& track, double t) {
    const auto tick = static_cast<std::size_t>(std::llround(t * reference_hz));
    return track[std::min(tick, track.size() - 1)];
}

std::shared_ptr<const Trajectory> cached_trajectory(const std::string& name,
                                                    const std::function<Trajectory()>& make) {
    static std::map<std::string, std::shared_ptr<const Trajectory>> trajectories;
    auto& track = trajectories[name];
    if (!track) track = std::make_shared<const Trajectory>(make());
    return track;
}

void runge_kutta_step(State& y, double h, const Rate& rate) {
    static thread_local State k1, k2, k3, k4, between;
    const auto moved = [&](const State& k, double by) -> const State& {
        between.resize(y.size());
        for (std::size_t i = 0; i < y.size(); i++) between[i] = y[i] + by * k[i];
        return between;
    };
    rate(y, k1);
    rate(moved(k1, h / 2), k2);
    rate(moved(k2, h / 2), k3);
    rate(moved(k3, h), k4);
    for (std::size_t i = 0; i < y.size(); i++)
        y[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
}

double elliptic_k(double k) {
    double a = 1, b = std::sqrt(1 - k * k);
    for (int round = 0; round < 40 && std::abs(a - b) > 1e-16 * a; round++)
        std::tie(a, b) = std::pair(0.5 * (a + b), std::sqrt(a * b));
    return pi / (2 * a);
}

// Amplitude by the arithmetic-geometric mean: Abramowitz and Stegun, 16.4.
double jacobi_cd(double u, double k) {
    constexpr int most = 16;
    double a[most + 1] = {1}, c[most + 1] = {k}, b = std::sqrt(1 - k * k);
    int n = 0;
    while (n < most && std::abs(c[n]) > 1e-17) {
        a[n + 1] = 0.5 * (a[n] + b);
        c[n + 1] = 0.5 * (a[n] - b);
        b = std::sqrt(a[n] * b);
        n++;
    }
    double angle = std::ldexp(a[n] * u, n);
    for (int i = n; i > 0; i--) angle = 0.5 * (angle + std::asin(c[i] / a[i] * std::sin(angle)));
    const double sine = std::sin(angle);
    return std::cos(angle) / std::sqrt(1 - k * k * sine * sine);
}

double pendulum_angle(double rate, double start_angle, double t) {
    const double k = std::sin(0.5 * start_angle);
    const double quarter = elliptic_k(k);
    const double u = std::fmod(rate * t, 4 * quarter);  // near zero the amplitude is exact
    return 2 * std::asin(std::clamp(k * jacobi_cd(u, k), -1.0, 1.0));
}

double pendulum_period(double rate, double start_angle) {
    return 4 * elliptic_k(std::sin(0.5 * start_angle)) / rate;
}

Trajectory planar_chain(const std::vector<ChainLink>& links, double start_angle, double seconds,
                        std::size_t which) {
    ChainEquations equations(links);
    State y(2 * links.size(), 0);
    std::fill_n(y.begin(), links.size(), start_angle);
    Trajectory track;
    for (std::size_t tick = 0; tick <= ticks_of(seconds); tick++) {
        track.push_back(equations.center(y, which));
        runge_kutta_step(y, reference_step,
                         [&](const State& at, State& rate) { equations.rate(at, rate); });
    }
    return track;
}

// y: spin in the body's axes, then the quaternion x, y, z, w; q' = q * (spin, 0) / 2.
Trajectory free_axis_y(Vec3 inertia, Vec3 spin, double seconds) {
    const auto rate = [&](const State& y, State& dy) {
        dy.resize(7);
        dy[0] = (inertia.y - inertia.z) * y[1] * y[2] / inertia.x;
        dy[1] = (inertia.z - inertia.x) * y[2] * y[0] / inertia.y;
        dy[2] = (inertia.x - inertia.y) * y[0] * y[1] / inertia.z;
        const Quat turn = Quat{y[3], y[4], y[5], y[6]} * Quat{y[0], y[1], y[2], 0};
        const double parts[] = {turn.x, turn.y, turn.z, turn.w};
        for (std::size_t k = 0; k < 4; k++) dy[3 + k] = 0.5 * parts[k];
    };
    State y = {spin.x, spin.y, spin.z, 0, 0, 0, 1};
    Trajectory track;
    for (std::size_t tick = 0; tick <= ticks_of(seconds); tick++) {
        track.push_back(rotate(Quat{y[3], y[4], y[5], y[6]}, {0, 1, 0}));
        runge_kutta_step(y, reference_step, rate);
    }
    return track;
}

// Each joint carries the same horizontal force H; the slope of link i is its distance from the
// middle, in links, divided by H / weight. The span decreases with that ratio: bisection.
double catenary_sag(int links, double link_length, double span) {
    const auto sums = [&](double ratio) {
        double width = 0, depth = 0;
        for (int i = 1; i <= links; i++) {
            const double slope = (i - 0.5 * (links + 1)) / ratio;
            const double cosine = 1 / std::sqrt(1 + slope * slope);
            width += link_length * cosine;
            if (slope > 0) depth += link_length * cosine * slope;
        }
        return std::pair(width, depth);
    };
    double low = 1e-6, high = 1e6;
    for (int round = 0; round < 200; round++) {
        const double middle = 0.5 * (low + high);
        (sums(middle).first < span ? low : high) = middle;
    }
    return sums(0.5 * (low + high)).second;
}

}  // namespace jostle::bench::accuracy
