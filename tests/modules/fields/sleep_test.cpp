// SPDX-License-Identifier: MIT
//
// A steady load wakes no body; a time-varying load keeps the affected bodies awake.
#include <gtest/gtest.h>

#include "tests/modules/fields/with_fields.h"

namespace jostle::modules {
namespace {

void add_crates(World& world, int count) {
    test::add_floor(world);
    for (int k = 0; k < count; k++)
        test::add(world, {.position = {1.5 * (k % 100), 0.5, 1.5 * (k / 100)}});
}

TEST(Sleep, crates_stay_asleep_in_steady_fields) {
    static_cast<void>(register_user_field("test_breeze", [](const UserFieldInput& at) {
        return Vec3{0.5 * at.mass, 0, 0};
    }));
    World world = test::make_world();
    add_crates(world, 5000);
    test::must(world.create_field({.force = UniformWind{.velocity = {3, 0, 0}}}));
    add_field(world, {.law = Turbulence{.wind = {3, 0, 0}, .speed = 2, .rate = 0}});
    add_field(world, {.law = Central{.strength = 0.2, .falloff = 0, .per_mass = true}});
    add_field(world, {.law = UserField{.law = "test_breeze", .steady = true}});
    add_field(world, {.law = Waves{.level = 0.2}});
    test::run(world, 2);
    RecordProperty("awake", world.summary().awake_bodies);
    EXPECT_EQ(world.summary().awake_bodies, 0);
    for (int step = 0; step < 60; step++) {
        test::must(world.step(1.0 / 60));
        ASSERT_EQ(world.summary().awake_bodies, 0) << "step " << step;
        ASSERT_TRUE(world.events().woke.empty());
    }
}

TEST(Sleep, adding_changing_and_removing_a_field_wakes_its_volume) {
    World world = test::make_world();
    test::add_floor(world);
    const BodyId inside = test::add(world, {.position = {0, 0.5, 0}});
    const BodyId outside = test::add(world, {.position = {30, 0.5, 0}});
    test::run(world, 2);
    const VolumeField field{.law = Turbulence{.wind = {2, 0, 0}, .speed = 0},
                            .volume = SphereVolume{.radius = 5}};
    Fields& fields = fields_of(world);
    const auto wakes_inside_alone = [&] {
        const bool so =
            test::state_of(world, inside).awake && !test::state_of(world, outside).awake;
        test::run(world, 2);
        return so && !test::state_of(world, inside).awake;
    };
    const FieldKey key = test::must(fields.add(world, field));
    EXPECT_TRUE(wakes_inside_alone());
    test::must(fields.set(world, key, field));
    EXPECT_TRUE(wakes_inside_alone());
    test::must(fields.remove(world, key));
    EXPECT_TRUE(wakes_inside_alone());
}

TEST(Sleep, time_varying_loads_keep_bodies_awake) {
    World world = test::make_world();
    test::add_floor(world);
    const Geometry plate = Box{{0.5, 0.5, 0.02}};
    const BodyId light =
        test::add(world, {.geometry = plate, .position = {0, 0.5, 0}, .density = 100});
    const BodyId outside =
        test::add(world, {.geometry = plate, .position = {30, 0.5, 0}, .density = 100});
    const BodyId heavy = test::add(world, {.position = {2, 0.5, 0}});
    const BodyId dry = test::add(world, {.position = {-2, 0.5, 0}});
    add_field(world, {.law = Turbulence{.speed = 1}, .volume = SphereVolume{.radius = 5}});
    add_field(world, {.law = Waves{.level = -1, .components = {{.amplitude = 0.3}}}});
    test::run(world, 3);
    EXPECT_TRUE(test::state_of(world, light).awake);
    EXPECT_FALSE(test::state_of(world, outside).awake);
    EXPECT_FALSE(test::state_of(world, heavy).awake);
    EXPECT_FALSE(test::state_of(world, dry).awake);
}

TEST(Sleep, bodies_floating_in_waves_stay_awake) {
    World world = test::make_world();
    const BodyId raft = test::add(world, {.geometry = Box{{1, 0.1, 1}}, .density = 400});
    add_field(world, {.law = Waves{.components = {{.amplitude = 0.002, .length = 60}}}});
    test::run(world, 20);
    EXPECT_TRUE(test::state_of(world, raft).awake);
}

}  // namespace
}  // namespace jostle::modules
