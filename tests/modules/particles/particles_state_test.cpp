// SPDX-License-Identifier: MIT
//
// Particles are state: bit-identical for any number of threads and instruction set, and after
// saving, loading and restoring. Untrusted bytes are checked.
#include <gtest/gtest.h>

#include "jostle/physics/instruction_set.h"
#include "tests/modules/module_determinism.h"
#include "tests/modules/particles/with_particles.h"
#include "tests/support/random.h"

namespace jostle::modules {
namespace {

// Every feature at once: a fountain over bodies, balls that hit each other, a rope, a cloud.
World lively(int threads) {
    World world = test::make_world({.threads = threads});
    test::add_floor(world);
    test::Random random(5);
    for (int k = 0; k < 12; k++)
        test::add(world,
                  {.geometry = k % 2 == 0 ? Geometry(Box{{0.3, 0.2, 0.25}}) : Geometry(Sphere{0.3}),
                   .position = {0.8 * (k % 4) - 1.2, 0.4 + 0.8 * (k / 4), 0.3 * (k % 3)},
                   .rotation = random.rotation(),
                   .density = 60});
    test::must(world.create_field({.force = UniformWind{.velocity = {1, 0, 0}}}));
    ParticleGroupDef water{.count_max = 3000, .mass = 0.01, .world_fields = true};
    water.linear_drag = 0.2;
    water.emitter = {.position = {-2, 0.5, 0},
                     .direction = {1, 1, 0},
                     .rate = 900,
                     .speed = 6,
                     .speed_spread = 0.2,
                     .cone = 0.2,
                     .lifetime = 2,
                     .lifetime_spread = 0.3};
    water.flow = {.speed = 1, .walls = {{}}};
    add_group(world, water);
    ParticleGroupDef hail{.substeps = 2, .count_max = 500, .mass = 0.05, .radius = 0.06};
    hail.collide_particles = true;
    hail.emitter = {.shape = EmitterShape::box,
                    .position = {0, 3, 0},
                    .half_extents = {1, 0.2, 1},
                    .rate = 200,
                    .burst = 60,
                    .speed = 0,
                    .lifetime = 5};
    add_group(world, hail);
    std::vector<ParticleStart> links;
    std::vector<ParticleSpring> springs;
    for (std::uint32_t k = 0; k < 30; k++) {
        links.push_back({.position = {2 + 0.05 * k, 3, 0}, .lifetime = k == 20 ? 0.6 : 0});
        springs.push_back({.a = k,
                           .b = k == 0 ? spring_anchor : k - 1,
                           .anchor = {2, 3, 0},
                           .rest_length = 0.05,
                           .stiffness = 500,
                           .damping = 0.1});
    }
    test::must(
        add_group(world, {.integrator = ParticleIntegrator::implicit_euler, .mass = 0.01}, links)
            .add_springs(springs));
    std::vector<ParticleStart> stars;
    for (int k = 0; k < 200; k++) stars.push_back({.position = random.vector(1) + Vec3{0, 6, 0}});
    add_group(world,
              {.integrator = ParticleIntegrator::runge_kutta_4,
               .mass = 1,
               .gravity_scale = 0,
               .attraction = 0.01,
               .collide_bodies = false},
              stars);
    return world;
}

TEST(ParticlesState, has_work_for_all_parts) {
    World world = lively(1);
    test::run(world, 1.2);
    EXPECT_GT(particles_of(world).group(particles_of(world).groups()[0])->size(), 900u);
}

TEST(ParticlesState, result_is_bit_identical_for_any_thread_count) {
    test::expect_same_for_threads(lively, 1.2);
}

TEST(ParticlesState, result_is_bit_identical_for_any_instruction_set) {
    test::expect_same_for_instruction_sets(lively, 0.8);
}

TEST(ParticlesState, continues_bit_identically_after_load_and_restore) {
    test::expect_continues(lively, 0.5, 0.7);
}

TEST(ParticlesState, every_number_is_part_of_the_state) {
    World a = lively(1), b = lively(1);
    Particles& module = particles_of(b);
    const ParticleKey key = module.groups()[1];
    ParticleGroupDef def = module.group(key)->def();
    def.friction += 1e-9;
    test::must(module.set(key, def));
    EXPECT_NE(state_hash(a), state_hash(b));
    const auto difference = first_difference(a, b);
    ASSERT_TRUE(difference.has_value());
    EXPECT_NE(difference->find("particles.state.groups[1].def.friction"), std::string::npos)
        << *difference;
}

TEST(ParticlesState, rejects_corrupted_bytes) {
    World world = lively(1);
    test::run(world, 0.1);
    const std::vector<std::byte> good = save_module(particles_of(world));
    Particles copy;
    ASSERT_TRUE(load_module(copy, good).ok());
    EXPECT_EQ(save_module(copy), good);
    test::Random random(6);
    int refused = 0, taken = 0;
    for (int k = 0; k < 3000; k++) {
        std::vector<std::byte> corrupted = good;
        for (std::uint64_t n = 0; n <= random.below(3); n++) {
            // Half of the changes hit the first definition, with its counts.
            const std::size_t span = random.below(2) == 0 ? 900 : corrupted.size();
            corrupted[random.below(span)] = static_cast<std::byte>(random.below(256));
        }
        if (random.below(10) == 0) corrupted.resize(random.below(corrupted.size()));
        auto victim = std::make_unique<Particles>();
        const Status status = load_module(*victim, corrupted);
        status.ok() ? taken++ : refused++;
        if (!status.ok()) continue;
        ASSERT_EQ(save_module(*victim), corrupted) << "accepted values are in range";
        if (taken % 20 != 0) continue;
        World other = test::make_world();
        test::add_floor(other);
        test::must(other.add_module(std::move(victim)));
        test::must(other.step(1.0 / 60));
        test::must(other.step(1.0 / 60));
        test::must(load(save(other)));
    }
    RecordProperty("refused", refused);
    RecordProperty("taken", taken);
    EXPECT_GT(refused, 300);
    EXPECT_GT(taken, 300);
}

TEST(ParticlesState, limits_are_errors) {
    World world = test::make_world();
    Particles& module = particles_of(world);
    for (int k = 0; k < 10; k++) test::must(module.add(world, {.count_max = 100000}));
    EXPECT_EQ(module.work(), 10 * 1e5 * 3.5);
    test::must(module.add(world, {.substeps = 5, .count_max = 28571}));
    EXPECT_EQ(module.add(world, {.count_max = 10}).error().message,
              "the groups need 4000027 units of work per step; the maximum is 4000000; reduce "
              "count_max, substeps or flow.octaves");
    EXPECT_EQ(module.set(module.groups()[0], {.substeps = 64}).ok(), true) << "1000 particles";
    EXPECT_FALSE(module.set(module.groups()[0], {.substeps = 64, .count_max = 100000}).ok());
    EXPECT_EQ(module.remove({99}).error().code, ErrorCode::not_found);
    test::must(module.remove(module.groups()[0]));
    ParticleGroup& group = *module.group(test::must(module.add(world, {.count_max = 2})));
    EXPECT_EQ(group.add(std::vector<ParticleStart>(3)).error().code, ErrorCode::resource_exhausted);
    EXPECT_EQ(group.add(std::vector<ParticleStart>(1, {.position = {2e7, 0, 0}})).error().code,
              ErrorCode::invalid_argument);
    const ParticleSpring wrong{.a = 0};
    EXPECT_EQ(group.add_springs(std::span(&wrong, 1)).error().message.substr(0, 10), "springs[0]");
    EXPECT_EQ(group.size(), 0u);
}

// Settings at the limits of their ranges: particles that leave the range of numbers are removed.
TEST(ParticlesState, extreme_forces_remove_particles_and_nothing_else) {
    for (const ParticleIntegrator integrator :
         {ParticleIntegrator::explicit_euler, ParticleIntegrator::semi_implicit_euler,
          ParticleIntegrator::implicit_euler, ParticleIntegrator::verlet,
          ParticleIntegrator::runge_kutta_4}) {
        World world = test::make_world();
        const BodyId box = test::add(world, {.position = {0, 1, 0}});
        test::add_floor(world);
        ParticleGroupDef def{.integrator = integrator, .mass = 1e-9, .linear_drag = 1e6};
        def.quadratic_drag = 1e6;
        def.attraction = 1e12;
        def.attractors = {{.strength = 1e9, .falloff = 4, .min_distance = 1e-6},
                          {.strength = -1e9, .falloff = -1}};
        def.flow = {.wind = {1e4, -1e4, 0}, .speed = 1e3, .scale = 0.01, .rate = 1e3};
        def.emitter = {.rate = 3000, .burst = 50, .speed = 1e4, .cone = 3};
        ParticleGroup& group = add_group(world, def);
        for (int k = 0; k < 20; k++) {
            test::must(world.step(1.0 / 60));
            for (const Vec3& p : group.positions()) ASSERT_TRUE(is_finite(p));
        }
        EXPECT_TRUE(is_finite(test::position_of(world, box)));
    }
}

}  // namespace
}  // namespace jostle::modules
