// SPDX-License-Identifier: MIT
#include "server/limits/admission.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "jostle/physics/hull.h"
#include "tests/support/error_of.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;
using test::error_of;

const Clock::time_point start{};

SpawnCommand good_spawn() {
    SpawnCommand spawn;
    spawn.shape.geometry = physics::Box{{0.5, 0.5, 0.5}};
    return spawn;
}

TEST(Admission, accepts_valid_numbers) {
    EXPECT_TRUE(check_numbers(good_spawn()).ok());
    EXPECT_TRUE(check_numbers(ImpulseCommand{1, {1, 2, 3}, physics::Vec3{}}).ok());
    EXPECT_TRUE(check_numbers(ExplodeCommand{{}, 20, 20}).ok());
    EXPECT_TRUE(check_numbers(ControlCommand{{.axes = {1, -1}, .buttons = ~0u}}).ok());
    EXPECT_TRUE(check_numbers(ReleaseCommand{}).ok());
}

TEST(Admission, validates_every_number_by_name) {
    const double bad_numbers[] = {std::nan(""), std::numeric_limits<double>::infinity(), -1e9, 1e9};
    for (const double bad : bad_numbers) {
        const auto refuses = [&](const char* name, const Action& action) {
            const Status status = check_numbers(action);
            ASSERT_FALSE(status.ok()) << name << " " << bad;
            EXPECT_EQ(status.error().code, ErrorCode::invalid_argument);
            EXPECT_NE(status.error().message.find(name), std::string::npos)
                << status.error().message;
        };
        SpawnCommand spawn = good_spawn();
        spawn.pose.position.y = bad;
        refuses("position", spawn);
        spawn = good_spawn();
        spawn.linear_velocity.z = bad;
        refuses("linear_velocity", spawn);
        spawn = good_spawn();
        spawn.angular_velocity.x = bad;
        refuses("angular_velocity", spawn);
        spawn = good_spawn();
        spawn.shape.density = bad;
        refuses("density", spawn);
        spawn = good_spawn();
        spawn.shape.material.friction = bad;
        refuses("friction", spawn);
        spawn = good_spawn();
        spawn.shape.material.restitution = bad;
        refuses("restitution", spawn);
        spawn.shape.geometry = physics::Sphere{bad};
        refuses("sphere.radius", spawn);
        spawn.shape.geometry = physics::Capsule{0.5, bad};
        refuses("capsule.half_length", spawn);
        spawn.shape.geometry = physics::Box{{0.5, bad, 0.5}};
        refuses("box.half_extents.y", spawn);
        refuses("impulse", ImpulseCommand{1, {bad, 0, 0}, {}});
        refuses("point", ImpulseCommand{1, {}, physics::Vec3{0, bad, 0}});
        refuses("point", GrabCommand{1, {0, 0, bad}});
        refuses("target", DragCommand{{bad, 0, 0}});
        refuses("center", ExplodeCommand{{bad, 0, 0}, 1, 1});
        refuses("radius", ExplodeCommand{{}, bad, 1});
        refuses("speed", ExplodeCommand{{}, 1, bad});
        refuses("aim.origin", ImpulseCommand{.aim = Aim{{bad, 0, 0}, {0, 0, 1}}});
        refuses("aim.motion", GrabCommand{.aim = Aim{{}, {0, bad, 0}}});
        refuses("aim.view_time.fraction",
                ExplodeCommand{.radius = 1,
                               .speed = 1,
                               .aim = Aim{.motion = {0, 0, 1}, .view_time = ViewTime{1, bad}}});
        refuses("axes", ControlCommand{{.axes = {0, 0, bad}}});
    }
}

TEST(Admission, aim_replaces_entity_and_point_and_requires_length) {
    EXPECT_TRUE(
        check_numbers(ImpulseCommand{.impulse = {1, 0, 0}, .aim = Aim{.motion = {0, 0, 2000}}})
            .ok());
    EXPECT_EQ(error_of(check_numbers(GrabCommand{.aim = Aim{}})).message,
              "aim.motion is zero; it must have a length");
    EXPECT_EQ(error_of(check_numbers(GrabCommand{.aim = Aim{.motion = {0, 0, 2001}}})).message,
              "aim.motion is 2001 long; at most 2000 is allowed");
}

TEST(Admission, allows_six_shape_kinds_and_lists_them_in_errors) {
    SpawnCommand spawn = good_spawn();
    const auto hull_of = [](double size, int points) {
        std::vector<physics::Vec3> corners;
        for (int i = 0; i < points; i++) {
            const double turn = 2.4 * i, y = -1 + 2.0 * i / (points - 1);
            const double r = std::sqrt(1 - y * y);
            corners.push_back({size * r * std::cos(turn), size * y, size * r * std::sin(turn)});
        }
        return physics::Hull{*physics::build_hull(corners)};
    };
    for (const physics::Geometry& good :
         {physics::Geometry{physics::Sphere{2}}, physics::Geometry{physics::Capsule{0.05, 2}},
          physics::Geometry{physics::Box{{2, 2, 2}}}, physics::Geometry{physics::Cylinder{0.05, 2}},
          physics::Geometry{physics::Cone{2, 2}}, physics::Geometry{hull_of(1, 32)},
          physics::Geometry{hull_of(2, 12)}}) {
        spawn.shape.geometry = good;
        EXPECT_TRUE(check_numbers(spawn).ok()) << check_numbers(spawn).error().message;
    }
    const auto refusal_of = [&](const physics::Geometry& bad) {
        spawn.shape.geometry = bad;
        return error_of(check_numbers(spawn)).message;
    };
    const std::string allowed =
        "allowed are sphere, capsule, box, cylinder, cone, and hull of at most 32 points, with "
        "sizes from 0.05 to 2 m";
    EXPECT_EQ(refusal_of(physics::Plane{}), "a plane cannot be spawned; " + allowed);
    EXPECT_EQ(refusal_of(hull_of(1, 33)), "the hull has 33 points; " + allowed);
    EXPECT_EQ(refusal_of(physics::Cylinder{0.01, 1}),
              "cylinder.radius is 0.01; it must be from 0.05 to 2");
    EXPECT_EQ(refusal_of(physics::Cone{1, 3}), "cone.half_length is 3; it must be from 0.05 to 2");
    EXPECT_NE(refusal_of(hull_of(2.5, 32)).find("is not within 2 m"), std::string::npos);
    EXPECT_NE(refusal_of(hull_of(0.04, 32)).find("must be from 0.05 to 2"), std::string::npos)
        << "the hull has the size of a ball of 4 cm";
}

TEST(Admission, limits_explicit_mass) {
    SpawnCommand spawn = good_spawn();
    spawn.shape.mass = 50;
    EXPECT_TRUE(check_numbers(spawn).ok());
    spawn.shape.mass = 1e12;
    EXPECT_EQ(error_of(check_numbers(spawn)).message,
              "mass is 1e+12; it must be from 0.001 to 1e+06");
}

TEST(Admission, rate_limits_allow_a_one_second_burst_and_refill) {
    ClientLimits limits;
    limits.messages_per_second = 10;
    limits.inputs_per_second = 5;
    Admission admission(limits, false, start);
    for (int i = 0; i < 10; ++i) EXPECT_TRUE(admission.admit_message(1, start));
    EXPECT_FALSE(admission.admit_message(1, start));
    EXPECT_TRUE(admission.admit_message(1, start + 101ms));
    EXPECT_FALSE(admission.admit_message(1, start + 102ms));
    for (int i = 0; i < 5; ++i) EXPECT_TRUE(admission.admit_input(ReleaseCommand{}, start).ok());
    EXPECT_EQ(error_of(admission.admit_input(ReleaseCommand{}, start)).code,
              ErrorCode::resource_exhausted);
    EXPECT_TRUE(admission.admit_input(ReleaseCommand{}, start + 300ms).ok());
}

TEST(Admission, limits_bytes_per_second) {
    ClientLimits limits;
    limits.bytes_per_second = 2000;
    Admission admission(limits, false, start);
    EXPECT_TRUE(admission.admit_message(1500, start));
    EXPECT_FALSE(admission.admit_message(1500, start));
    EXPECT_TRUE(admission.admit_message(1500, start + 1s));
}

TEST(Admission, rejects_spectator_inputs) {
    Admission admission({}, true, start);
    EXPECT_TRUE(admission.admit_message(10, start)) << "spectators may send acknowledgements";
    EXPECT_EQ(error_of(admission.admit_input(ReleaseCommand{}, start)).code,
              ErrorCode::permission_denied);
}

}  // namespace
}  // namespace jostle::server
