// SPDX-License-Identifier: MIT
#include "jostle/scenes/catalog.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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

// The viewer has a vertical field of view of 55 degrees, on a screen of 16:10.
TEST(Catalog, views_show_the_moving_bodies) {
    constexpr double tan_y = 0.5206, tan_x = 1.6 * tan_y;
    int views = 0;
    for (const CatalogEntry& entry : catalog()) {
        const auto scene = find_scene(entry.name);
        if (!scene->view) continue;
        views++;
        const auto& [eye, target, field_of_view] = *scene->view;
        EXPECT_EQ(field_of_view, 0) << entry.name;
        const physics::Vec3 ahead = normalized(target - eye);
        const physics::Vec3 right = normalized(cross(ahead, physics::Vec3{0, 1, 0}));
        const physics::Vec3 up = cross(right, ahead);
        int shown = 0, moving = 0;
        for (const SceneBody& body : scene->bodies) {
            if (body.body.type != physics::BodyType::dynamic) continue;
            moving++;
            const physics::Vec3 at = body.body.pose.position - eye;
            const double depth = dot(at, ahead);
            if (depth > 0 && std::abs(dot(at, right)) < 0.9 * tan_x * depth &&
                std::abs(dot(at, up)) < 0.9 * tan_y * depth)
                shown++;
        }
        EXPECT_GE(shown, 0.97 * moving) << entry.name << " of " << moving;
    }
    EXPECT_EQ(views, 8);
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
