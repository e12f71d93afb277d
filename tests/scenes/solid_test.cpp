// SPDX-License-Identifier: MIT
//
// A closed mesh in a scene file becomes a dynamic body of hulls.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jostle/physics/compound.h"
#include "jostle/scenes/scene_file.h"

namespace jostle::scenes {
namespace {

using namespace physics;

// An L of three unit cubes; without its last triangle it is open.
std::string scene(const std::string& more, bool open = false) {
    std::string indices;
    const int outline[] = {0, 1, 2, 3, 4, 5};
    const auto add = [&](int a, int b, int c) {
        for (const int k : {a, b, c}) indices += (indices.empty() ? "" : ",") + std::to_string(k);
    };
    for (const int k : outline) {
        const int next = (k + 1) % 6;
        add(k, next, 6 + next);
        add(k, 6 + next, 6 + k);
    }
    for (int k = 1; k < 5; k++) {
        add(0, k + 1, k);
        if (!open || k < 4) add(6, 6 + k, 6 + k + 1);
    }
    std::string vertices;
    for (const int z : {0, 1})
        for (const auto& [x, y] : {std::pair{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}})
            vertices += std::string(vertices.empty() ? "" : ",") + "{\"x\":" + std::to_string(x) +
                        ",\"y\":" + std::to_string(y) + ",\"z\":" + std::to_string(z) + "}";
    return R"({"name": "a", "bodies": [{"name": "l", "position": {"y": 3}, "shapes": [
        {"solid": {"mesh": {"vertices": [)" +
           vertices + "], \"indices\": [" + indices + "]}" + more + "}}]}]}";
}

TEST(Solid, closed_mesh_becomes_a_dynamic_body) {
    const auto description = read_scene_json(scene(""));
    ASSERT_TRUE(description.ok()) << description.error().message;
    const auto built = build_scene(*description);
    ASSERT_TRUE(built.ok());
    const ShapeState shape = *built->world.shape(built->world.shapes_of(built->bodies[0])[0]);
    EXPECT_EQ(std::get<Compound>(shape.geometry).data->children.size(), 2u);
    EXPECT_NEAR(built->world.body(built->bodies[0])->mass, 3000, 1e-6);
    const auto again = read_scene_json(write_scene_json(*description));
    EXPECT_TRUE(again.ok()) << "written as a compound";
}

TEST(Solid, single_part_is_the_convex_hull_of_the_mesh) {
    const auto description = read_scene_json(scene(", \"parts_max\": 1"));
    ASSERT_TRUE(description.ok()) << description.error().message;
    const auto built = build_scene(*description);
    EXPECT_NEAR(built->world.body(built->bodies[0])->mass, 3500, 1e-6);
}

TEST(Solid, errors_name_the_invalid_field) {
    const auto message_of = [](const std::string& json) {
        const auto description = read_scene_json(json);
        return description.ok() ? std::string() : description.error().message;
    };
    EXPECT_THAT(message_of(scene("", true)),
                testing::HasSubstr("bodies[0].shapes[0].solid: the mesh is not a solid: the edge"));
    EXPECT_THAT(message_of(scene(", \"parts_max\": 999")),
                testing::HasSubstr("solid.parts_max: 999 is out of range"));
}

}  // namespace
}  // namespace jostle::scenes
