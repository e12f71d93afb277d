// SPDX-License-Identifier: MIT
//
// Extreme situations: without throttle, the energy never increases, and all values stay finite. The
// energy stored in springs is not part of the summed energy.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/modules/vehicle/test_car.h"

namespace jostle::test {
namespace {

using modules::WheelCast;

struct StressedCar : TestCar {
    double fastest = 0, gained = 0;  // m/s; J, gain above the start

    explicit StressedCar(Vec3 velocity = {}) : TestCar({}, velocity) {}
    void put(Vec3 position, Quat rotation = {}) {
        world.set_pose(chassis, {position, normalized(rotation)}).expect();
    }
    VehicleDef plain(WheelCast cast) const {
        VehicleDef def = plain_saloon(chassis);
        def.cast = cast;
        return def;
    }
    void roll(WheelCast cast) {
        add(plain(cast));
        set({.gear = 0});
    }
    double energy() const {
        const WorldSummary summary = world.summary();
        return summary.kinetic_energy + summary.potential_energy;
    }
    void track_energy(double seconds, double dt = step_time) {
        const double start = energy();
        for (int k = 0; k < static_cast<int>(seconds / dt); k++) {
            world.step(dt).expect();
            gained = std::max(gained, energy() - start);
            fastest = std::max(fastest, speed());
            ASSERT_TRUE(std::isfinite(energy()));
        }
    }
    BodyId box(Vec3 position, Vec3 half, double mass, BodyType type = BodyType::dynamic) {
        return world
            .create_body({.type = type, .pose = {.position = position}},
                         {.geometry = Box{half}, .material = {.friction = 1}, .mass = mass})
            .value();
    }
};

// J, energy of the springs of a resting car of 1,500 kg, plus a margin.
constexpr double springs = 4 * 0.5 * 33'300 * 0.11 * 0.11 + 60;

class Stress : public testing::TestWithParam<WheelCast> {};

TEST_P(Stress, survives_a_ramp_jump_at_40_m_s) {
    StressedCar of({0, 0, -40});
    const BodyId ramp = of.box({0, 0, -30}, {5, 0.2, 8}, 0, BodyType::static_body);
    of.world.set_pose(ramp, {{0, 0, -30}, normalized(Quat{0.15, 0, 0, 1})}).expect();
    of.roll(GetParam());
    of.track_energy(10);
    EXPECT_LT(of.gained, springs);
    EXPECT_LT(of.fastest, 40.5);
}

TEST_P(Stress, survives_a_landing_on_one_wheel) {
    StressedCar of;
    of.put({0, 4, 0}, {0.25, 0, 0.3, 1});
    of.roll(GetParam());
    of.track_energy(10);
    EXPECT_LT(of.gained, springs);
    EXPECT_LT(of.fastest, std::sqrt(2 * gravity * 4) + 0.5);
    EXPECT_GT(rotate(of.body().pose.rotation, {0, 1, 0}).y, 0.99) << "it is back on its wheels";
}

TEST_P(Stress, stays_stable_on_its_roof) {
    StressedCar of;
    of.put({0, 1, 0}, {0, 0, 1, 0});
    of.add(of.plain(GetParam()));
    of.set({.throttle = 1});
    of.track_energy(3);
    EXPECT_LT(of.speed(), 0.3) << "wheels in the air have no effect";
    EXPECT_LT(of.fastest, std::sqrt(2 * gravity));
}

TEST_P(Stress, stays_stable_on_a_trailer_and_a_moving_platform) {
    StressedCar loose;
    loose.box({0, 1, 0}, {1.5, 0.2, 4}, 3000);
    loose.put({0, 1.9, 0});
    loose.roll(GetParam());
    loose.track_energy(8);
    EXPECT_LT(loose.gained, springs);
    EXPECT_LT(loose.speed(), 0.3);

    StressedCar carried;
    const BodyId platform = carried.box({0, 1, 0}, {3, 0.2, 6}, 0, BodyType::kinematic);
    carried.world.set_velocity(platform, {5, 0, 0}, {}).expect();
    carried.put({0, 1.9, 0});
    carried.add(carried.plain(GetParam()));
    carried.set({.brake = 1, .gear = 0});
    carried.track_energy(8);
    EXPECT_NEAR(carried.body().linear_velocity.x, 5, 0.01);
    EXPECT_LT(carried.fastest, 6.5);
}

TEST_P(Stress, stays_stable_against_and_under_100_tonnes) {
    StressedCar against({0, 0, -20});
    against.box({0, 2, -30}, {2, 2, 2}, 1e5);
    against.roll(GetParam());
    against.track_energy(8);
    EXPECT_LT(against.gained, springs);
    EXPECT_LT(against.fastest, 20.1);
    EXPECT_LT(against.speed(), 1);

    StressedCar under;
    under.box({0, 4, 0}, {1, 1, 1}, 1e5);
    under.roll(GetParam());
    under.track_energy(8);
    EXPECT_LT(under.gained, 0.01 * 1e5 * gravity);
    EXPECT_LT(under.fastest, 12);
}

TEST_P(Stress, stays_stable_at_30_and_240_hz) {
    for (const double dt : {1.0 / 30, 1.0 / 240}) {
        StressedCar of({0, 0, -20});
        of.roll(GetParam());
        of.track_energy(3, dt);
        EXPECT_LT(of.gained, springs);
        EXPECT_GT(of.speed(), 19);
        of.set({.brake = 1, .gear = 0});
        of.track_energy(6, dt);
        EXPECT_LT(of.speed(), 0.01);
    }
}

TEST_P(Stress, stays_stable_with_wheels_of_0_1_and_1_m) {
    for (const double radius : {0.1, 1.0}) {
        StressedCar of({0, 0, -10});
        of.put({0, radius + 0.34, 0});
        VehicleDef def = of.plain(GetParam());
        for (auto& wheel : def.wheels) {
            wheel.radius = radius;
            wheel.width = 0.6 * radius;
            wheel.inertia = 0.5 * wheel.mass * radius * radius;
        }
        of.add(def);
        of.set({.gear = 0});
        of.track_energy(3);
        EXPECT_LT(of.gained, springs);
        EXPECT_NEAR(of.body().center.y, radius + 0.34, 0.01);
        of.set({.brake = 1, .gear = 0});
        of.track_energy(6);
        EXPECT_LT(of.speed(), 0.01);
    }
}

TEST_P(Stress, stays_stable_with_100_kg_and_30_tonnes) {
    for (const double mass : {100.0, 30'000.0}) {
        StressedCar of({0, 0, -10});
        of.world.set_mass(of.chassis, mass).expect();
        VehicleDef def = of.plain(GetParam());
        for (auto& wheel : def.wheels) wheel.brake_torque = 10 * mass;
        of.add(def);
        of.set({.gear = 0});
        of.track_energy(3);
        EXPECT_LT(of.gained, springs * mass / car_mass + 60);
        of.set({.brake = 1, .gear = 0});
        of.track_energy(6);
        EXPECT_LT(of.speed(), 0.01);
    }
}

INSTANTIATE_TEST_SUITE_P(Casts, Stress,
                         testing::Values(WheelCast::ray, WheelCast::sphere, WheelCast::cylinder,
                                         WheelCast::body));

}  // namespace
}  // namespace jostle::test
