// SPDX-License-Identifier: MIT
//
// Particles and the bodies of a world: impacts, impulses in both directions, sleep.
#include <gtest/gtest.h>

#include <cmath>

#include "jostle/physics/height_field.h"
#include "tests/modules/particles/with_particles.h"
#include "tests/support/random.h"

namespace jostle::modules {
namespace {

World weightless() {
    return test::make_world({.gravity = {}});
}

// Momentum, angular momentum about the origin and kinetic energy of particles and bodies.
struct Totals {
    Vec3 momentum, angular;
    double energy = 0;
};
Totals totals_of(const World& world, const ParticleGroup& group) {
    const WorldSummary sum = world.summary();
    Totals totals{sum.linear_momentum, sum.angular_momentum, sum.kinetic_energy};
    for (std::size_t k = 0; k < group.size(); k++) {
        const Vec3 p = group.velocities()[k] * group.def().mass;
        totals.momentum += p;
        totals.angular += cross(group.positions()[k], p);
    }
    totals.energy += group.kinetic_energy();
    return totals;
}

// One particle hits a free box off its centre, elastically: all three conserved.
TEST(BodyImpacts, elastic_impact_conserves_momentum_and_energy) {
    for (const double radius : {0.0, 0.1}) {
        World world = weightless();
        const BodyId box = test::add(world, {.geometry = Box{{0.5, 0.4, 0.3}}, .density = 10});
        ParticleGroup& group =
            add_group(world, {.mass = 0.5, .radius = radius, .restitution = 1, .friction = 0},
                      {{.position = {0.2, 0.1, 3}, .velocity = {0.1, -0.05, -7}}});
        const Totals before = totals_of(world, group);
        test::run(world, 0.7);
        const Totals after = totals_of(world, group);
        EXPECT_GT(length(test::velocity_of(world, box)), 0.5) << "the box was pushed";
        EXPECT_GT(group.velocities()[0].z, 0.5) << "the particle rebounds";
        EXPECT_LT(length(after.momentum - before.momentum), 1e-12 * length(before.momentum));
        EXPECT_NEAR(after.energy / before.energy, 1, 1e-6) << "the solver turns the box in float";
        EXPECT_LT(length(after.angular - before.angular), 1e-6 * length(before.angular));
    }
}

// A central impact has the closed form of two masses, to rounding.
TEST(BodyImpacts, central_impact_follows_the_closed_form) {
    World world = weightless();
    const BodyId ball = test::add(world, {.geometry = Sphere{0.5}, .density = 4});
    const double m = 0.7, mass = test::state_of(world, ball).mass;
    ParticleGroup& group = add_group(world, {.mass = m, .restitution = 1},
                                     {{.position = {0, 0, 3}, .velocity = {0, 0, -6}}});
    const double energy = group.kinetic_energy();
    test::run(world, 0.8);
    const double v = test::velocity_of(world, ball).z, u = group.velocities()[0].z;
    EXPECT_NEAR(v, -6 * 2 * m / (m + mass), 1e-12);
    EXPECT_NEAR(u, -6 * (m - mass) / (m + mass), 1e-12);
    EXPECT_NEAR((0.5 * m * u * u + 0.5 * mass * v * v) / energy, 1, 1e-12);
}

// A jet on a plate: the force is the momentum per second, rate * mass * speed for particles that
// stop. The plate is heavy, so its speed is small against the jet's.
TEST(BodyImpacts, jet_exerts_its_momentum_per_second) {
    World world = weightless();
    const BodyId plate = test::add(world, {.geometry = Box{{1, 1, 0.1}}, .density = 1000});
    const double rate = 2000, mass = 0.01, speed = 10, seconds = 2;
    ParticleGroupDef def{.count_max = 20000, .mass = mass, .restitution = 0};
    def.emitter = {.position = {0, 0, 1},
                   .direction = {0, 0, -1},
                   .rate = rate,
                   .speed = speed,
                   .lifetime = 100};
    add_group(world, def);
    test::run(world, seconds);
    const BodyState state = test::state_of(world, plate);
    const double arrived = rate * (seconds - 0.9 / speed);  // particles
    EXPECT_NEAR(-state.linear_velocity.z * (state.mass + arrived * mass), arrived * mass * speed,
                0.01 * arrived * mass * speed);
}

TEST(BodyImpacts, fast_particles_do_not_tunnel) {
    for (const double radius : {0.0, 0.02}) {
        World world = weightless();
        test::add_static(world, {.geometry = Box{{5, 5, 0.005}}});
        std::vector<ParticleStart> starts;
        test::Random random(3);
        for (int k = 0; k < 500; k++)
            starts.push_back(
                {.position = {random.in(-4, 4), random.in(-4, 4), 2},
                 .velocity = {random.in(-9, 9), random.in(-9, 9), -random.in(20, 900)}});
        ParticleGroup& group = add_group(world, {.radius = radius}, starts);
        test::run(world, 0.1);
        for (const Vec3& p : group.positions()) EXPECT_GT(p.z, 0);
    }
}

// Rain on hills and boxes: every particle rests on the ground, none below it.
TEST(BodyImpacts, particles_rest_on_height_fields_and_boxes) {
    World world = test::make_world();
    HeightGrid grid{.columns = 41, .rows = 41};
    for (int r = 0; r < 41; r++)
        for (int c = 0; c < 41; c++)
            grid.heights.push_back(0.3 * sin_cos(0.5 * c).sin * sin_cos(0.4 * r).sin);
    test::add_static(world, {.geometry = HeightField{test::must(build_height_field(grid))}});
    test::add_static(world, {.geometry = Box{{1, 1, 1}}});
    std::vector<ParticleStart> starts;
    test::Random random(4);
    for (int k = 0; k < 400; k++)
        starts.push_back({.position = {random.in(-8, 8), random.in(2, 4), random.in(-8, 8)}});
    ParticleGroup& group =
        add_group(world, {.radius = 0.05, .restitution = 0.2, .friction = 2}, starts);
    test::run(world, 5);
    int resting = 0;
    for (std::size_t k = 0; k < group.size(); k++) {
        const auto closest = test::must(world.queries().closest_point(group.positions()[k], 1));
        ASSERT_TRUE(closest.has_value()) << k;
        EXPECT_NEAR(closest->distance, 0.05, 1e-3);
        EXPECT_GT(group.positions()[k].y, -0.35);
        if (length(group.velocities()[k]) < 0.01) resting++;
    }
    EXPECT_EQ(group.size(), 400u);
    EXPECT_GT(resting, 380);
}

// A kinematic lift carries particles and a closing wall pushes them.
TEST(BodyImpacts, kinematic_bodies_carry_and_push) {
    World world = test::make_world();
    test::add(world,
              {.geometry = Box{{2, 0.1, 2}}, .velocity = {0, 1, 0}, .type = BodyType::kinematic});
    test::add(world, {.geometry = Box{{0.1, 3, 2}},
                      .position = {-2, 1.5, 0},
                      .velocity = {1, 0, 0},
                      .type = BodyType::kinematic});
    ParticleGroup& group = add_group(world, {.friction = 0},
                                     {{.position = {1.5, 0.4, 0}}, {.position = {-1, 0.3, 0}}});
    test::run(world, 1.5);
    EXPECT_NEAR(group.positions()[0].y, 1.6, 1e-3);
    EXPECT_NEAR(group.velocities()[0].y, 1, 1e-9);
    EXPECT_GE(group.positions()[1].x, -0.4 - 1e-6);
}

// The weight of particles at rest on a scale.
TEST(BodyImpacts, sleeping_body_wakes_only_for_noticeable_impulses) {
    World world = test::make_world();
    test::add_floor(world);
    const BodyId box = test::add(world, {.position = {0, 0.5, 0}, .density = 100});
    test::run(world, 3);
    ASSERT_FALSE(test::state_of(world, box).awake);
    ParticleGroup& group = add_group(world, {.mass = 0.01, .restitution = 0},
                                     {{.position = {0, 2, 0}, .velocity = {0, -5, 0}}});
    test::run(world, 1);
    EXPECT_FALSE(test::state_of(world, box).awake) << "0.06 N s on 100 kg";
    EXPECT_NEAR(group.positions()[0].y, 1, 1e-3);
    test::must(group.add(
        std::vector<ParticleStart>(1, {.position = {0, 2, 0}, .velocity = {0, -500, 0}})));
    test::must(world.step(1.0 / 60));
    EXPECT_TRUE(test::state_of(world, box).awake) << "5 N s on 100 kg";
}

TEST(BodyImpacts, categories_select_shapes) {
    World world = weightless();
    const BodyId wall = test::add_static(world, {.geometry = Box{{5, 5, 0.1}}});
    test::must(world.set_filter(world.shapes_of(wall)[0], {.category = 4}));
    const std::vector<ParticleStart> start = {{.position = {0, 0, 1}, .velocity = {0, 0, -10}}};
    add_group(world, {.body_categories = 4}, start);
    add_group(world, {.body_categories = 2}, start);
    add_group(world, {.collide_bodies = false}, start);
    test::run(world, 0.5);
    const auto z = [&](std::size_t k) {
        const Particles& module = particles_of(world);
        return module.group(module.groups()[k])->positions()[0].z;
    };
    EXPECT_GT(z(0), 0.1);
    EXPECT_NEAR(z(1), -4, 1e-9);
    EXPECT_NEAR(z(2), -4, 1e-9);
}

// A planar world: everything stays in the xy plane, and bodies are pushed within it.
TEST(BodyImpacts, planar_particles_stay_in_the_plane) {
    World world = test::make_world({.planar = true});
    test::add_floor(world);
    const BodyId box = test::add(world, {.position = {0.8, 0.5, 0}, .density = 1});
    ParticleGroupDef def{
        .count_max = 5000, .mass = 0.02, .radius = 0.02, .collide_particles = true, .planar = true};
    def.emitter = {.shape = EmitterShape::sphere,
                   .position = {-1, 0.5, 0},
                   .direction = {1, 0.2, 0.7},
                   .rate = 300,
                   .speed = 5,
                   .cone = 0.3,
                   .lifetime = 4};
    ParticleGroup& group = add_group(world, def);
    test::run(world, 2);
    EXPECT_EQ(group.size(), 600u);
    for (std::size_t k = 0; k < group.size(); k++) {
        ASSERT_EQ(group.positions()[k].z, 0);
        ASSERT_EQ(group.velocities()[k].z, 0);
        ASSERT_GT(group.positions()[k].y, -0.02) << "the jet presses them into the floor";
    }
    EXPECT_GT(test::position_of(world, box).x, 0.85) << "the jet pushes the box";
}

// Fields of the world: a radial field, a vortex, and a wind that drags.
TEST(BodyImpacts, fields_of_the_world_act_on_particles) {
    World world = weightless();
    test::must(world.create_field({.force = UniformWind{.velocity = {3, 0, 0}}}));
    test::must(world.create_field(
        {.force = RadialField{.center = {0, 0, 0}, .strength = -2, .falloff = 0, .per_mass = true},
         .region = Aabb{{-1, -1, 9}, {1, 1, 11}}}));
    ParticleGroup& group = add_group(world, {.linear_drag = 5, .world_fields = true},
                                     {{.position = {0, 0, 0}}, {.position = {0, 0, 10}}});
    test::run(world, 0.5);
    const double x = 3 * (1 - std::exp(-2.5));
    EXPECT_NEAR(group.velocities()[0].x, x, 1e-3);
    EXPECT_EQ(group.velocities()[0].z, 0);
    EXPECT_NEAR(group.velocities()[1].z, -2.0 / 5 * (1 - std::exp(-2.5)), 1e-3);
}

}  // namespace
}  // namespace jostle::modules
