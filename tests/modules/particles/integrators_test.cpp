// SPDX-License-Identifier: MIT
//
// The five integrators against closed forms: their orders, the energy of an oscillator (a circle in
// the plane of position and velocity), an orbit on an ellipse, stiff springs.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/modules/particles/with_particles.h"

namespace jostle::modules {
namespace {

using enum ParticleIntegrator;

constexpr ParticleIntegrator all_integrators[] = {explicit_euler, semi_implicit_euler,
                                                  implicit_euler, verlet, runge_kutta_4};
constexpr double w = 2 * pi;  // rad/s: a period of 1 s

ParticleGroupDef free_of_forces(ParticleIntegrator integrator) {
    return {.integrator = integrator, .gravity_scale = 0, .collide_bodies = false};
}

// x'' = -w^2 x, from (1 m, 0).
ParticleGroup oscillator(ParticleIntegrator integrator) {
    ParticleGroupDef def = free_of_forces(integrator);
    def.attractors = {{.strength = w * w, .falloff = -1}};
    return group_of(def, {{.position = {1, 0, 0}}});
}

double position_error(ParticleGroup& group, int steps, double seconds, Vec3 truth) {
    advance(group, steps, seconds / steps);
    return length(group.positions()[0] - truth);
}

// Ratio of the errors when the step is halved, as a power of two.
template <class Make>
double order_of(Make&& make, int steps, double seconds, Vec3 truth) {
    ParticleGroup coarse = make(), fine = make();
    return std::log2(position_error(coarse, steps, seconds, truth) /
                     position_error(fine, 2 * steps, seconds, truth));
}

TEST(ParticleIntegrators, orders_are_1_1_1_2_and_4) {
    constexpr double expected[] = {1, 1, 1, 2, 4};
    constexpr double seconds = 0.3;
    for (const ParticleIntegrator integrator : all_integrators) {
        const auto make = [&] { return oscillator(integrator); };
        const double order = order_of(make, 400, seconds, {std::cos(w * seconds), 0, 0});
        EXPECT_NEAR(order, expected[static_cast<int>(integrator)], 0.1)
            << static_cast<int>(integrator);
    }
}

// A throw with linear drag, whose force depends on the velocity: v = g / c + (v0 - g / c) exp(-c
// t).
TEST(ParticleIntegrators, orders_hold_with_drag) {
    constexpr double expected[] = {1, 1, 1, 2, 4};
    constexpr double c = 2, seconds = 1;
    const Vec3 v0{3, 4, 5}, last{0, -9.81 / c, 0};
    const Vec3 truth = last * seconds + (v0 - last) * ((1 - std::exp(-c * seconds)) / c);
    for (const ParticleIntegrator integrator : all_integrators) {
        ParticleGroupDef def{.integrator = integrator, .linear_drag = c, .collide_bodies = false};
        double error[2];
        for (int k = 0; k < 2; k++) {
            ParticleGroup group = group_of(def, {{.velocity = v0}});
            const int steps = 100 << k;
            advance(group, steps, seconds / steps, {0, -9.81, 0});
            error[k] = length(group.positions()[0] - truth);
        }
        EXPECT_NEAR(std::log2(error[0] / error[1]), expected[static_cast<int>(integrator)], 0.1)
            << static_cast<int>(integrator);
    }
}

// Each step multiplies w^2 x^2 + v^2 by a number that follows from the eigenvalues of the method,
// or conserves a quadratic form: the circle becomes a spiral, or an ellipse.
TEST(ParticleIntegrators, energy_of_the_circle_follows_the_closed_forms) {
    constexpr double h = 0.02, z = w * h;
    constexpr int steps = 200;
    const auto run = [&](ParticleIntegrator integrator) {
        ParticleGroup group = oscillator(integrator);
        advance(group, steps, h);
        return std::pair(group.positions()[0].x, group.velocities()[0].x);
    };
    const auto energy = [&](std::pair<double, double> state) {
        return state.first * state.first + state.second * state.second / (w * w);
    };
    const auto relative = [&](double value, double expected) {
        return std::abs(value / expected - 1);
    };
    EXPECT_LT(relative(energy(run(explicit_euler)), std::pow(1 + z * z, steps)), 1e-12);
    EXPECT_LT(relative(energy(run(implicit_euler)), std::pow(1 + z * z, -steps)), 1e-11);
    const double z2 = z * z;
    EXPECT_LT(relative(energy(run(runge_kutta_4)),
                       std::pow(1 - z2 * z2 * z2 / 72 + z2 * z2 * z2 * z2 / 576, steps)),
              1e-12);
    // The ellipses that the symplectic methods conserve.
    const auto [x, v] = run(semi_implicit_euler);
    EXPECT_NEAR(x * x + v * v / (w * w) - h * x * v, 1, 1e-12);
    const auto [xv, vv] = run(verlet);
    EXPECT_NEAR(xv * xv + vv * vv / (w * w) * (1 - z2 / 4), 1, 1e-12);
}

// An orbit of eccentricity 0.5 and period 1 s, 400 steps per orbit. After ten orbits the symplectic
// methods keep the energy within some per cent; explicit Euler leaves the ellipse.
TEST(ParticleIntegrators, ellipse_of_kepler) {
    constexpr double pull = w * w, e = 0.5;
    const double orbit_energy = -pull / 2;
    const auto energy_error = [&](ParticleIntegrator integrator, double orbits) {
        ParticleGroupDef def = free_of_forces(integrator);
        def.attractors = {{.strength = pull, .falloff = 2, .min_distance = 1e-3}};
        ParticleGroup group = group_of(
            def,
            {{.position = {1 - e, 0, 0}, .velocity = {0, w * std::sqrt((1 + e) / (1 - e)), 0}}});
        advance(group, static_cast<int>(400 * orbits), 1.0 / 400);
        const double energy =
            0.5 * length_squared(group.velocities()[0]) - pull / length(group.positions()[0]);
        return energy / orbit_energy - 1;
    };
    EXPECT_LT(energy_error(explicit_euler, 10), -0.3) << "a larger orbit";
    EXPECT_GT(energy_error(implicit_euler, 0.5), 0.02) << "a smaller orbit";
    EXPECT_LT(std::abs(energy_error(semi_implicit_euler, 10)), 0.05);
    EXPECT_LT(std::abs(energy_error(verlet, 10)), 1e-3);
    EXPECT_LT(std::abs(energy_error(runge_kutta_4, 10)), 1e-5);
}

ParticleGroup stiff_spring(ParticleIntegrator integrator, double stiffness, double damping) {
    ParticleGroup group =
        group_of({.integrator = integrator, .mass = 1, .gravity_scale = 0, .collide_bodies = false},
                 {{.position = {1.1, 0, 0}}});
    const ParticleSpring spring{.rest_length = 1, .stiffness = stiffness, .damping = damping};
    test::must(group.add_springs(std::span(&spring, 1)));
    return group;
}

// The explicit methods are stable up to the step h = 2 / w of a spring without damping (Verlet,
// semi-implicit Euler) and 2.83 / w (Runge-Kutta); explicit Euler is never, without damping.
TEST(ParticleIntegrators, limits_of_a_stiff_spring) {
    constexpr double stiffness = 1e4, own = 100;  // rad/s
    const auto stretch_after = [&](ParticleIntegrator integrator, double h) {
        ParticleGroup group = stiff_spring(integrator, stiffness, 0);
        advance(group, 400, h);
        return group.size() == 0 ? 1e9 : std::abs(group.positions()[0].x - 1);
    };
    for (const ParticleIntegrator symplectic : {semi_implicit_euler, verlet}) {
        EXPECT_LT(stretch_after(symplectic, 1.9 / own), 0.5);
        EXPECT_GT(stretch_after(symplectic, 2.1 / own), 1);
    }
    EXPECT_LT(stretch_after(runge_kutta_4, 2.8 / own), 0.2);
    EXPECT_GT(stretch_after(runge_kutta_4, 2.9 / own), 1);
    EXPECT_GT(stretch_after(explicit_euler, 0.5 / own), 1);
    EXPECT_LT(stretch_after(implicit_euler, 100 / own), 1e-10) << "any step is stable";
}

// Along its direction a stretched spring is linear: implicit Euler has the solution of the 2 x 2
// system to rounding, for any stiffness.
TEST(ParticleIntegrators, implicit_euler_solves_a_stiff_spring_exactly) {
    constexpr double k = 1e6, c = 30, h = 1.0 / 60;
    ParticleGroup group = stiff_spring(implicit_euler, k, c);
    double stretch = 0.1, speed = 0;
    for (int n = 0; n < 5; n++) {
        advance(group, 1, h);
        speed = (speed - h * k * stretch) / (1 + h * c + h * h * k);
        stretch += h * speed;
        EXPECT_NEAR(group.velocities()[0].x, speed, 1e-11);
        EXPECT_NEAR(group.positions()[0].x, 1 + stretch, 1e-13);
    }
}

// A rope of 40 particles and stiff springs: conjugate gradients. It keeps its length within the
// strain of its weight.
TEST(ParticleIntegrators, implicit_euler_carries_a_stiff_rope) {
    constexpr int count = 40;
    constexpr double spacing = 0.05, mass = 0.01, stiffness = 1e5;
    std::vector<ParticleStart> links;
    std::vector<ParticleSpring> springs;
    for (std::uint32_t k = 0; k < count; k++) {
        links.push_back({.position = {spacing * (k + 1), 0, 0}});
        springs.push_back({.a = k,
                           .b = k == 0 ? spring_anchor : k - 1,
                           .rest_length = spacing,
                           .stiffness = stiffness,
                           .damping = 0.5});
    }
    ParticleGroup rope = group_of({.integrator = implicit_euler,
                                   .substeps = 4,
                                   .mass = mass,
                                   .linear_drag = 5,
                                   .collide_bodies = false},
                                  links);
    test::must(rope.add_springs(springs));
    advance(rope, 60 * 5, 1.0 / 60, {0, -9.81, 0});
    const Vec3 end = rope.positions()[count - 1];
    EXPECT_LT(std::abs(end.x), 0.02);
    // The closed form of the strain: spring k from the end carries k weights.
    const double strain = mass * 9.81 / stiffness * count * (count + 1) / 2;
    EXPECT_NEAR(end.y, -(count * spacing + strain), 1e-3);
}

// Kepler's problem of two equal masses: they orbit each other, and momentum stays zero.
TEST(ParticleIntegrators, mutual_attraction_of_two_particles) {
    constexpr double mass = 2, g = 3, apart = 2;
    // Each is attracted by g m / d^2 and circles at d / 2.
    const double speed = std::sqrt(g * mass / apart / 2);
    ParticleGroup pair = group_of({.integrator = runge_kutta_4,
                                   .mass = mass,
                                   .gravity_scale = 0,
                                   .attraction = g,
                                   .softening = 1e-6,
                                   .collide_bodies = false},
                                  {{.position = {1, 0, 0}, .velocity = {0, speed, 0}},
                                   {.position = {-1, 0, 0}, .velocity = {0, -speed, 0}}});
    const double period = 2 * pi / speed;  // of the circle of 1 m
    advance(pair, 1000, period / 1000);
    EXPECT_LT(length(pair.positions()[0] - Vec3{1, 0, 0}), 1e-8);
    EXPECT_LT(length(pair.momentum()), 1e-14);
}

}  // namespace
}  // namespace jostle::modules
