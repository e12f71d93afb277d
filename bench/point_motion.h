// SPDX-License-Identifier: MIT
//
// Moving point objects for tests and measurements of the points codec: a flag in gusts of wind, a
// rope whose ends move, a fountain and smoke. Each advance() is one tick of 1/60 s.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "jostle/snapshot/point_codec.h"

namespace jostle::bench {

using Point = std::array<double, 3>;

inline Point operator+(const Point& a, const Point& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Point operator-(const Point& a, const Point& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Point operator*(double s, const Point& a) {
    return {s * a[0], s * a[1], s * a[2]};
}
inline double length(const Point& a) {
    return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}

// Uniform in -1 to 1.
class Noise {
public:
    double next() {
        state_ = state_ * 6364136223846793005u + 1442695040888963407u;
        return static_cast<double>(state_ >> 40) / 8388608 - 1;
    }
    Point vector() { return {next(), next(), next()}; }

private:
    std::uint64_t state_ = 42;
};

// A sine without libm: the imaginary part of a rotating number.
class Oscillator {
public:
    explicit Oscillator(double radians_per_tick) : turn_(radians_per_tick) {}
    double next() {
        const double re = re_ - turn_ * im_, im = im_ + turn_ * re_;
        const double norm = std::sqrt(re * re + im * im);
        re_ = re / norm;
        im_ = im / norm;
        return im_;
    }

private:
    double turn_, re_ = 1, im_ = 0;
};

class MovingPoints {
public:
    virtual ~MovingPoints() = default;
    virtual void advance() = 0;

    std::string name;
    snapshot::PointLayout layout;
    double step_m = 0.001;
    int divisor = 3;  // ticks between two states
    std::vector<Point> positions;
    std::vector<std::uint32_t> ids;  // loose points, ascending

    std::vector<std::int32_t> quantized() const {
        std::vector<std::int32_t> values;
        for (const Point& p : positions)
            for (const double x : p)
                values.push_back(static_cast<std::int32_t>(std::floor(x / step_m + 0.5)));
        return values;
    }
};

// Points connected by distances: Verlet integration and relaxation (Jakobsen, "Advanced character
// physics", GDC 2001).
class Sheet : public MovingPoints {
public:
    Sheet(std::uint32_t columns, std::uint32_t rows, double spacing) : columns_(columns) {
        for (std::uint32_t row = 0; row < rows; row++)
            for (std::uint32_t column = 0; column < columns; column++) {
                positions.push_back({spacing * column, 4 - spacing * row, 0});
                const std::uint32_t at = row * columns + column;
                for (const std::uint32_t far : {1u, 2u}) {  // stretching and bending
                    if (column >= far)
                        links_.push_back({at - far, at, far * spacing, far == 1 ? 1.0 : bending});
                    if (row >= far)
                        links_.push_back(
                            {at - far * columns, at, far * spacing, far == 1 ? 1.0 : bending});
                }
            }
        before_ = positions;
        fixed_.resize(positions.size());
    }

protected:
    static constexpr int substeps = 8, sweeps = 6;
    static constexpr double bending = 0.1;  // share of the error that a sweep corrects
    static constexpr double dt = 1.0 / 60 / substeps;

    template <class Acceleration>
    void integrate(const Acceleration& acceleration) {
        for (int substep = 0; substep < substeps; substep++) {
            for (std::uint32_t k = 0; k < positions.size(); k++) {
                if (fixed_[k]) continue;
                const Point velocity = 0.99 * (positions[k] - before_[k]);
                before_[k] = positions[k];
                positions[k] = positions[k] + velocity + dt * dt * acceleration(k);
            }
            for (int sweep = 0; sweep < sweeps; sweep++)
                for (const Link& link : links_) relax(link);
        }
    }

    Point normal(std::uint32_t k) const {
        const std::uint32_t column = k % columns_;
        const Point u =
            positions[column + 1 < columns_ ? k + 1 : k] - positions[column > 0 ? k - 1 : k];
        const Point v = positions[k + columns_ < positions.size() ? k + columns_ : k] -
                        positions[k >= columns_ ? k - columns_ : k];
        const Point n = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                         u[0] * v[1] - u[1] * v[0]};
        return 1 / (length(n) + 1e-12) * n;
    }

    std::vector<bool> fixed_;
    std::uint32_t columns_;

private:
    struct Link {
        std::uint32_t a, b;
        double rest, stiffness;
    };

    void relax(const Link& link) {
        const auto [a, b, rest, stiffness] = link;
        const Point d = positions[b] - positions[a];
        const double far = length(d), share = stiffness * (fixed_[a] || fixed_[b] ? 1 : 0.5);
        const Point move = (share * (far - rest) / (far + 1e-12)) * d;
        if (!fixed_[a]) positions[a] = positions[a] + move;
        if (!fixed_[b]) positions[b] = positions[b] - move;
    }

    std::vector<Link> links_;
    std::vector<Point> before_;
};

class Flag final : public Sheet {
public:
    Flag() : Sheet(31, 21, 0.06) {
        name = "flag";
        step_m = 0.002;
        layout = {.form = snapshot::PointForm::grid,
                  .points = 31 * 21,
                  .columns = 31,
                  .strands = {},
                  .triangles = {}};
        for (std::uint32_t k = 0; k < positions.size(); k += columns_) fixed_[k] = true;
    }
    void advance() override {
        const Point gust = {7 + 2 * slow_.next() + 0.2 * noise_.next(), 0,
                            3 * fast_.next() + 0.2 * noise_.next()};
        integrate([&](std::uint32_t k) {
            const Point n = normal(k);
            const double along = n[0] * gust[0] + n[1] * gust[1] + n[2] * gust[2];
            return 4 * along * n + Point{0, -9.81, 0};
        });
    }

private:
    Oscillator slow_{0.03}, fast_{0.11};
    Noise noise_;
};

class Rope final : public Sheet {
public:
    Rope() : Sheet(65, 1, 0.1) {
        name = "rope";
        layout = {.form = snapshot::PointForm::strands,
                  .points = 65,
                  .columns = 0,
                  .strands = {65},
                  .triangles = {}};
        fixed_.front() = fixed_.back() = true;
    }
    void advance() override {
        positions.back() = {5 + 0.4 * slow_.next(), 4, 0.5 * fast_.next()};
        integrate([](std::uint32_t) { return Point{0, -9.81, 0}; });
    }

private:
    Oscillator slow_{0.05}, fast_{0.08};
};

// Loose points that are emitted at a place and disappear at the end of their lives.
class Cloud : public MovingPoints {
public:
    void advance() override {
        for (int k = 0; k < emitted_per_tick; k++) {
            positions.push_back(0.02 * noise_.vector());
            velocities_.push_back(first_velocity());
            ends_.push_back(tick_ + static_cast<int>(lifetime * (1 + 0.1 * noise_.next())));
            ids.push_back(next_id_++);
        }
        tick_++;
        std::size_t kept = 0;
        for (std::size_t k = 0; k < positions.size(); k++) {
            if (ends_[k] <= tick_) continue;
            positions[kept] = positions[k], velocities_[kept] = velocities_[k];
            ends_[kept] = ends_[k], ids[kept] = ids[k];
            move(positions[kept], velocities_[kept]);
            kept++;
        }
        positions.resize(kept), velocities_.resize(kept), ends_.resize(kept), ids.resize(kept);
    }

protected:
    virtual Point first_velocity() = 0;
    virtual void move(Point& position, Point& velocity) = 0;

    static constexpr double dt = 1.0 / 60;
    int emitted_per_tick = 5;
    double lifetime = 90;  // ticks
    Noise noise_;

private:
    std::vector<Point> velocities_;
    std::vector<int> ends_;
    std::uint32_t next_id_ = 1;
    int tick_ = 0;
};

class Fountain final : public Cloud {
public:
    Fountain() {
        name = "fountain";
        step_m = 0.01;
    }

private:
    Point first_velocity() override { return Point{0, 7, 0} + 0.8 * noise_.vector(); }
    void move(Point& p, Point& v) override {
        p = p + dt * v + (0.5 * dt * dt) * Point{0, -9.81, 0};
        v = v + dt * Point{0, -9.81, 0};
    }
};

class Smoke final : public Cloud {
public:
    Smoke() {
        name = "smoke";
        step_m = 0.02;
        emitted_per_tick = 3;
        lifetime = 150;
    }

private:
    Point first_velocity() override { return {0.2, 1.2, 0}; }
    // Swirls of 1.5 m that rise with the smoke.
    void move(Point& p, Point& v) override {
        const auto wave = [](double x) { return 1 - 8 * std::abs(x - std::floor(x) - 0.5); };
        const Point swirl = {0.5 * wave(p[1] / 1.5), 0.3 * wave(p[0] / 1.5),
                             0.5 * wave(p[1] / 1.5 + 0.3)};
        v = v + 0.1 * (Point{0.3, 1.2, 0} + swirl - v);
        p = p + dt * v;
    }
};

}  // namespace jostle::bench
