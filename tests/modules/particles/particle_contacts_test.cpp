// SPDX-License-Identifier: MIT
//
// Impacts of particles with each other and with planes.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/modules/particles/with_particles.h"
#include "tests/support/random.h"

namespace jostle::modules {
namespace {

ParticleGroupDef balls(double radius, double restitution) {
    return {.count_max = 20000,
            .mass = 0.3,
            .radius = radius,
            .collide_particles = true,
            .restitution = restitution};
}

// Exchange of the normal velocities at the moment of contact, which is within a step.
TEST(ParticleContacts, elastic_pair_follows_the_closed_form) {
    test::Random random(1);
    for (int k = 0; k < 200; k++) {
        const double radius = random.in(0.05, 0.5);
        const Vec3 n = random.direction();  // from a to b, at the contact
        const Vec3 va = random.vector(2), vb = random.vector(2);
        const double approach = dot(va - vb, n);
        if (approach < 0.2) continue;
        const double h = 0.3 * radius / approach, seconds = 3.4 * h;  // the impact after 3.4 steps
        const Vec3 at = random.vector(3);
        ParticleGroup pair = group_of(
            balls(radius, 1), {{.position = at - n * radius - va * seconds, .velocity = va},
                               {.position = at + n * radius - vb * seconds, .velocity = vb}});
        const double energy = pair.kinetic_energy();
        const Vec3 momentum = pair.momentum();
        advance(pair, 6, h);
        EXPECT_NEAR(pair.kinetic_energy() / energy, 1, 1e-12);
        EXPECT_LT(length(pair.momentum() - momentum), 1e-12 * length(momentum));
        const Vec3 change = n * approach;
        EXPECT_LT(length(pair.velocities()[0] - (va - change)), 1e-9);
        EXPECT_LT(length(pair.velocities()[1] - (vb + change)), 1e-9);
        const double rest = 6 * h - seconds;
        EXPECT_LT(length(pair.positions()[0] - (at - n * radius + (va - change) * rest)), 1e-9);
        EXPECT_LT(length(pair.positions()[1] - (at + n * radius + (vb + change) * rest)), 1e-9);
    }
}

// A gas: many simultaneous impacts keep momentum and energy.
TEST(ParticleContacts, gas_keeps_momentum_and_energy) {
    test::Random random(2);
    std::vector<ParticleStart> starts;
    for (int k = 0; k < 2000; k++)
        starts.push_back({.position = random.vector(1), .velocity = random.vector(3)});
    ParticleGroup gas = group_of(balls(0.03, 1), starts);
    const double energy = gas.kinetic_energy();
    const Vec3 momentum = gas.momentum();
    Vec3 first = gas.velocities()[0];
    advance(gas, 60, 1.0 / 240);
    RecordProperty("energy_error", std::to_string((gas.kinetic_energy() / energy - 1) * 1e15));
    EXPECT_NEAR(gas.kinetic_energy() / energy, 1, 1e-12);
    EXPECT_LT(length(gas.momentum() - momentum), 1e-12 * 2000 * 0.3);
    EXPECT_NE(gas.velocities()[0], first) << "it was hit";
}

// Newton's law of restitution between two particles.
TEST(ParticleContacts, restitution_is_that_of_the_group) {
    for (const double e : {0.0, 0.4, 0.9}) {
        ParticleGroup pair =
            group_of(balls(0.1, e), {{.position = {-1, 0, 0}, .velocity = {5, 0, 0}},
                                     {.position = {1, 0, 0}, .velocity = {-3, 0, 0}}});
        advance(pair, 60, 1.0 / 120);
        EXPECT_NEAR((pair.velocities()[1] - pair.velocities()[0]).x, 8 * e, 1e-12);
    }
}

TEST(ParticleContacts, particles_bounce_off_planes_elastically) {
    ParticleGroupDef def{.radius = 0.1, .collide_bodies = false, .restitution = 1, .friction = 0};
    def.planes = {{.normal = {0, 2, 0}, .offset = -1}};
    ParticleGroup ball = group_of(def, {{.position = {0, 1, 0}, .velocity = {2, -3, 0}}});
    advance(ball, 100, 0.01);
    // It hits the plane after (1 - 0.1 + 1) / 3 s.
    const double rest = 1 - 1.9 / 3;
    EXPECT_LT(length(ball.positions()[0] - Vec3{2, -0.9 + 3 * rest, 0}), 1e-12);
    EXPECT_LT(length(ball.velocities()[0] - Vec3{2, 3, 0}), 1e-12);
}

// Under gravity, an elastic ball returns to its height.
TEST(ParticleContacts, elastic_ball_keeps_its_height) {
    ParticleGroupDef def{.collide_bodies = false, .restitution = 1};
    def.planes = {{.offset = 0}};
    ParticleGroup ball = group_of(def, {{.position = {0, 1, 0}}});
    double top = 0;
    for (int k = 0; k < 60 * 60; k++) {
        ball.advance({.gravity = {0, -9.81, 0}}, k / 60.0, (k + 1) / 60.0);
        const double height = ball.positions()[0].y;
        const double speed = ball.velocities()[0].y;
        top = height + speed * speed / (2 * 9.81);
        ASSERT_GT(height, -1e-12);
    }
    RecordProperty("height_after_66_bounces", std::to_string(top));
    EXPECT_NEAR(top, 1, 0.02);
}

// Friction on an incline: Coulomb's law. Particles on a plane of 30 degrees stay with friction 0.7
// and slide with g (sin - mu cos) with friction 0.2.
TEST(ParticleContacts, friction_on_an_incline) {
    const double angle = pi / 6;
    const Vec3 normal{std::sin(angle), std::cos(angle), 0},
        down{std::cos(angle), -std::sin(angle), 0};
    for (const double friction : {0.7, 0.2}) {
        ParticleGroupDef def{
            .radius = 0.05, .collide_bodies = false, .restitution = 0, .friction = friction};
        def.planes = {{.normal = normal}};
        ParticleGroup ball = group_of(def, {{.position = normal * 0.05}});
        advance(ball, 120, 1.0 / 60, {0, -9.81, 0});
        const double acceleration =
            maximum(9.81 * (std::sin(angle) - friction * std::cos(angle)), 0);
        EXPECT_NEAR(dot(ball.velocities()[0], down), 2 * acceleration, 0.01) << friction;
        EXPECT_NEAR(dot(ball.positions()[0], normal), 0.05, 1e-9);
        if (friction > 0.6) {
            EXPECT_LT(dot(ball.positions()[0], down), 1e-3);
        }
    }
}

// A heap of 300 balls, four deep, on a plane between walls comes to rest. Deeper heaps keep
// residual velocities, because the sweeps of a substep do not reach the ground.
TEST(ParticleContacts, heap_comes_to_rest) {
    ParticleGroupDef def = balls(0.05, 0.2);
    def.friction = 0.5;
    def.substeps = 4;
    def.planes = {{}, {{1, 0, 0}, -0.5}, {{-1, 0, 0}, -0.5}, {{0, 0, 1}, -0.5}, {{0, 0, -1}, -0.5}};
    std::vector<ParticleStart> starts;
    for (int k = 0; k < 300; k++)
        starts.push_back({.position = {0.11 * (k % 8) - 0.4 + 0.003 * (k % 3),
                                       0.1 + 0.12 * (k / 64), 0.11 * (k / 8 % 8) - 0.4}});
    ParticleGroup heap = group_of(def, starts);
    advance(heap, 60 * 4, 1.0 / 60, {0, -9.81, 0});
    EXPECT_EQ(heap.size(), 300u);
    double closest = 1, deepest = 0;
    for (std::size_t a = 0; a < 300; a++) {
        deepest = maximum(deepest, 0.05 - heap.positions()[a].y);
        for (std::size_t b = 0; b < a; b++)
            closest = minimum(closest, length(heap.positions()[a] - heap.positions()[b]));
    }
    const double speed = std::sqrt(2 * heap.kinetic_energy() / (0.3 * 300));
    RecordProperty("closest", std::to_string(closest));
    RecordProperty("rms_speed", std::to_string(speed));
    EXPECT_GT(closest, 0.099);
    EXPECT_LT(deepest, 1e-6);
    EXPECT_LT(speed, 0.05);
}

// Many particles in one place are bounded work: each is tested with a limited number of others.
TEST(ParticleContacts, crowd_in_one_place_is_bounded) {
    ParticleGroup crowd = group_of(balls(0.5, 0.5), std::vector<ParticleStart>(20000));
    advance(crowd, 2, 1.0 / 60);
    EXPECT_EQ(crowd.size(), 20000u);
    for (const Vec3& p : crowd.positions()) ASSERT_TRUE(is_finite(p));
}

}  // namespace
}  // namespace jostle::modules
