// SPDX-License-Identifier: MIT
//
// What a joint's fields may be is read from the table of kinds: an error names the field's path.
#include "physics/src/world/joint_checks.h"

#include <gtest/gtest.h>

#include <limits>

#include "jostle/physics/joint_fields.h"

namespace jostle::test {
namespace {
using namespace physics;

std::string error_of(const JointKind& kind) {
    const Status status = check_kind(kind);
    return status.ok() ? "" : status.error().message;
}

TEST(JointChecks, default_of_every_kind_is_valid) {
    int kinds = 0;
    for_each_joint_kind([&](const auto& kind) {
        EXPECT_EQ(error_of(kind), "");
        kinds++;
    });
    EXPECT_EQ(kinds, joint_kinds);
}

TEST(JointChecks, errors_name_the_field_by_its_path) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const struct {
        JointKind kind;
        const char* path;
    } faults[] = {
        {HingeJoint{.limit = {true, 1, 0.5}}, "hinge.limit.lower"},
        {HingeJoint{.limit = {true, -4, 0}}, "hinge.limit.lower"},
        {HingeJoint{.motor = {true, nan, 1}}, "hinge.motor.speed"},
        {HingeJoint{.motor = {true, 1, -1}}, "hinge.motor.max_torque"},
        {ConeTwistJoint{.swing = 4}, "cone_twist.swing"},
        {FixedJoint{.angular = {.hertz = -1}}, "fixed.angular.hertz"},
        {DistanceJoint{.min_length = 2, .max_length = 1}, "distance.max_length"},
        {VelocityRow{.angular_b = {0, nan, 0}}, "velocity_row.angular_b"},
        {VelocityRow{.softness = -1}, "velocity_row.softness"},
        {VelocityRow{.lower = 2, .upper = 1}, "velocity_row.upper"},
        {SliderJoint{.limit = {true, 1, -1}}, "slider.limit.lower"},
        {SliderJoint{.motor = {true, 1, -1}}, "slider.motor.max_force"},
        {SliderJoint{.friction_force = nan}, "slider.friction_force"},
        {SixDofJoint{SixDofAxes{.y = {.free = true, .motor = {true, 1, -1}}}},
         "six_dof.y.motor.most"},
        {SixDofJoint{SixDofAxes{.rotation_z = {.free = true, .limit = {true, -4, 4}}}},
         "six_dof.turn_z.limit.lower"},
        {SixDofJoint{SixDofAxes{.x = {.friction = 1}}}, "six_dof.x is locked"},
        {WheelJoint{.suspension = {.hertz = -1}}, "wheel.suspension.hertz"},
        {WheelJoint{.steering = 4}, "wheel.steering"},
        {GrabJoint{.target = {nan, 0, 0}}, "grab.target"},
        {GrabJoint{.max_force = -1}, "grab.max_force"},
        {GearJoint{.ratio = nan}, "gear.ratio"},
        {RackJoint{.radius = 1e7}, "rack.radius"},
        {PulleyJoint{.ratio = 0}, "pulley.ratio"},
        {PathJoint{.points = {{0, 0, 0}}}, "path.points has 1 points; it must have 2 to 1024"},
        {PathJoint{.points = {{0, 0, 0}, {0, 0, 0}}}, "path.points[1] coincides"},
        {PathJoint{.points = {{0, 0, 0}, {nan, 0, 0}}}, "path.points[1]"},
        {BallJoint{.drive = {.spring = {.hertz = -1}}}, "ball.drive.spring.hertz"},
        {BallJoint{.drive = {.target = {0, 0, 0, 0}}}, "ball.drive.target"},
        {ConeTwistJoint{.drive = {.max_torque = nan}}, "cone_twist.drive.max_torque"},
    };
    for (const auto& [kind, path] : faults)
        EXPECT_NE(error_of(kind).find(path), std::string::npos) << path << ": " << error_of(kind);
}

}  // namespace
}  // namespace jostle::test
