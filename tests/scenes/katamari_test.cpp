// SPDX-License-Identifier: MIT
//
// The player of the scene "katamari" moves many cubes, deterministically.
#include "scenes/src/katamari.h"

#include <gtest/gtest.h>

#include "jostle/physics/serialization.h"
#include "jostle/scenes/catalog.h"
#include "tests/support/step_time.h"

namespace jostle::scenes {
namespace {

using namespace physics;

using test::dt;

BuiltScene built_katamari(double seed) {
    SceneDescription scene = *find_scene("katamari");
    scene.modules[0].settings["seed"] = seed;
    auto built = build_scene(scene);
    EXPECT_TRUE(built.ok()) << built.error().message;
    return std::move(*built);
}

TEST(Katamari, attracts_over_100_cubes_inside_the_yard) {
    BuiltScene built = built_katamari(2026);
    ASSERT_EQ(built.bodies.size(), 902u);
    std::size_t moving = 0;
    double furthest = 0;
    for (int step = 0; step < 60 * 10; step++) {
        ASSERT_TRUE(built.world.step(dt).ok());
        const BodyState player = *built.world.body(built.bodies.back());
        furthest = std::max(furthest, std::abs(player.center.x) + std::abs(player.center.z));
        if (step >= 60 * 5)
            for (const BodyId id : built.bodies)
                moving += length(built.world.body(id)->linear_velocity) > 0.06 ? 1 : 0;
    }
    const double mean = static_cast<double>(moving) / (60 * 5);
    EXPECT_GT(mean, 100);
    EXPECT_LT(mean, 350);
    EXPECT_GT(furthest, 8);
    EXPECT_LT(furthest, 40);
}

TEST(Katamari, is_deterministic_for_a_seed_and_after_a_load) {
    World first = std::move(built_katamari(7).world), second = std::move(built_katamari(7).world),
          other = std::move(built_katamari(8).world);
    for (int step = 0; step < 60; step++)
        for (World* world : {&first, &second, &other}) ASSERT_TRUE(world->step(dt).ok());
    EXPECT_EQ(state_hash(first), state_hash(second));
    EXPECT_NE(state_hash(first), state_hash(other));
    World loaded = std::move(*load(save(first)));
    for (int step = 0; step < 30; step++)
        for (World* world : {&first, &loaded}) ASSERT_TRUE(world->step(dt).ok());
    EXPECT_EQ(state_hash(first), state_hash(loaded));
}

TEST(Katamari, requires_a_dynamic_player) {
    SceneDescription scene = *find_scene("katamari");
    scene.modules[0].bodies["player"] = 0;
    const auto built = build_scene(scene);
    ASSERT_FALSE(built.ok());
    EXPECT_NE(built.error().message.find("player is not dynamic"), std::string::npos)
        << built.error().message;
}

}  // namespace
}  // namespace jostle::scenes
