// SPDX-License-Identifier: MIT
//
// The hovercraft example in its scene: it stays above the waves, on its circle, and continues
// identically after a load and after a restore point.
#include "examples/hovercraft/hovercraft.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "jostle/physics/restore_point.h"
#include "jostle/physics/serialization.h"
#include "jostle/scenes/catalog.h"
#include "tests/support/step_time.h"

namespace jostle::scenes {
namespace {

using namespace physics;

using test::dt;

void ride(World& world, int seconds) {
    for (int step = 0; step < 60 * seconds; step++) ASSERT_TRUE(world.step(dt).ok());
}

BuiltScene built_scene() {
    auto built = build_scene(*find_scene("hovercraft"));
    EXPECT_TRUE(built.ok()) << built.error().message;
    return std::move(*built);
}

TEST(Hovercraft, follows_its_circle_over_the_waves) {
    BuiltScene built = built_scene();
    const BodyId craft = built.bodies[1];
    ride(built.world, 5);
    double nearest = 1e9, furthest = 0, slowest = 1e9;
    for (int step = 0; step < 60 * 30; step++) {
        ASSERT_TRUE(built.world.step(dt).ok());
        const BodyState state = *built.world.body(craft);
        const auto hit = built.world.queries().cast_ray(
            {.origin = state.center, .motion = {0, -10, 0}}, {.ignore = craft});
        ASSERT_TRUE(hit.ok() && hit->has_value());
        nearest = std::min(nearest, (*hit)->fraction * 10);
        furthest = std::max(furthest, (*hit)->fraction * 10);
        slowest = std::min(slowest, length(state.linear_velocity));
    }
    // Thrusters hover at 1.2 m and are 0.3 m below the centre.
    EXPECT_GT(nearest, 0.7);
    EXPECT_LT(furthest, 2.6);
    EXPECT_GT(slowest, 4);
}

TEST(Hovercraft, continues_bit_identically_after_load_and_restore) {
    World world = std::move(built_scene().world);
    ride(world, 3);
    RestorePoint point;
    point.capture(world);
    World again = std::move(*load(save(world)));
    ride(world, 5);
    ride(again, 5);
    const std::uint64_t hash = state_hash(world);
    EXPECT_EQ(hash, state_hash(again));
    ASSERT_TRUE(point.restore(world).ok());
    EXPECT_NE(hash, state_hash(world));
    ride(world, 5);
    EXPECT_EQ(hash, state_hash(world));
}

// The values described in WIRE.md and drawn by the viewer.
TEST(Hovercraft, publishes_its_thrusters_in_20_values) {
    BuiltScene built = built_scene();
    ride(built.world, 2);
    ChannelWriter writer([](BodyId) { return 7u; });
    built.world.module("hovercraft")->publish(built.world, writer);
    ASSERT_EQ(writer.channels().size(), 1u);
    EXPECT_EQ(writer.channels()[0].entity, 7u);
    EXPECT_EQ(writer.channels()[0].values.size(), 20u);
}

TEST(Hovercraft, rejects_unknown_settings_and_bodies) {
    const auto error_of = [](const auto& change) {
        SceneDescription scene = *find_scene("hovercraft");
        change(scene.modules[0]);
        const auto built = build_scene(scene);
        return built.ok() ? "" : built.error().message;
    };
    EXPECT_EQ(error_of([](SceneModule& m) {
                  m.settings = {{"colour", 1}};
              }),
              "modules[0] 'hovercraft': has no setting colour; it has height, speed and radius");
    EXPECT_EQ(error_of([](SceneModule& m) {
                  m.settings = {{"speed", 99}};
              }),
              "modules[0] 'hovercraft': speed: 99.000000 is out of range; must be from 0.000000 to "
              "20.000000");
    EXPECT_EQ(error_of([](SceneModule& m) { m.bodies = {}; }),
              "modules[0] 'hovercraft': body craft is missing");
    EXPECT_EQ(error_of([](SceneModule& m) {
                  m.bodies = {{"craft", 0}};
              }),
              "modules[0] 'hovercraft': craft is not dynamic; use BODY_TYPE_DYNAMIC");
}

}  // namespace
}  // namespace jostle::scenes
