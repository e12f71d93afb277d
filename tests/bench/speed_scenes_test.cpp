// SPDX-License-Identifier: MIT
//
// The measured scenes and their settings. Their content: tests/scenes/bench_scenes_test.cpp.
#include "bench/speed/speed_scenes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "bench/speed/accuracy_check.h"
#include "bench/speed/portable_scene.h"
#include "tests/support/near.h"

namespace {

using namespace jostle::bench;
using jostle::physics::Vec3;
using jostle::scenes::SceneDescription;
using jostle::test::near;

TEST(SpeedScenes, names_are_nine_letters_and_twelve_words) {
    std::string letters;
    for (const SpeedScene& s : speed_scenes()) letters += std::string(" ") + s.letter;
    EXPECT_EQ(letters,
              " a b c d e f g h i trees convex_pile washer hull_terrain chain rain vehicles rods "
              "box_shot brick_wall l_shapes junkyard");
    EXPECT_EQ(find_speed_scene("j"), nullptr);
    EXPECT_EQ(find_speed_scene(""), nullptr);
}

TEST(SpeedScenes, every_scene_is_in_the_catalogue_and_portable) {
    for (const SpeedScene& speed_scene : speed_scenes()) {
        SCOPED_TRACE(speed_scene.name);
        EXPECT_EQ(find_speed_scene(speed_scene.letter), find_speed_scene(speed_scene.name));
        const SceneDescription scene = build(speed_scene);
        EXPECT_NE(scene.description.find(std::string("(benchmark ") + speed_scene.letter + ")"),
                  std::string::npos);
        const auto portable = check_portable(scene);
        EXPECT_TRUE(portable.ok()) << portable.error().message;
        const std::string letter = speed_scene.letter;
        EXPECT_EQ(speed_scene.steps, letter == "i" ? 120 : letter == "box_shot" ? 240 : 600);
    }
}

// Engines resolve initial overlaps in different ways, which the benchmark does not measure.
// Connected bones of a ragdoll may overlap, and the random placement of piles causes some overlaps.
TEST(SpeedScenes, no_bodies_overlap_at_the_start) {
    for (const SpeedScene& speed_scene : speed_scenes()) {
        const SceneDescription scene = build(speed_scene);
        if (scene.name == "bench_joint_grid_10000" || scene.name == "bench_pile_5000" ||
            scene.name == "bench_ragdolls_40" || scene.name == "bench_rain")
            continue;
        std::vector<jostle::physics::Transform> poses;
        for (const auto& body : scene.bodies) poses.push_back(body.body.pose);
        EXPECT_LT(AccuracyCheck(scene).penetration(poses).deepest, 1e-9) << scene.name;
    }
}

TEST(SpeedScenes, player_moves_straight_and_then_in_a_circle) {
    const SpeedScene& e = *find_speed_scene("e");
    EXPECT_EQ(player_of(e, build(e)), 901u);
    EXPECT_EQ(player_of(*find_speed_scene("a"), build(e)), std::nullopt);
    EXPECT_EQ(player_velocity(149 / 60.0), (Vec3{6, 0, 0}));
    const double turned = 0.8 * (5 - 2.5);
    EXPECT_TRUE(near(player_velocity(5), {6 * std::cos(turned), 0, 6 * std::sin(turned)}, 1e-12));
}

}  // namespace
