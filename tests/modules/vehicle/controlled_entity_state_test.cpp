// SPDX-License-Identifier: MIT
//
// Applies the state of a car to another world (jostle/modules/controlled_entity_state.h), as a
// client does to predict the car that it drives.
#include "jostle/modules/controlled_entity_state.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/modules/corrupted_words.h"
#include "tests/modules/vehicle/test_car.h"

namespace jostle::test {
namespace {

// A server world and a client world, in which bodies have other ids.
struct TwoWorlds {
    TestCar server;
    World world{sleepless({})};
    BodyId chassis;
    Vehicles* vehicles = nullptr;

    explicit TwoWorlds(modules::WheelCast cast = modules::WheelCast::cylinder) {
        VehicleDef def = modules::saloon({.chassis = server.chassis});
        def.cast = cast;
        server.add(def);
        world.create_body({.pose = {.position = {50, 50, 50}}}, {.geometry = Sphere{1}}).value();
        chassis = add_chassis(world, {3, 3, 3});
        world
            .create_body({.type = BodyType::static_body},
                         {.geometry = Plane{}, .material = {.friction = 1}})
            .value();
        auto made = std::make_unique<Vehicles>();
        vehicles = made.get();
        world.add_module(std::move(made)).expect();
    }
    std::optional<std::vector<std::uint32_t>> encode() {
        return modules::encode_controlled_entity(
            server.world, *server.vehicles, server.chassis,
            [&](BodyId id) { return id == server.chassis ? 7u : 9u; });
    }
    bool apply(std::span<const std::uint32_t> words) {
        return modules::apply_controlled_entity(
            world, *vehicles, chassis, words,
            [&](std::uint32_t name) { return name == 7 ? chassis : BodyId{}; });
    }
    double distance() const {
        return length(world.body(chassis)->pose.position - server.body().pose.position);
    }
    void drive_both(int ticks) {
        for (int k = 0; k < ticks; k++) {
            server.world.step(step_time).expect();
            world.step(step_time).expect();
        }
    }
};

TEST(ControlledCar, continues_identically_in_another_world) {
    TwoWorlds of;
    of.server.set({.throttle = 1, .steering = 0.3});
    of.server.drive(2.5);
    ASSERT_GT(of.server.speed(), 8);
    const auto words = of.encode();
    ASSERT_TRUE(words.has_value());
    EXPECT_LT(words->size(), 400u);  // 1.6 kB, most of which never changes
    ASSERT_TRUE(of.apply(*words));
    EXPECT_EQ(of.vehicles->state(1)->gear, of.server.state().gear);
    // 0.5 s with the same controls, through a gear change and 5 m of a bend.
    of.drive_both(30);
    RecordProperty("apart_mm", std::to_string(1000 * of.distance()));
    EXPECT_LT(of.distance(), 2e-4);
    // Driver input in the client world changes only that world.
    of.vehicles->control(of.world, of.chassis, {.axes = {-1, 0}});
    of.drive_both(30);
    EXPECT_GT(of.distance(), 0.3);
    // Applying a later state corrects it.
    ASSERT_TRUE(of.apply(*of.encode()));
    EXPECT_LT(of.distance(), 1e-5);
    EXPECT_EQ(of.vehicles->cars().size(), 1u);
}

TEST(ControlledCar, car_with_body_wheels_is_not_encoded) {
    TwoWorlds of(modules::WheelCast::body);
    EXPECT_FALSE(of.encode().has_value());
}

TEST(ControlledCar, words_that_make_no_sense_change_nothing) {
    TwoWorlds of;
    of.server.set({.throttle = 1});
    of.server.drive(1);
    const std::vector<std::uint32_t> good = *of.encode();
    ASSERT_TRUE(of.apply(good));
    Random random(5);
    int refused = 0;
    for (int k = 0; k < 3000; k++) {
        const Transform before = of.world.body(of.chassis)->pose;
        if (!of.apply(corrupted(good, random))) {
            refused++;
            EXPECT_EQ(of.world.body(of.chassis)->pose, before);
        }
        of.world.step(step_time).expect();
        if (!of.apply(good))
            FAIL() << "after corrupted words " << k << ", the car rejects valid words";
    }
    EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace jostle::test
