// SPDX-License-Identifier: MIT
//
// Calls of the Vehicles module: errors and published data.
#include "jostle/modules/vehicle.h"

#include <gtest/gtest.h>

#include "tests/modules/vehicle/test_car.h"
#include "tests/support/error_of.h"

namespace jostle::test {
namespace {

TEST(Vehicles, rejects_invalid_definitions_and_names_the_field) {
    TestCar of;
    const auto add_error = [&](auto&& change) {
        VehicleDef def = plain_saloon(of.chassis);
        change(def);
        return error_of(of.vehicles->add(of.world, def)).message;
    };
    EXPECT_EQ(add_error([](VehicleDef& def) { def.wheels[2].radius = 0; }),
              "wheels[2].radius is 0; it must be from 0.02 to 10");
    EXPECT_EQ(
        add_error([](VehicleDef& def) { def.wheels[1].suspension.max_length = 0; }),
        "wheels[1].suspension.max_length must be at least 0.001 m more than suspension.min_length");
    EXPECT_EQ(add_error([](VehicleDef& def) { def.wheels.clear(); }),
              "wheels is 0; it must be from 1 to 16");
    EXPECT_EQ(add_error([](VehicleDef& def) { def.wheels[2].drive_share = 0.1; }),
              "wheels: drive_share of all wheels must sum to 0 or 1");
    EXPECT_EQ(add_error([](VehicleDef& def) {
                  def.differential_locks = {{.first = {2}, .second = {7}}};
              }),
              "differential_locks[0].wheels contains an index that is not a wheel");
    EXPECT_EQ(add_error([](VehicleDef& def) {
                  def.steering_drive = {.left = {0, 1}, .right = {1}};
              }),
              "steering_drive.wheels contains a wheel twice");
    EXPECT_EQ(add_error([](VehicleDef& def) { def.steering_drive.left = {0}; }),
              "steering_drive.wheels is 0; it must be from 1 to 15");
    EXPECT_EQ(add_error([](VehicleDef& def) {
                  def.wheels[0].axle = {0, 1, 0};
              }),
              "wheels[0].axle is not perpendicular to down");
    EXPECT_EQ(add_error([](VehicleDef& def) { def.engine.curve[1].speed = 0; }),
              "engine.curve.speed must be strictly increasing");
    EXPECT_EQ(add_error([](VehicleDef& def) { def.gearbox.shift_down_speed = 900; }),
              "gearbox.shift_down_speed must be less than shift_up_speed");
    EXPECT_EQ(add_error([](VehicleDef& def) { def.chassis = {}; }).empty(), false);
    EXPECT_TRUE(of.vehicles->cars().empty());
}

TEST(Vehicles, requires_a_dynamic_chassis_of_no_other_car) {
    TestCar of;
    of.add(plain_saloon(of.chassis));
    EXPECT_EQ(error_of(of.vehicles->add(of.world, plain_saloon(of.chassis))).code,
              ErrorCode::already_exists);
    EXPECT_EQ(error_of(of.vehicles->add(of.world, plain_saloon(of.world.bodies()[0]))).code,
              ErrorCode::failed_precondition);
}

TEST(Vehicles, ids_are_not_reused_and_unknown_ids_are_rejected) {
    TestCar of;
    of.add(plain_saloon(of.chassis));
    const CarId first = of.car;
    of.vehicles->remove(of.world, first).expect();
    EXPECT_EQ(error_of(of.vehicles->remove(of.world, first)).code, ErrorCode::not_found);
    EXPECT_EQ(error_of(of.vehicles->state(first)).code, ErrorCode::not_found);
    EXPECT_EQ(error_of(of.vehicles->set_controls(of.world, first, {})).code, ErrorCode::not_found);
    of.add(plain_saloon(of.chassis));
    EXPECT_NE(of.car, first);
}

TEST(Vehicles, rejects_controls_out_of_range_and_keeps_the_previous_ones) {
    TestCar of;
    of.add(plain_saloon(of.chassis));
    of.set({.throttle = 0.5});
    EXPECT_EQ(error_of(of.vehicles->set_controls(of.world, of.car, {.steering = 2})).message,
              "steering is 2; it must be from -1 to 1");
    EXPECT_EQ(of.state().controls.throttle, 0.5);
}

TEST(Vehicles, car_is_removed_with_its_chassis) {
    TestCar of;
    of.add(plain_saloon(of.chassis));
    of.drive(1);
    of.world.destroy_body(of.chassis).expect();
    of.drive(0.1);
    EXPECT_TRUE(of.vehicles->cars().empty());
}

TEST(Vehicles, parked_car_sleeps_and_controls_wake_it) {
    World world;
    world.create_body({.type = BodyType::static_body}, {.geometry = Plane{}}).value();
    const BodyId chassis = add_chassis(world, {0, 0.67, 0});
    world.add_module(std::make_unique<Vehicles>()).expect();
    auto& vehicles = dynamic_cast<Vehicles&>(*world.module(Vehicles::kind));
    const CarId car = vehicles.add(world, plain_saloon(chassis)).value();
    vehicles.set_controls(world, car, {.hand_brake = 1, .gear = 0}).expect();
    const auto drive = [&](double seconds) {
        for (int k = 0; k < seconds * 60; k++) world.step(step_time).expect();
    };
    drive(10);
    EXPECT_FALSE(world.body(chassis)->awake);
    const Vec3 at = world.body(chassis)->center;
    vehicles.set_controls(world, car, {.throttle = 1}).expect();
    drive(2);
    EXPECT_TRUE(world.body(chassis)->awake);
    EXPECT_GT(length(world.body(chassis)->center - at), 1);
}

TEST(Vehicles, sleeping_car_falls_when_its_ground_is_removed) {
    World world;
    const BodyId floor =
        world.create_body({.type = BodyType::static_body}, {.geometry = Plane{}}).value();
    const BodyId chassis = add_chassis(world, {0, 0.67, 0});
    world.add_module(std::make_unique<Vehicles>()).expect();
    auto& vehicles = dynamic_cast<Vehicles&>(*world.module(Vehicles::kind));
    const CarId car = vehicles.add(world, plain_saloon(chassis)).value();
    vehicles.set_controls(world, car, {.hand_brake = 1, .gear = 0}).expect();
    for (int k = 0; k < 600; k++) world.step(step_time).expect();
    ASSERT_FALSE(world.body(chassis)->awake);
    world.destroy_body(floor).expect();
    for (int k = 0; k < 60; k++) world.step(step_time).expect();
    EXPECT_NEAR(world.body(chassis)->linear_velocity.y, -gravity, 0.5);
}

TEST(Vehicles, scene_settings_create_saloons) {
    TestCar of;
    Vehicles made;
    ASSERT_TRUE(
        made.configure(
                of.world,
                {.numbers = {{"track", 1.5}, {"front_drive", 1}, {"cast", 0}, {"throttle", 0.4}},
                 .bodies = {{"car", of.chassis}}})
            .ok());
    ASSERT_EQ(made.cars().size(), 1u);
    const VehicleDef def = made.def(1).value();
    EXPECT_EQ(def.wheels[0].attachment.x, -0.75);
    EXPECT_EQ(def.wheels[0].drive_share, 0.5);
    EXPECT_EQ(def.cast, modules::WheelCast::ray);
    EXPECT_EQ(made.state(1)->controls.throttle, 0.4);

    Vehicles wrong;
    EXPECT_EQ(error_of(wrong.configure(of.world, {.numbers = {{"track", 50}}})).message,
              "track is 50; it must be from 0.1 to 20");
    EXPECT_EQ(error_of(wrong.configure(of.world, {.numbers = {{"longest", 0.05}},
                                                  .bodies = {{"car", of.chassis}}}))
                  .message,
              "car: wheels[0].suspension.max_length must be at least 0.001 m more than "
              "suspension.min_length");
}

TEST(Vehicles, scene_settings_create_tanks_and_motorcycles) {
    TestCar of;
    const auto made = [&](double make, double cast) {
        Vehicles vehicles;
        const Status done = vehicles.configure(
            of.world,
            {.numbers = {{"make", make}, {"cast", cast}}, .bodies = {{"car", of.chassis}}});
        EXPECT_TRUE(done.ok());
        return vehicles.def(1).value();
    };
    const VehicleDef tank = made(1, 2);
    EXPECT_EQ(tank.wheels.size(), 10u);
    EXPECT_EQ(tank.steering_drive.left.size(), 5u);
    EXPECT_EQ(tank.wheels[0].attachment, (Vec3{-0.8, 0, -1.35}));
    EXPECT_EQ(made(2, 3).cast, modules::WheelCast::ray) << "wheels of two-wheelers are not bodies";
    EXPECT_TRUE(made(2, 3).balance.enabled);
    EXPECT_EQ(made(0, 3).cast, modules::WheelCast::body);
}

TEST(Vehicles, pilot_follows_its_circle) {
    TestCar of({}, {0, 0, 0});
    of.world.set_pose(of.chassis, {.position = {30, 0.7, 0}}).expect();
    of.add(plain_saloon(of.chassis));
    of.vehicles->set_pilot(of.world, of.car, {.center = {}, .radius = 30, .speed = 12}).expect();
    of.drive(20);
    double furthest = 0;
    for (int k = 0; k < 600; k++) {
        of.drive(step_time);
        const Vec3 at = of.body().center;
        furthest = std::max(furthest, std::abs(std::hypot(at.x, at.z) - 30));
    }
    RecordProperty("off_the_circle_m", std::to_string(furthest));
    EXPECT_LT(furthest, 2);
    EXPECT_NEAR(of.speed(), 12, 1);
    of.set({});
    of.drive(1);
    EXPECT_EQ(of.state().controls, CarControls{}) << "set_controls() removes the pilot";
}

TEST(Vehicles, channel_data_matches_the_documented_layout) {
    TestCar of;
    of.add(plain_saloon(of.chassis));
    of.drive(3);
    ChannelWriter writer([](BodyId body) { return body.index + 1; });
    of.vehicles->publish(of.world, writer);
    ASSERT_EQ(writer.channels().size(), 1u);
    EXPECT_EQ(writer.channels()[0].entity, of.chassis.index + 1);
    const auto& values = writer.channels()[0].values;
    ASSERT_EQ(values.size(), 2u + 4 * 9u);
    EXPECT_EQ(values[0], of.state().gear);
    EXPECT_NEAR(values[2] / 255.0 * 2, 0.33, 0.005) << "radius";
    EXPECT_NEAR(values[4] / 65535.0 * 16 - 8, -0.8, 1e-3) << "x of the first wheel";
    EXPECT_NEAR(values[5] / 65535.0 * 16 - 8, -0.3396, 1e-3) << "y";
    EXPECT_EQ(values[7], 1) << "touches without sliding";
}

}  // namespace
}  // namespace jostle::test
