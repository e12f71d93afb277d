// SPDX-License-Identifier: MIT
//
// Splits conserve mass and momentum, balls break through walls, and intact walls cost nothing.
#include <gtest/gtest.h>
#include <time.h>

#include <algorithm>
#include <cmath>

#include "tests/modules/destruction/walls.h"

namespace jostle::modules {
namespace {

using namespace physics;

double cpu_ms() {
    timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) * 1e3 + static_cast<double>(t.tv_nsec) * 1e-6;
}

double mass_of(const World& world) {
    double mass = 0;
    for (const BodyId id : world.bodies()) mass += world.body(id)->mass;
    return mass;
}

// Splits a moving and rotating body step by step.
TEST(Destruction, split_conserves_mass_and_momentum) {
    Stage stage({.gravity = {}});
    const Vec3 half{1, 0.7, 0.5};
    const DestructibleId id = stage.add(
        fracture_box(half, random_seeds(half, 120, 9)).value(),
        {.pose = {.position = {30, 4, -7}, .rotation = from_rotation_vector({0.3, 1, 0.2})},
         .linear_velocity = {3, -2, 5},
         .angular_velocity = {1.5, 0.4, -2},
         .bonds = {.tensile = 1e12, .shear = 1e12, .compressive = 1e12}});
    stage.destruction->break_near(stage.world, id, {30, 4, -7}, 0.4).value();
    const double mass = mass_of(stage.world);
    const WorldSummary before = stage.world.summary();
    // Only the split: calls the listener without the step.
    stage.destruction->after_step(stage.world, 1.0 / 60);
    stage.destruction->break_near(stage.world, id, {30, 4, -7}, 10).value();
    stage.destruction->after_step(stage.world, 1.0 / 60);
    EXPECT_EQ(stage.destruction->bodies(id)->size(), 120u);
    const WorldSummary after = stage.world.summary();
    const double mass_error = std::abs(mass_of(stage.world) / mass - 1);
    const double linear =
        length(after.linear_momentum - before.linear_momentum) / length(before.linear_momentum);
    const double angular =
        length(after.angular_momentum - before.angular_momentum) / length(before.angular_momentum);
    const double energy = std::abs(after.kinetic_energy / before.kinetic_energy - 1);
    RecordProperty("mass", std::to_string(mass_error * 1e15) + "e-15");
    RecordProperty("linear", std::to_string(linear * 1e15) + "e-15");
    RecordProperty("angular", std::to_string(angular * 1e15) + "e-15");
    RecordProperty("energy", std::to_string(energy * 1e15) + "e-15");
    EXPECT_LT(mass_error, 1e-12);
    EXPECT_LT(linear, 1e-9);
    EXPECT_LT(angular, 1e-9);
    EXPECT_LT(energy, 1e-9);
}

// Splits off one piece: the remaining body continues with the velocity of its points.
TEST(Destruction, detached_piece_keeps_the_velocity_of_its_points) {
    Stage stage({.gravity = {}});
    const DestructibleId id = stage.add(split_box({1, 0.1, 0.1}, 10, 1, 1).value(),
                                        {.linear_velocity = {0, 1, 0},
                                         .angular_velocity = {0, 0, 2},
                                         .bonds = {.tensile = 1e12, .shear = 1e12}});
    stage.destruction->break_near(stage.world, id, {0.8, 0, 0}, 0.05).value();
    stage.destruction->after_step(stage.world, 1.0 / 60);
    const std::vector<BodyId> bodies = *stage.destruction->bodies(id);
    ASSERT_EQ(bodies.size(), 2u);
    EXPECT_NEAR(stage.world.body(bodies[0])->linear_velocity.y, 1 - 2 * 0.1, 1e-12);
    EXPECT_NEAR(stage.world.body(bodies[1])->linear_velocity.y, 1 + 2 * 0.9, 1e-12);
}

// Which bonds break depends on where the ball arrives. At some places the debris catches it: at
// most of those with z = 0, where the wall is symmetric, and at few others.
TEST(Destruction, heavy_ball_breaks_through_a_wall) {
    const FracturedShape shape = wall();
    constexpr int places = 12;
    int passed = 0;
    double fastest = 0, highest_gain = 0;
    std::size_t fewest = shape.bonds.size();
    for (int place = 0; place < places; place++) {
        Stage stage;
        stage.floor();
        const DestructibleId id = stage.add(shape, standing());
        stage.step(5);
        ASSERT_EQ(*stage.destruction->intact_bonds(id), shape.bonds.size());
        const BodyId ball = stage.ball({-2, 1.08 + 0.02 * place, 0.013 * (place % 5)}, {20, 0, 0});
        const auto energy = [&] {
            const WorldSummary sum = stage.world.summary();
            return sum.kinetic_energy + sum.potential_energy;
        };
        // An anchored body has weight once it is loose.
        const double wall_energy =
            2400 * 8 * wall_half.x * wall_half.y * wall_half.z * 9.81 * wall_half.y;
        const double start = energy(), impact_energy = stage.world.summary().kinetic_energy;
        for (int k = 0; k < 30; k++) {
            stage.step();
            highest_gain = std::max(highest_gain, (energy() - start - wall_energy) / impact_energy);
            fastest = std::max(fastest, length(stage.world.body(ball)->linear_velocity));
        }
        fewest = std::min(fewest, stage.destruction->bodies(id)->size());
        passed += stage.world.body(ball)->pose.position.x > 0.5;
    }
    RecordProperty("passed", passed);
    RecordProperty("fewest_pieces", static_cast<int>(fewest));
    RecordProperty("energy_gain", std::to_string(highest_gain));
    EXPECT_GE(passed, 9);
    EXPECT_GT(fewest, 3u);
    EXPECT_LT(fastest, 21);
    EXPECT_LT(highest_gain, 0.02);
}

// Momenta of the world when the listener is called after a step.
struct Momenta : StepListener {
    Vec3 linear, angular;

    void after_step(World& world, double) override {
        const WorldSummary now = world.summary();
        linear = now.linear_momentum;
        angular = now.angular_momentum;
    }
};

// In free space, the block breaks in several places at once, and the ball continues. The module,
// between two listeners, does not change momentum; the solver computes contacts in single
// precision.
TEST(Destruction, breaking_impact_conserves_momentum) {
    World world = *World::create({.gravity = {}});
    Momenta before, after;
    world.add_listener(before).expect();
    auto module = std::make_unique<Destruction>();
    Destruction& destruction = *module;
    world.add_module(std::move(module)).expect();
    world.add_listener(after).expect();
    const Vec3 half{0.5, 0.5, 0.5};
    const FracturedShape block = fracture_box(half, random_seeds(half, 30, 4)).value();
    const DestructibleId id =
        *destruction.add(world, block, {.bonds = {.tensile = 5e5, .shear = 1e6}});
    // Next to it, two blocks collide and both break.
    for (const double side : {-1.0, 1.0})
        static_cast<void>(destruction
                              .add(world, block,
                                   {.pose = {.position = {side, 0.2 * side, 5}},
                                    .linear_velocity = {-15 * side, 0, 0},
                                    .bonds = {.tensile = 5e5, .shear = 1e6}})
                              .ok());
    static_cast<void>(
        world.create_body({.pose = {.position = {-2, 0.1, 0.05}}, .linear_velocity = {20, 0, 0}},
                          {.geometry = Sphere{0.3}, .density = 7800}));
    const WorldSummary start = world.summary();
    const double momentum = length(start.linear_momentum);
    double energy = 0, linear = 0, angular = 0, all_linear = 0, all_angular = 0;
    for (int k = 0; k < 30; k++) {
        world.step(1.0 / 60).expect();
        const WorldSummary now = world.summary();
        energy = std::max(energy, now.kinetic_energy / start.kinetic_energy - 1);
        linear = std::max(linear, length(after.linear - before.linear) / momentum);
        angular = std::max(angular, length(after.angular - before.angular) / (half.y * momentum));
        all_linear =
            std::max(all_linear, length(now.linear_momentum - start.linear_momentum) / momentum);
        all_angular = std::max(all_angular, length(now.angular_momentum - start.angular_momentum) /
                                                (half.y * momentum));
    }
    RecordProperty("pieces", static_cast<int>(destruction.bodies(id)->size()));
    RecordProperty("module_linear", std::to_string(linear * 1e15) + "e-15");
    RecordProperty("module_angular", std::to_string(angular * 1e15) + "e-15");
    RecordProperty("all_linear", std::to_string(all_linear * 1e9) + "e-9");
    RecordProperty("all_angular", std::to_string(all_angular * 1e6) + "e-6");
    RecordProperty("energy_gain", std::to_string(energy));
    EXPECT_GT(destruction.bodies(id)->size(), 3u);
    EXPECT_LT(linear, 1e-12);
    EXPECT_LT(angular, 1e-12);
    EXPECT_LT(all_linear, 1e-5);
    EXPECT_LT(energy, 1e-6);
}

TEST(Destruction, light_ball_bounces_off) {
    Stage stage;
    stage.floor();
    const FracturedShape shape = wall();
    const DestructibleId id = stage.add(shape, standing());
    const BodyId ball = stage.ball({-2, 1.2, 0}, {3, 0, 0}, 0.15, 100);
    stage.step(60);
    EXPECT_EQ(*stage.destruction->intact_bonds(id), shape.bonds.size());
    EXPECT_LT(stage.world.body(ball)->pose.position.x, -0.2);
}

// Breaking dissipates energy: if the bonds require more than the ball has, none breaks.
TEST(Destruction, broken_bonds_are_limited_by_impact_energy) {
    Stage stage;
    const FracturedShape shape = wall();
    DestructibleDef def = standing();
    def.bonds.fracture_energy = 1e9;
    const DestructibleId id = stage.add(shape, def);
    stage.ball({-2, 1.2, 0}, {20, 0, 0});
    stage.step(12);
    EXPECT_EQ(*stage.destruction->intact_bonds(id), shape.bonds.size());
}

// Compares a world with the wall and one with a static box of the same size; a hundred balls roll
// about.
TEST(Destruction, intact_wall_costs_as_much_as_one_body) {
    double best[2] = {1e9, 1e9};
    for (int trial = 0; trial < 5; trial++)
        for (const bool breaks : {false, true}) {
            Stage stage({.sleeping = false});
            stage.floor();
            if (breaks)
                stage.add(wall(200), standing());
            else
                stage.world
                    .create_body(
                        {.type = BodyType::static_body, .pose = {.position = {0, wall_half.y, 0}}},
                        {.geometry = Box{wall_half}})
                    .value();
            for (int k = 0; k < 100; k++)
                stage.ball({3.0 + k % 10, 0.3, 0.8 * (k / 10)}, {0, 0, 0.1});
            stage.step(20);
            const double start = cpu_ms();
            stage.step(200);
            best[breaks] = std::min(best[breaks], (cpu_ms() - start) / 200);
        }
    RecordProperty("box_us", static_cast<int>(best[0] * 1e3));
    RecordProperty("wall_us", static_cast<int>(best[1] * 1e3));
    EXPECT_LT(best[1], 1.2 * best[0] + 0.02);
}

// Two thousand chunks separate at once.
TEST(Destruction, splits_into_2000_pieces_in_one_step) {
    Stage stage;
    stage.floor();
    const Vec3 half{5, 5, 0.1};
    const DestructibleId id =
        stage.add(split_box(half, 50, 40, 1).value(), {.pose = {.position = {0, 5.01, 0}}});
    stage.step(2);
    stage.destruction->break_near(stage.world, id, {0, 5, 0}, 100).value();
    int late = 0;
    double tick[10];
    for (int k = 0; k < 10; k++) {
        const double start = cpu_ms();
        stage.step();
        tick[k] = cpu_ms() - start;
        late += tick[k] > 1e3 / 60;
        RecordProperty("tick_" + std::to_string(k) + "_us", static_cast<int>(tick[k] * 1e3));
        EXPECT_EQ(stage.destruction->bodies(id)->size(), 2000u);
    }
    // Splitting takes less time than the first step of the solver with the pieces.
    EXPECT_LT(tick[0], tick[1]);
    RecordProperty("late_ticks", late);
}

// Hulls that do not collide with each other: none falls through the floor, and no step except the
// first two takes longer than 1/60 s, measured in counted work in units of 0.1 us.
TEST(Destruction, steps_2000_non_colliding_hulls_within_the_time_limit) {
    Stage stage;
    stage.floor();
    DestructionLimits limits;
    limits.passing_volume = 1;
    stage.destruction->set_limits(limits).expect();
    const Vec3 half{5, 4, 0.1};
    const FracturedShape shape = fracture_box(half, random_seeds(half, 2000, 1)).value();
    const DestructibleId id = stage.add(shape, {.pose = {.position = {0, 4.01, 0}}});
    stage.step(2);
    stage.destruction->break_near(stage.world, id, {0, 4, 0}, 100).value();
    int late = 0, most = 0;
    for (int k = 0; k < 200; k++) {
        const double start = cpu_ms();
        stage.step();
        late += cpu_ms() - start > 1e3 / 60;
        if (k >= 2) most = std::max(most, static_cast<int>(stage.world.profile().work));
    }
    RecordProperty("late_ticks", late);
    RecordProperty("most_work", most);
    EXPECT_LT(most, 100000);
    for (const BodyId body : *stage.destruction->bodies(id))
        EXPECT_GT(stage.world.body(body)->center.y, -0.1);
    EXPECT_LT(stage.world.summary().awake_bodies, 200);
}

// Work beyond the limit of a step is deferred to the next step.
TEST(Destruction, honours_pieces_per_step_limit) {
    Stage stage({.gravity = {}});
    DestructionLimits limits;
    limits.pieces_per_step = 30;
    stage.destruction->set_limits(limits).expect();
    const DestructibleId id = stage.add(split_box({1, 1, 0.1}, 10, 10, 1).value());
    stage.step();
    stage.destruction->break_near(stage.world, id, {}, 100).value();
    const std::size_t expected[] = {31, 61, 91, 100, 100};
    for (const std::size_t count : expected) {
        stage.step();
        EXPECT_EQ(stage.destruction->bodies(id)->size(), count);
    }
}

TEST(Destruction, removes_debris_after_its_lifetime) {
    Stage stage;
    stage.floor();
    DestructionLimits limits;
    limits.debris_life = 0.5;
    limits.debris_volume = 1;
    stage.destruction->set_limits(limits).expect();
    const DestructibleId id =
        stage.add(split_box({1, 1, 0.1}, 4, 4, 1).value(), {.pose = {.position = {0, 1, 0}}});
    stage.destruction->break_near(stage.world, id, {0, 1, 0}, 100).value();
    stage.step(10);
    EXPECT_EQ(stage.world.bodies().size(), 17u);
    stage.step(25);
    EXPECT_EQ(stage.world.bodies().size(), 1u);
    EXPECT_TRUE(stage.destruction->bodies(id)->empty());
    stage.destruction->remove(stage.world, id).expect();
    EXPECT_FALSE(stage.destruction->contains(id));
}

TEST(Destruction, rejects_invalid_shapes_and_names_the_field) {
    Stage stage;
    FracturedShape shape = split_box({1, 1, 1}, 2, 1, 1).value();
    shape.bonds[0].area = 0;
    EXPECT_EQ(stage.destruction->add(stage.world, shape, {}).error().message,
              "bonds[0]: area is 0.000000; it is out of range");
    shape.bonds[0].b = 7;
    EXPECT_EQ(stage.destruction->add(stage.world, shape, {}).error().message,
              "bonds[0]: a and b must be indices of chunks with a < b");
    EXPECT_EQ(stage.destruction->add(stage.world, {}, {}).error().message,
              "chunks has 0 elements; it must have 1 to 20000");
    EXPECT_TRUE(stage.world.bodies().empty());
}

}  // namespace
}  // namespace jostle::modules
