// SPDX-License-Identifier: MIT
//
// The reference solutions of the accuracy benchmark: closed forms compared with the Runge-Kutta
// method and with values from the literature.
#include "bench/accuracy/reference.h"

#include <gtest/gtest.h>

#include <cmath>

#include "bench/accuracy/accuracy_bodies.h"
#include "bench/accuracy/experiment.h"
#include "bench/accuracy/experiment_list.h"
#include "jostle/physics/geometry.h"

namespace {

using namespace jostle::bench::accuracy;
using jostle::physics::pi;

constexpr double rod_at_pivot = 1.0 / 3 * (0.05 * 0.05 + 0.25) + 0.25;  // kg m^2, of 1 kg and 1 m

double rod_rate() {
    return std::sqrt(g * 0.5 / rod_at_pivot);
}

TEST(Pendulum, rate_and_periods_match_reference_values) {
    EXPECT_NEAR(rod_rate(), 3.8312275, 5e-8);
    const double degrees[] = {5, 30, 90, 150, 170};
    const double periods[] = {1.640774, 1.668543, 1.935750, 2.890001, 4.000537};
    for (int k = 0; k < 5; k++)
        EXPECT_NEAR(pendulum_period(rod_rate(), degrees[k] * pi / 180), periods[k], 5e-7);
}

TEST(Pendulum, closed_form_and_runge_kutta_agree) {
    const std::vector<ChainLink> rod = {{1, rod_at_pivot - 0.25, 1, 0.5}};
    for (const double degrees : {5.0, 30.0, 90.0, 150.0, 170.0}) {
        const double start = degrees * pi / 180;
        const Trajectory track = planar_chain(rod, start, 5, 0);
        for (double t = 0; t <= 5; t += 0.25) {
            const double angle = pendulum_angle(rod_rate(), start, t);
            const Vec3 truth = Vec3{std::sin(angle), 0, -std::cos(angle)} * 0.5;
            EXPECT_LT(length(at_time(track, t) - truth), 1e-10) << degrees << " degrees, " << t;
        }
    }
}

TEST(Pendulum, returns_after_one_period) {
    const double start = 2.5, period = pendulum_period(2, start);
    EXPECT_NEAR(pendulum_angle(2, start, 0), start, 1e-12);
    EXPECT_NEAR(pendulum_angle(2, start, 0.25 * period), 0, 1e-12);
    EXPECT_NEAR(pendulum_angle(2, start, 0.5 * period), -start, 1e-12);
    EXPECT_NEAR(pendulum_angle(2, start, 1000 * period), start, 1e-9);
}

TEST(Elliptic, matches_the_standard_library) {
    for (const double k : {0.0, 0.1, 0.5, 0.9, 0.999}) {
        EXPECT_NEAR(elliptic_k(k), std::comp_ellint_1(k), 1e-13);
        EXPECT_NEAR(jacobi_cd(elliptic_k(k), k), 0, 1e-12);
        EXPECT_NEAR(jacobi_cd(0, k), 1, 1e-15);
    }
}

TEST(Parallelogram, rate_and_period_match_reference_values) {
    const double rate = std::sqrt((2 * 0.5 + 2) * g / (2 * rod_at_pivot + 2));
    EXPECT_NEAR(rate, 3.3210475, 5e-8);
    EXPECT_NEAR(pendulum_period(rate, pi / 3), 2.030384, 5e-7);
}

// A light last link hardly affects the other one: the chain of two then equals the chain of one.
TEST(Chain, massless_link_changes_nothing) {
    const Trajectory one = planar_chain({{1, 0.1, 1, 0.5}}, 1, 1, 0);
    const Trajectory two = planar_chain({{1, 0.1, 1, 0.5}, {1e-9, 1e-10, 1, 0.5}}, 1, 1, 0);
    EXPECT_LT(length(one.back() - two.back()), 1e-7);
}

// Small oscillations of two equal rods: a sum of the two normal modes, derived for point masses at
// the ends: w^2 = g/l (2 -+ sqrt 2).
TEST(Chain, two_point_masses_swing_in_the_slow_mode) {
    const double slow = std::sqrt(g * (2 - std::sqrt(2.0)));
    const std::vector<ChainLink> points = {{1, 0, 1, 1}, {1, 0, 1, 1}};
    // Equal small angles are 0.854 of the slow mode and 0.146 of the fast one, at the lower end.
    const double start = 1e-4, fast = std::sqrt(g * (2 + std::sqrt(2.0)));
    const Trajectory track = planar_chain(points, start, 2, 1);
    for (double t = 0; t <= 2; t += 0.1) {
        const double a = (2 + std::sqrt(2.0)) / 4, b = (2 - std::sqrt(2.0)) / 4;
        const double upper = start * (a * std::cos(slow * t) + b * std::cos(fast * t));
        const double lower =
            start * std::sqrt(2.0) * (a * std::cos(slow * t) - b * std::cos(fast * t));
        EXPECT_NEAR(at_time(track, t).x, upper + lower, 1e-8 * 10) << t;
    }
}

// The spin about the middle axis changes its sign after 3.0838 s, and again after half a period of
// Jacobi's elliptic functions, 2 K(k) / rate = 5.5634 s.
TEST(Tumble, half_period_matches_jacobi_functions) {
    const Vec3 inertia{0.1, 0.2, 0.28}, spin{0.01, 5, 0.01};
    const Vec3 l = scaled(inertia, spin);
    const double energy2 = dot(spin, l), momentum2 = dot(l, l);
    // Landau and Lifshitz, Mechanics, section 37, with I1 < I2 < I3.
    const auto [a, b, c] = inertia;
    const bool above = momentum2 > energy2 * b;
    const double rate2 = above ? (c - b) * (momentum2 - energy2 * a) / (a * b * c)
                               : (b - a) * (energy2 * c - momentum2) / (a * b * c);
    const double k2 = (b - a) * (energy2 * c - momentum2) / ((c - b) * (momentum2 - energy2 * a));
    const double k = std::sqrt(above ? k2 : 1 / k2);
    const double half_period = 2 * elliptic_k(k) / std::sqrt(rate2);
    const Trajectory axis = free_axis_y(inertia, spin, 10);
    std::vector<double> zeros;  // of the spin about the middle axis
    for (std::size_t i = 1; i < axis.size(); i++)
        if (dot(axis[i - 1], l) * dot(axis[i], l) <= 0)
            zeros.push_back(static_cast<double>(i) / reference_hz);
    ASSERT_EQ(zeros.size(), 2u);
    EXPECT_NEAR(zeros[0], 3.08381, 1e-4);
    EXPECT_NEAR(half_period, 5.56342, 1e-5);
    EXPECT_NEAR(zeros[1] - zeros[0], half_period, 1.1 / reference_hz);
}

TEST(Catenary, sag_matches_reference_values) {
    EXPECT_NEAR(catenary_sag(40, 0.1, 3.0), 1.1777516, 5e-8);
    EXPECT_NEAR(catenary_sag(20, 0.5, 9.8), 0.8644919, 5e-8);
}

// Integrates Euler's equations about the fixed point with the torque of the weight. Returns the
// position of the centre.
Vec3 top_after(const Body& body, Vec3 inertia_at_pivot, Vec3 arm, double seconds) {
    const Vec3 local_spin = inverse_rotate(body.pose.rotation, body.spin);
    const Quat q0 = body.pose.rotation;
    State y = {local_spin.x, local_spin.y, local_spin.z, q0.x, q0.y, q0.z, q0.w};
    const auto rate = [&](const State& at, State& dy) {
        const Quat q{at[3], at[4], at[5], at[6]};
        const Vec3 w{at[0], at[1], at[2]};
        const Vec3 torque = cross(arm, inverse_rotate(q, {0, 0, -g * body.mass}));
        const Vec3 push = torque - cross(w, scaled(inertia_at_pivot, w));
        const Quat turn = q * Quat{w.x, w.y, w.z, 0};
        dy = {push.x / inertia_at_pivot.x,
              push.y / inertia_at_pivot.y,
              push.z / inertia_at_pivot.z,
              0.5 * turn.x,
              0.5 * turn.y,
              0.5 * turn.z,
              0.5 * turn.w};
    };
    const auto ticks = static_cast<int>(seconds * reference_hz);
    for (int k = 0; k < ticks; k++) runge_kutta_step(y, 1.0 / reference_hz, rate);
    return rotate(Quat{y[3], y[4], y[5], y[6]}, arm);
}

TEST(Top, precession_matches_the_closed_form) {
    const Body top = find_experiment("f5")->start(0).scene.bodies[0];
    const double tilt = pi / 3, rate = length(top.velocity) / (0.5 * std::sin(tilt));
    EXPECT_NEAR(rate, 1.2885096, 5e-8);
    const Vec3 found = top_after(top, {0.3, 0.3, 0.1}, {0, 0, 0.5}, 3);
    const Vec3 truth = azimuth(rate * 3) * (0.5 * std::sin(tilt)) + Vec3{0, 0, 0.25};
    EXPECT_LT(length(found - truth), 1e-9);
}

TEST(ConicalPendulum, rotation_matches_the_closed_form) {
    const Body rod = find_experiment("f6")->start(0).scene.bodies[0];
    const double tilt = pi / 6, rate = rod.spin.z;
    EXPECT_NEAR(rate * rate * (rod_at_pivot - rod.inertia.z) * std::cos(tilt), g * 0.5, 1e-12);
    const Vec3 found = top_after(rod, {rod_at_pivot, rod_at_pivot, rod.inertia.z}, {0, 0, -0.5}, 3);
    const Vec3 truth =
        azimuth(rate * 3) * (0.5 * std::sin(tilt)) - Vec3{0, 0, 0.5 * std::cos(tilt)};
    EXPECT_LT(length(found - truth), 1e-9);
}

TEST(Bodies, box_of_inertia_has_the_given_inertia) {
    const Vec3 half{0.3, 0.2, 0.1};
    EXPECT_LT(length(box_of_inertia(2, box_inertia(2, half)) - half), 1e-12);
    // An infinitely thin plate is replaced by a thin box with the same largest moment of inertia.
    const Vec3 plate = box_of_inertia(1, {0.05, 0.05, 0.1});
    EXPECT_DOUBLE_EQ(plate.z, jostle::physics::min_shape_size);
    EXPECT_NEAR(box_inertia(1, plate).z, 0.1, 1e-12);
}

TEST(Bodies, arch_wedge_has_the_expected_pose) {
    const Scene arch = find_experiment("c11")->start(0).scene;
    ASSERT_EQ(arch.bodies.size(), 16u);
    double mass = 0;
    for (int k = 0; k < 15; k++) {
        EXPECT_GT(arch.bodies[k].pose.position.z, 0);
        mass += arch.bodies[k].mass;
    }
    // A ring of 15 trapezoids: (r2^2 - r1^2) / 2 * 15 sin(12 deg) * depth * density.
    EXPECT_NEAR(mass, (2.4 * 2.4 - 2 * 2) / 2 * 15 * std::sin(pi / 15) * 0.4 * 1000, 1e-6 * mass);
    EXPECT_NEAR(arch.bodies[7].pose.position.x, 0, 1e-12);
    EXPECT_NEAR(arch.bodies[0].pose.position.x, -arch.bodies[14].pose.position.x, 1e-9);
}

}  // namespace
