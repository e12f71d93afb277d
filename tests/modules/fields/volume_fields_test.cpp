// SPDX-License-Identifier: MIT
//
// Attraction, user-defined laws, volumes and categories.
#include <gtest/gtest.h>

#include "tests/modules/fields/with_fields.h"
#include "tests/support/near.h"

namespace jostle::modules {
namespace {

TEST(Volumes, contain_the_points_inside_them) {
    const Quat turned = from_axis_angle({0, 1, 0}, pi / 2);
    const BoxVolume box{.pose = {{10, 0, 0}, turned}, .half_extents = {1, 2, 3}};
    EXPECT_TRUE(contains(box, {12.9, 1.9, 0.9}));
    EXPECT_FALSE(contains(box, {10, 0, 1.1}));
    EXPECT_TRUE(contains(SphereVolume{{0, 5, 0}, 2}, {0, 6.9, 0}));
    EXPECT_FALSE(contains(SphereVolume{{0, 5, 0}, 2}, {0, 7.1, 0}));
    const CapsuleVolume capsule{{0, 0, 0}, {4, 0, 0}, 1};
    EXPECT_TRUE(contains(capsule, {2, 0.9, 0}));
    EXPECT_TRUE(contains(capsule, {4.9, 0, 0}));
    EXPECT_FALSE(contains(capsule, {-0.8, 0.8, 0}));
    EXPECT_TRUE(contains(Everywhere{}, {1e6, 0, 0}));
}

// A circle of radius 5 around a moving body: v^2 r = strength.
TEST(Central, moon_stays_in_orbit) {
    World world = test::make_world({.gravity = {}});
    const Vec3 drift{3, 0, 1};
    const BodyId planet =
        test::add(world, {.geometry = Sphere{0.5}, .velocity = drift, .type = BodyType::kinematic});
    const BodyId moon = test::add(
        world,
        {.geometry = Sphere{0.1}, .position = {5, 0, 0}, .velocity = drift + Vec3{0, 0, 10}});
    add_field(world, {.law = Central{.body = planet, .strength = 500, .per_mass = true}});
    // Ten orbits.
    double nearest = 5, furthest = 5;
    for (int step = 0; step < 60 * 31; step++) {
        test::must(world.step(1.0 / 60));
        const double r = length(test::position_of(world, moon) - test::position_of(world, planet));
        nearest = minimum(nearest, r), furthest = maximum(furthest, r);
    }
    RecordProperty("radius_error", std::to_string(maximum(5 - nearest, furthest - 5) / 5));
    EXPECT_NEAR(nearest, 5, 5e-3);
    EXPECT_NEAR(furthest, 5, 5e-3);
}

TEST(Central, wakes_sleeping_bodies_as_it_approaches) {
    World world = test::make_world();
    test::add_floor(world);
    const BodyId near = test::add(world, {.position = {0, 0.5, 0}});
    const BodyId far = test::add(world, {.position = {500, 0.5, 0}});
    const BodyId magnet = test::add(
        world, {.geometry = Sphere{0.2}, .position = {0, 6, -40}, .type = BodyType::kinematic});
    add_field(world, {.law = Central{.body = magnet, .strength = 30, .per_mass = true}});
    test::run(world, 3);
    ASSERT_FALSE(test::state_of(world, near).awake);
    test::must(world.set_linear_velocity(magnet, {0, 0, 20}));
    test::run(world, 1.9);
    EXPECT_TRUE(test::state_of(world, near).awake);
    EXPECT_FALSE(test::state_of(world, far).awake);
    test::must(world.destroy_body(magnet));
    test::run(world, 3);
    EXPECT_FALSE(test::state_of(world, near).awake) << "a destroyed body does not attract";
}

TEST(Fields, act_inside_their_volume_on_masked_categories) {
    World world = test::make_world({.gravity = {}});
    const BodyId inside = test::add(world, {}),
                 outside = test::add(world, {.position = {20, 0, 0}});
    const BodyId other = test::must(world.create_body(
        {.pose = {{0, 3, 0}, {}}}, {.geometry = Box{}, .filter = {.category = 4}}));
    add_field(world, {.law = Turbulence{.wind = {0, 0, 9}, .speed = 0},
                      .volume = SphereVolume{.radius = 5},
                      .mask = 1});
    test::run(world, 0.5);
    EXPECT_GT(test::velocity_of(world, inside).z, 0);
    EXPECT_EQ(test::velocity_of(world, outside).z, 0);
    EXPECT_EQ(test::velocity_of(world, other).z, 0);
}

// Turbulent air carries a light body with the velocity of the flow.
TEST(Turbulence, carries_a_light_particle_with_the_flow) {
    World world = test::make_world({.gravity = {}});
    const BodyId mote = test::must(world.create_body({.mass = 1e-4}, {.geometry = Sphere{0.1}}));
    const Turbulence air{.wind = {2, 0, 0}, .speed = 3, .scale = 8, .rate = 0.2};
    add_field(world, {.law = air});
    double off = 0;
    for (int step = 0; step < 300; step++) {
        test::must(world.step(1.0 / 60));
        if (step < 30) continue;
        const Vec3 flow = flow_at(air, test::position_of(world, mote), world.time());
        off = maximum(off, length(test::velocity_of(world, mote) - flow));
    }
    EXPECT_LT(off, 0.5);
    EXPECT_GT(length(test::position_of(world, mote)), 3);
}

// A user-defined spring: omega^2 = k / m.
TEST(UserFields, apply_the_registered_law_with_its_parameters) {
    static_cast<void>(register_user_field(
        "test_spring", [](const UserFieldInput& at) { return at.position * -at.parameters[0]; }));
    World world = test::make_world({.gravity = {}});
    const BodyId ball = test::add(world, {.position = {1, 0, 0}, .sleep_allowed = false});
    const double mass = test::state_of(world, ball).mass;
    add_field(world, {.law = UserField{.law = "test_spring", .parameters = {mass * 4 * pi * pi}}});
    test::run(world, 1);
    EXPECT_TRUE(test::near(test::position_of(world, ball), {1, 0, 0}, 1e-3));
    test::run(world, 0.5);
    EXPECT_TRUE(test::near(test::position_of(world, ball), {-1, 0, 0}, 1e-3));
}

TEST(UserFields, non_finite_force_is_ignored) {
    static_cast<void>(register_user_field("test_nonsense", [](const UserFieldInput& at) {
        return Vec3{at.mass / 0.0, 0, 0};
    }));
    World world = test::make_world({.gravity = {}});
    const BodyId ball = test::add(world, {});
    add_field(world, {.law = UserField{.law = "test_nonsense"}});
    test::run(world, 0.1);
    EXPECT_EQ(test::velocity_of(world, ball), Vec3{});
    EXPECT_TRUE(world.events().quarantined.empty());
}

TEST(Fields, errors_name_the_invalid_field) {
    World world = test::make_world();
    Fields& fields = fields_of(world);
    const auto error_of = [&](const VolumeField& field) {
        const auto key = fields.add(world, field);
        return key.ok() ? "" : key.error().message;
    };
    EXPECT_EQ(error_of({.law = Turbulence{.scale = 0}}),
              "turbulence.scale is 0; it must be from 0.01 to 1000000");
    EXPECT_EQ(error_of({.law = Waves{.components = std::vector<WaveComponent>(9)}}),
              "waves.components has 9 elements; it must have at most 8");
    EXPECT_EQ(error_of({.law = Central{.body = {77, 1}}}), "central.body is not in the world");
    EXPECT_EQ(error_of({.law = Central{}, .volume = SphereVolume{.radius = -1}}),
              "volume.radius is -1; it must be from 0.001 to 10000000");
    EXPECT_TRUE(
        error_of({.law = UserField{.law = "no_such"}})
            .starts_with("user.law is \"no_such\", which is not registered; must be one of: "));
    EXPECT_EQ(register_user_field("Bad Name", [](const UserFieldInput&) { return Vec3{}; })
                  .error()
                  .message,
              "law is \"Bad Name\"; it must be 1 to 32 of a-z, 0-9 and _");
    EXPECT_EQ(fields.remove(world, {5}).error().message, "field 5 does not exist");
    EXPECT_TRUE(fields.fields().empty());
    for (std::size_t k = 0; k < Fields::waters_max; k++) add_field(world, {.law = Waves{}});
    EXPECT_EQ(error_of({.law = Waves{}}),
              "the module already has the maximum of 4 waters; remove one first");
    EXPECT_TRUE(fields.set(world, fields.fields()[1], {.law = Waves{.level = 1}}).ok());
    while (fields.fields().size() < Fields::fields_max) add_field(world, {});
    EXPECT_EQ(error_of({}), "the module already has the maximum of 64 fields; remove one first");
}

TEST(Fields, set_and_remove_by_key) {
    World world = test::make_world({.gravity = {}});
    const BodyId box = test::add(world, {});
    Fields& fields = fields_of(world);
    const FieldKey first = add_field(world, {.law = Turbulence{.wind = {5, 0, 0}, .speed = 0}});
    const FieldKey second = add_field(world, {.law = Central{.strength = 0}});
    test::must(fields.set(world, second, {.law = Turbulence{.wind = {0, 0, 5}, .speed = 0}}));
    test::must(fields.remove(world, first));
    EXPECT_EQ(fields.fields(), std::vector{second});
    EXPECT_EQ(std::get<Turbulence>(test::must(fields.field(second)).law).wind, (Vec3{0, 0, 5}));
    test::run(world, 0.5);
    EXPECT_EQ(test::velocity_of(world, box).x, 0);
    EXPECT_GT(test::velocity_of(world, box).z, 0);
    EXPECT_NE(add_field(world, {}), first) << "keys are not reused";
}

}  // namespace
}  // namespace jostle::modules
