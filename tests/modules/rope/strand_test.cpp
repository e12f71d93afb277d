// SPDX-License-Identifier: MIT
//
// Strands against closed forms: lengths, sags, frequencies, energies and friction.
#include "modules/rope/src/strand.h"

#include <gtest/gtest.h>

#include <cmath>

namespace jostle::modules::rope_detail {
namespace {

using physics::Vec3;

constexpr double h = 1.0 / 480, g = 9.81;
const Vec3 gravity{0, -g, 0};

Strand straight(std::size_t links, Vec3 from, Vec3 to, double mass) {
    Strand s;
    const double length = physics::length(to - from);
    for (std::size_t i = 0; i <= links; i++)
        s.positions.push_back(from +
                              (to - from) * (static_cast<double>(i) / static_cast<double>(links)));
    s.velocities.resize(links + 1);
    s.rest_lengths.assign(links, length / static_cast<double>(links));
    s.force_densities.assign(links, 0);
    s.mass_per_length = mass / length;
    return s;
}

// Advances with damping of the velocities by `damping` (1/s).
void run(Strand& s, SubstepInput input, double seconds, double damping = 0) {
    StrandScratch scratch;
    const auto steps = static_cast<int>(std::lround(seconds / input.h));
    for (int n = 0; n < steps; n++) {
        advance_strand(s, input, scratch);
        for (Vec3& v : s.velocities) v *= 1 / (1 + damping * input.h);
    }
}

double length_of(const Strand& s) {
    double sum = 0;
    for (std::size_t k = 0; k < s.links(); k++) sum += length(s.positions[k + 1] - s.positions[k]);
    return sum;
}

TEST(Strand, stretches_by_less_than_0_1_percent_under_ten_times_its_mass) {
    Strand s = straight(100, {}, {0, -10, 0}, 1);
    NodeLoad loads[2] = {{.node = 0, .fixed = true}, {.node = 100, .mass = scalar_matrix(10)}};
    StrandScratch scratch;
    Vec3 weight = s.positions[100], velocity;
    double most = 0;
    for (int n = 0; n < 4800; n++) {
        loads[1].target = weight + velocity * h + gravity * (h * h);
        const SubstepInput input{.h = h, .gravity = gravity, .loads = loads};
        advance_strand(s, input, scratch);
        velocity = velocity + gravity * h + loads[1].impulse * 0.1;
        weight += velocity * h;
        most = std::max(most, length_of(s) / 10 - 1);
    }
    // The elastic stretch is (10 kg + half of 1 kg) g / E A = 1.03e-4.
    EXPECT_NEAR(length_of(s) / 10 - 1, 10.5 * g / s.stretch_stiffness, 2e-6);
    EXPECT_LT(most, 1e-3);
    EXPECT_NEAR(s.force_densities[99] * s.rest_lengths[99], 10 * g, 0.01 * 10 * g);
}

TEST(Strand, hangs_as_the_catenary) {
    // Span 8 m, length 10 m: sinh(x) / x = 1.25 for x = span / 2a.
    double x = 1;
    for (int k = 0; k < 50; k++) x -= (std::sinh(x) - 1.25 * x) / (std::cosh(x) - 1.25);
    const double a = 4 / x, sag = a * (std::cosh(x) - 1);
    const double tension = 1.0 / 10 * g * a * std::cosh(x);  // 1 kg, at the ends
    Strand s = straight(100, {}, {10, 0, 0}, 1);
    // Starts as a V of the right span.
    for (std::size_t i = 0; i <= 100; i++) {
        const double t = static_cast<double>(i) / 100;
        s.positions[i] = {8 * t, -3 * (1 - std::abs(2 * t - 1)), 0};
    }
    NodeLoad loads[2] = {{.node = 0, .fixed = true},
                         {.node = 100, .fixed = true, .target = {8, 0, 0}}};
    run(s, {.h = h, .gravity = gravity, .loads = loads}, 20, 2);
    EXPECT_NEAR(-s.positions[50].y, sag, 0.005 * sag);
    EXPECT_NEAR(length(loads[0].impulse) / h, tension, 0.005 * tension);
}

TEST(Strand, swings_as_a_pendulum_and_keeps_its_energy) {
    // A rod of one link with the mass at its end.
    Strand s = straight(1, {}, {1, 0, 0}, 2);  // 1 kg at the end
    NodeLoad loads[1] = {{.node = 0, .fixed = true}};
    StrandScratch scratch;
    const SubstepInput input{.h = h, .gravity = gravity, .loads = loads};
    double least = 1e9, most = -1e9;
    for (int n = 0; n < 480 * 20; n++) {
        const double before = s.positions[1].y;
        advance_strand(s, input, scratch);
        // Velocities belong to the middle of the sub-step.
        const double height = 0.5 * (before + s.positions[1].y);
        const double energy = 0.5 * length_squared(s.velocities[1]) + g * height;
        least = std::min(least, energy), most = std::max(most, energy);
    }
    EXPECT_LT(most - least, 0.005 * g);
}

TEST(Strand, vibrates_as_a_string) {
    // Transverse modes have f = sqrt(T / (m / L)) / 2L: T = 40 N, 0.1 kg/m, 2 m: 5 Hz.
    Strand s = straight(64, {}, {2, 0, 0}, 0.2);
    s.stretch_stiffness = 4e4;
    for (std::size_t i = 0; i <= 64; i++) {
        s.positions[i].x *= 1 + 40 / s.stretch_stiffness;
        s.velocities[i].y = 0.02 * std::sin(physics::pi * static_cast<double>(i) / 64);
    }
    for (double& q : s.force_densities) q = 40 / s.rest_lengths[0];
    const Vec3 end = s.positions[64];
    NodeLoad loads[2] = {{.node = 0, .fixed = true}, {.node = 64, .fixed = true, .target = end}};
    StrandScratch scratch;
    const SubstepInput input{.h = h, .loads = loads};
    int crossings = 0;
    double first = 0, last = 0, peak = 0;
    double before = 0;
    for (int n = 1; n <= 480 * 4; n++) {
        advance_strand(s, input, scratch);
        const double y = s.positions[32].y;
        if (n > 3.5 * 480) peak = std::max(peak, std::abs(y));
        if (before < 0 && y >= 0) {
            last = (n - y / (y - before)) * h;
            if (crossings++ == 0) first = last;
        }
        before = y;
    }
    EXPECT_NEAR((crossings - 1) / (last - first), 5, 0.01);
    // The amplitude is v / omega = 0.02 / (2 pi 5); it decays by less than a tenth in 20 periods.
    EXPECT_GT(peak, 0.9 * 0.02 / (2 * physics::pi * 5));
}

TEST(Strand, bends_as_an_euler_bernoulli_cantilever) {
    for (const std::size_t links : {10u, 40u}) {
        Strand s = straight(links, {}, {1, 0, 0}, 0.1);
        s.bending_stiffness = 2;
        // Deflection at the end under its own weight: w L^4 / 8 E I.
        const double deflection = 0.1 * g / (8 * 2.0);
        NodeLoad loads[1] = {{.node = 0, .fixed = true}};
        Clamp clamps[1] = {{.direction = {1, 0, 0}}};
        run(s, {.h = h, .gravity = gravity, .loads = loads, .clamps = clamps}, 5, 20);
        EXPECT_NEAR(-s.positions.back().y, deflection, 0.01 * deflection) << links;
        EXPECT_NEAR(loads[0].impulse.y / h, -0.1 * g, 1e-3 * g);
        EXPECT_NEAR(clamps[0].moment.z / h, -0.1 * g * 0.5, 0.02 * 0.1 * g * 0.5) << links;
    }
}

TEST(Strand, vibrates_as_a_cantilever) {
    // First mode: omega = 1.8751^2 sqrt(E I / (m / L)) / L^2 = 3.516 sqrt(2 / 0.1) = 15.72 rad/s.
    Strand s = straight(40, {}, {1, 0, 0}, 0.1);
    s.bending_stiffness = 2;
    for (std::size_t i = 0; i <= 40; i++) {
        const double x = s.positions[i].x;
        s.velocities[i].y = 0.2 * x * x * (6 - 4 * x + x * x) / 3;
    }
    NodeLoad loads[1] = {{.node = 0, .fixed = true}};
    Clamp clamps[1] = {{.direction = {1, 0, 0}}};
    StrandScratch scratch;
    const SubstepInput input{.h = h, .loads = loads, .clamps = clamps};
    int crossings = 0;
    double first = 0, last = 0, before = 0;
    for (int n = 1; n <= 480 * 3; n++) {
        advance_strand(s, input, scratch);
        const double y = s.positions[40].y;
        if (before < 0 && y >= 0) {
            last = (n - y / (y - before)) * h;
            if (crossings++ == 0) first = last;
        }
        before = y;
    }
    EXPECT_NEAR(2 * physics::pi * (crossings - 1) / (last - first), 15.72, 0.01 * 15.72);
}

TEST(Strand, conserves_momentum_and_angular_momentum) {
    Strand s = straight(20, {}, {2, 0, 0}, 1);
    s.bending_stiffness = 0.5;
    for (std::size_t i = 0; i <= 20; i++) {
        const double t = static_cast<double>(i);
        s.velocities[i] = {0.5 * std::sin(t), std::cos(0.7 * t), 0.2 * t - 2};
    }
    const auto momentum = [&](Vec3& linear, Vec3& angular) {
        linear = angular = {};
        for (std::size_t i = 0; i <= 20; i++) {
            linear += s.velocities[i] * node_mass(s, i);
            angular += cross(s.positions[i], s.velocities[i]) * node_mass(s, i);
        }
    };
    Vec3 before, angular_before, after, angular_after;
    momentum(before, angular_before);
    run(s, {.h = h}, 2);
    momentum(after, angular_after);
    EXPECT_LT(length(after - before), 1e-10);
    EXPECT_LT(length(angular_after - angular_before), 0.05 * length(angular_before));
}

TEST(Strand, stays_stable_under_any_tension) {
    // The fastest transverse vibration is far beyond what sub-steps resolve.
    for (const double load : {1.0, 100.0, 1e4}) {
        Strand s = straight(100, {}, {0, -1, 0}, 0.01);
        s.stretch_stiffness = 1e8;
        for (std::size_t i = 0; i <= 100; i++)
            s.velocities[i].x = std::sin(3.0 * static_cast<double>(i));
        NodeLoad loads[2] = {{.node = 0, .fixed = true},
                             {.node = 100, .mass = scalar_matrix(load)}};
        StrandScratch scratch;
        Vec3 weight = s.positions[100], velocity;
        for (int n = 0; n < 2000; n++) {
            loads[1].target = weight + velocity * h + gravity * (h * h);
            const SubstepInput input{.h = h, .gravity = gravity, .loads = loads};
            advance_strand(s, input, scratch);
            velocity = velocity + gravity * h + loads[1].impulse * (1 / load);
            weight += velocity * h;
        }
        for (std::size_t i = 0; i <= 100; i++)
            EXPECT_LT(length(s.velocities[i]), 2) << load << " " << i;
        EXPECT_NEAR(length_of(s), 1, 0.005) << load;
    }
}

// A strand over a fixed cylinder of radius 0.5 m, pulled by two weights.
double slipping_ratio(double friction, double ratio, double seconds) {
    const double radius = 0.5;
    const std::size_t links = 120;
    Strand s;
    // From the left end up, over the top (half a turn), down to the right end.
    const double side = 2, arc = physics::pi * radius, total = 2 * side + arc;
    for (std::size_t i = 0; i <= links; i++) {
        const double at = total * static_cast<double>(i) / static_cast<double>(links);
        if (at < side)
            s.positions.push_back({-radius, at - side, 0});
        else if (at < side + arc) {
            const double angle = (at - side) / radius;
            s.positions.push_back({-radius * std::cos(angle), radius * std::sin(angle), 0});
        } else
            s.positions.push_back({radius, -(at - side - arc), 0});
    }
    s.velocities.resize(links + 1);
    for (std::size_t k = 0; k < links; k++)
        s.rest_lengths.push_back(length(s.positions[k + 1] - s.positions[k]));
    s.force_densities.assign(links, 0);
    s.mass_per_length = 0.1;
    const double light = 10, heavy = ratio * light;
    NodeLoad loads[2] = {{.node = 0, .mass = scalar_matrix(light)},
                         {.node = links, .mass = scalar_matrix(heavy)}};
    Vec3 at[2] = {s.positions.front(), s.positions.back()}, v[2];
    const double mass[2] = {light, heavy};
    StrandScratch scratch;
    std::vector<StrandContact> contacts, last;
    const auto steps = static_cast<int>(seconds / h);
    double start = 0;
    for (int n = 0; n < steps; n++) {
        std::swap(contacts, last);
        contacts.clear();
        for (std::uint32_t k = 0; k < links; k++) {
            const Vec3 p = s.positions[k];
            const double r = std::hypot(p.x, p.y);
            if (p.y > -0.05 && r < radius + 0.05)
                contacts.push_back({.link = k,
                                    .normal = Vec3{p.x / r, p.y / r, 0},
                                    .gap = r - radius,
                                    .friction = friction});
        }
        for (StrandContact& contact : contacts)
            for (const StrandContact& old : last)
                if (old.link == contact.link) {
                    contact.grip = old.grip;
                    contact.slip = old.slip;
                    contact.pressure = old.pressure;
                }
        for (int e = 0; e < 2; e++) loads[e].target = at[e] + v[e] * h + gravity * (h * h);
        const SubstepInput input{.h = h, .loads = loads, .contacts = contacts};
        advance_strand(s, input, scratch);
        for (int e = 0; e < 2; e++) {
            v[e] = v[e] + gravity * h + loads[e].impulse * (1 / mass[e]);
            at[e] += v[e] * h;
        }
        if (n == steps / 2) start = v[1].y;
    }
    // Acceleration of the heavy side, downwards.
    const double acceleration = (start - v[1].y) / (0.5 * seconds);
    // Tensions: light (g + a) and heavy (g - a).
    return heavy * (g - acceleration) / (light * (g + acceleration));
}

TEST(Strand, slips_over_a_cylinder_as_a_capstan) {
    for (const double friction : {0.1, 0.2, 0.3}) {
        const double expected = std::exp(friction * physics::pi);
        EXPECT_NEAR(slipping_ratio(friction, 4, 0.5), expected, 0.05 * expected) << friction;
    }
}

TEST(Strand, sticks_on_a_cylinder_below_the_capstan_ratio) {
    // e^(0.3 pi) = 2.57: a ratio of 2.3 holds, so both weights stay at rest.
    EXPECT_NEAR(slipping_ratio(0.3, 2.3, 0.5), 2.3, 0.02);
}

}  // namespace
}  // namespace jostle::modules::rope_detail
