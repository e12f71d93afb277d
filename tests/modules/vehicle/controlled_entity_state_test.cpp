// SPDX-License-Identifier: MIT
//
// A car that goes on in another world (jostle/modules/controlled_entity_state.h): what a client
// foresees of the car that it drives.
#include "jostle/modules/controlled_entity_state.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/modules/corrupted_words.h"
#include "tests/modules/vehicle/test_car.h"

namespace jostle::test {
namespace {

// A server's world and a client's: the second one's bodies have other ids.
struct TwoWorlds {
    TestCar there;
    World world{sleepless({})};
    BodyId chassis;
    Vehicles* vehicles = nullptr;

    explicit TwoWorlds(modules::WheelCast cast = modules::WheelCast::cylinder) {
        VehicleDef def = modules::saloon({.chassis = there.chassis});
        def.cast = cast;
        there.add(def);
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
            there.world, *there.vehicles, there.chassis,
            [&](BodyId id) { return id == there.chassis ? 7u : 9u; });
    }
    bool apply(std::span<const std::uint32_t> words) {
        return modules::apply_controlled_entity(
            world, *vehicles, chassis, words,
            [&](std::uint32_t name) { return name == 7 ? chassis : BodyId{}; });
    }
    double distance() const {
        return length(world.body(chassis)->pose.position - there.body().pose.position);
    }
    void drive_both(int ticks) {
        for (int k = 0; k < ticks; k++) {
            there.world.step(step_time).expect();
            world.step(step_time).expect();
        }
    }
};

TEST(ControlledCar, continues_identically_in_another_world) {
    TwoWorlds of;
    of.there.set({.throttle = 1, .steering = 0.3});
    of.there.drive(2.5);
    ASSERT_GT(of.there.speed(), 8);
    const auto words = of.encode();
    ASSERT_TRUE(words.has_value());
    EXPECT_LT(words->size(), 400u);  // 1.6 kB, most of which never changes
    ASSERT_TRUE(of.apply(*words));
    EXPECT_EQ(of.vehicles->state(1)->gear, of.there.state().gear);
    // Half a second of the same controls, through a change of gear and 5 m of a bend.
    of.drive_both(30);
    RecordProperty("apart_mm", std::to_string(1000 * of.distance()));
    EXPECT_LT(of.distance(), 2e-4);
    // Whoever holds the wheel here turns it here.
    of.vehicles->control(of.world, of.chassis, {.axes = {-1, 0}});
    of.drive_both(30);
    EXPECT_GT(of.distance(), 0.3);
    // And what was told later puts that right.
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
    of.there.set({.throttle = 1});
    of.there.drive(1);
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
        if (!of.apply(good)) FAIL() << "forged words " << k << " left a car that takes none";
    }
    EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace jostle::test
