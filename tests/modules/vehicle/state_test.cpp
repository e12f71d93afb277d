// SPDX-License-Identifier: MIT
//
// Cars are part of the state of the world: bit-identical results for any number of threads and
// after saving, loading and restoring; corrupted bytes are rejected.
#include <gtest/gtest.h>

#include <cstring>

#include "tests/modules/vehicle/test_car.h"
#include "tests/support/random.h"

namespace jostle::test {
namespace {

void register_vehicles() {
    static const Status known =
        register_module(std::string(Vehicles::kind), [] { return std::make_unique<Vehicles>(); });
    known.expect();
}

Vehicles& vehicles_of(World& world) {
    return dynamic_cast<Vehicles&>(*world.module(Vehicles::kind));
}

// Eight cars among crates on wavy ground, with different casts and pilots.
World lively(int threads) {
    register_vehicles();
    World world({.threads = threads});
    HeightGrid grid{.columns = 81, .rows = 81, .spacing_x = 2, .spacing_z = 2};
    for (int row = 0; row < 81; row++)
        for (int column = 0; column < 81; column++)
            grid.heights.push_back(0.3 * sin_cos(0.5 * column + 0.2 * row).sin);
    world
        .create_body({.type = BodyType::static_body},
                     {.geometry = HeightField{build_height_field(std::move(grid)).value()},
                      .material = {.friction = 0.9}})
        .value();
    world.add_module(std::make_unique<Vehicles>()).expect();
    for (int k = 0; k < 8; k++) {
        const double x = 12.0 * (k % 4) - 18, z = 14.0 * (k / 4) - 7;
        const BodyId chassis = add_chassis(world, {x, 1.6, z});
        world
            .create_body({.pose = {.position = {x + 1, 1.5, z - 7}}},
                         {.geometry = Box{{0.5, 0.5, 0.5}}, .density = 100})
            .value();
        modules::SaloonDef saloon{.chassis = chassis};
        saloon.front_drive = 0.5 * (k % 3);
        VehicleDef def = modules::saloon(saloon);
        def.cast = static_cast<modules::WheelCast>(k % 4);
        const CarId car = vehicles_of(world).add(world, def).value();
        if (k % 2 == 0)
            vehicles_of(world)
                .set_pilot(world, car, {.center = {}, .radius = 20, .speed = 9})
                .expect();
        else
            vehicles_of(world)
                .set_controls(world, car, {.throttle = 0.6, .steering = 0.2 * k - 0.6})
                .expect();
    }
    return world;
}

void drive(World& world, int steps) {
    for (int k = 0; k < steps; k++) world.step(step_time).expect();
}

TEST(VehicleState, result_is_bit_identical_for_any_thread_count) {
    World one = lively(1);
    drive(one, 400);
    for (const int threads : {2, 3, 4, 8}) {
        World many = lively(threads);
        drive(many, 400);
        EXPECT_EQ(state_hash(one), state_hash(many)) << threads << " threads";
        EXPECT_EQ(first_difference(one, many), std::nullopt);
    }
}

// Enough cars that ground queries run on all threads.
World crowded(int threads) {
    register_vehicles();
    World world({.threads = threads});
    world.create_body({.type = BodyType::static_body}, {.geometry = Plane{}}).value();
    world.add_module(std::make_unique<Vehicles>()).expect();
    for (int k = 0; k < 100; k++) {
        const BodyId chassis = add_chassis(world, {6.0 * (k % 10), 0.8, 7.0 * (k / 10)});
        VehicleDef def = modules::saloon({.chassis = chassis});
        def.cast = static_cast<modules::WheelCast>(k % 3);
        const CarId car = vehicles_of(world).add(world, def).value();
        vehicles_of(world).set_controls(world, car, {.throttle = 0.5, .steering = 0.3}).expect();
    }
    return world;
}

TEST(VehicleState, hundred_cars_are_bit_identical_for_any_thread_count) {
    World one = crowded(1);
    drive(one, 40);
    for (const int threads : {2, 8}) {
        World many = crowded(threads);
        drive(many, 40);
        EXPECT_EQ(state_hash(one), state_hash(many)) << threads << " threads";
    }
}

TEST(VehicleState, loaded_world_continues_bit_identically) {
    World world = lively(1);
    drive(world, 200);
    World again = load(save(world)).value();
    EXPECT_EQ(first_difference(world, again), std::nullopt);
    drive(world, 200);
    drive(again, 200);
    EXPECT_EQ(first_difference(world, again), std::nullopt);
    EXPECT_EQ(state_hash(world), state_hash(again));
}

TEST(VehicleState, restored_world_continues_bit_identically) {
    World world = lively(2);
    drive(world, 150);
    RestorePoint point;
    point.capture(world);
    drive(world, 150);
    const std::uint64_t end = state_hash(world);
    point.restore(world).expect();
    drive(world, 150);
    EXPECT_EQ(state_hash(world), end);
}

std::string load_error_of(std::vector<std::byte> bytes) {
    Vehicles vehicles;
    const Status loaded = load_module(vehicles, bytes);
    return loaded.ok() ? "" : loaded.error().message;
}

// Each value of a saved car is replaced by an invalid one.
TEST(VehicleState, errors_name_the_invalid_field) {
    World world = lively(1);
    drive(world, 10);
    const std::vector<std::byte> good = save_module(vehicles_of(world));
    EXPECT_EQ(load_error_of(good), "");
    const double radius = 0.33, bad = -1;
    std::size_t found = 0;
    for (std::size_t at = 0; at + 8 <= good.size(); at++) {
        if (std::memcmp(good.data() + at, &radius, 8) != 0) continue;
        std::vector<std::byte> corrupted = good;
        std::memcpy(corrupted.data() + at, &bad, 8);
        const std::string error_of = load_error_of(corrupted);
        EXPECT_NE(error_of.find("radius is -1"), std::string::npos) << error_of;
        if (++found == 4) break;
    }
    EXPECT_EQ(found, 4u);
}

// Corrupted bytes are rejected, or the resulting car can be stepped.
TEST(VehicleState, corrupted_bytes_are_rejected_or_harmless) {
    World world = lively(1);
    drive(world, 30);
    const std::vector<std::byte> good = save_module(vehicles_of(world));
    Random random(5);
    int refused = 0;
    constexpr int tries = 3000;
    for (int k = 0; k < tries; k++) {
        std::vector<std::byte> corrupted = good;
        const int changes = 1 + k % 4;
        for (int c = 0; c < changes; c++)
            corrupted[static_cast<std::size_t>(random.in(0, 1) * 0.999999 *
                                               static_cast<double>(corrupted.size()))] =
                static_cast<std::byte>(random.in(0, 255.99));
        if (k % 7 == 0) corrupted.resize(corrupted.size() / 2);
        auto vehicles = std::make_unique<Vehicles>();
        if (!load_module(*vehicles, corrupted).ok()) {
            refused++;
            continue;
        }
        if (k % 10 != 0) continue;
        World again = lively(1);
        again.remove_module(Vehicles::kind).expect();
        again.add_module(std::move(vehicles)).expect();
        for (int step = 0; step < 5; step++) {
            again.step(step_time).expect();
            for (const BodyId body : again.bodies())
                ASSERT_TRUE(is_finite(again.body(body)->center)) << "try " << k;
        }
    }
    RecordProperty("refused_of_3000", refused);
    EXPECT_GT(refused, tries / 5);
}

}  // namespace
}  // namespace jostle::test
