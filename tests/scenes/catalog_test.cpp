// SPDX-License-Identifier: MIT
#include "jostle/scenes/catalog.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace jostle::scenes {

// Scenes with more than a thousand bodies are stepped for less than one second.
int steps_of(const SceneDescription& scene) {
    return std::clamp(60000 / static_cast<int>(scene.bodies.size()), 6, 60);
}

TEST(Catalog, every_scene_builds_and_steps) {
    std::set<std::string_view> names;
    for (const CatalogEntry& entry : catalog()) {
        EXPECT_TRUE(names.insert(entry.name).second) << entry.name << " twice";
        EXPECT_FALSE(entry.description.empty());
        const auto scene = find_scene(entry.name);
        ASSERT_TRUE(scene) << entry.name;
        EXPECT_EQ(scene->name, entry.name);
        EXPECT_EQ(scene->description, entry.description);
        auto built = build_scene(*scene);
        ASSERT_TRUE(built.ok()) << entry.name << ": " << built.error().message;
        ASSERT_EQ(built->bodies.size(), scene->bodies.size());
        for (int step = 0; step < steps_of(*scene); step++) {
            ASSERT_TRUE(built->world.step(1 / scene->hz).ok());
            EXPECT_TRUE(built->world.events().quarantined.empty()) << entry.name;
        }
    }
    for (const char* name : {"sandbox", "pyramid", "dominoes", "pile", "billiards", "stack"})
        EXPECT_TRUE(names.contains(name)) << name;
}

TEST(Catalog, unknown_scene_returns_nullopt) {
    EXPECT_FALSE(find_scene("nowhere"));
}

TEST(Catalog, pyramid_has_465_boxes_on_a_floor) {
    EXPECT_EQ(find_scene("pyramid")->bodies.size(), 466u);
}

// The first domino is pushed and the last one falls: nothing stops the wave.
TEST(Catalog, all_120_dominoes_fall) {
    const auto scene = find_scene("dominoes");
    auto built = build_scene(*scene);
    ASSERT_TRUE(built.ok());
    for (int step = 0; step < 60 * 20; step++) ASSERT_TRUE(built->world.step(1.0 / 60).ok());
    int fallen = 0;
    for (const physics::BodyId id : built->bodies)
        if (const auto body = built->world.body(id); body->type == physics::BodyType::dynamic)
            fallen += body->pose.position.y < 0.45 ? 1 : 0;
    EXPECT_EQ(fallen, 120);
}

TEST(Catalog, errors_name_the_body) {
    SceneDescription scene{.name = "bad"};
    scene.bodies.push_back({.name = "ramp", .body = {}, .shapes = {}, .color = {}});
    const auto built = build_scene(scene);
    ASSERT_FALSE(built.ok());
    EXPECT_EQ(built.error().message, "bodies[0] 'ramp': has no shape; it must have at least one");
}

}  // namespace jostle::scenes
