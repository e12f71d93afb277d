// SPDX-License-Identifier: MIT
//
// The measured scenes and their settings. Their content: tests/scenes/bench_scenes_test.cpp.
#include "bench/speed/speed_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bench/speed/accuracy_check.h"
#include "bench/speed/portable_scene.h"
#include "jostle/scenes/catalog.h"
#include "tests/support/near.h"

namespace {

using namespace jostle::bench;
using jostle::physics::Vec3;
using jostle::scenes::SceneDescription;
using jostle::test::near;

TEST(SpeedScenes, names_are_nine_letters_and_26_words) {
    std::string letters;
    for (const SpeedScene& s : speed_scenes()) letters += std::string(" ") + s.letter;
    EXPECT_EQ(letters,
              " a b c d e f g h i trees convex_pile washer hull_terrain chain rain vehicles rods "
              "box_shot brick_wall l_shapes junkyard drum hull_heap wheels wheels_mesh "
              "hanging_chain hinge_chain joint_tree debris mesh ragdoll_pile mixed_masses stacks "
              "spheres capsules");
    EXPECT_EQ(find_speed_scene("j"), nullptr);
    EXPECT_EQ(find_speed_scene(""), nullptr);
}

TEST(SpeedScenes, every_scene_has_a_description_and_is_portable) {
    for (const SpeedScene& speed_scene : speed_scenes()) {
        SCOPED_TRACE(speed_scene.name);
        EXPECT_EQ(find_speed_scene(speed_scene.letter), find_speed_scene(speed_scene.name));
        const SceneDescription scene = build(speed_scene);
        EXPECT_EQ(scene.name, speed_scene.name);
        EXPECT_EQ(is_in_catalogue(speed_scene),
                  jostle::scenes::find_scene(speed_scene.name).has_value());
        EXPECT_NE(scene.description.find(std::string("(benchmark ") + speed_scene.letter + ")"),
                  std::string::npos);
        const auto portable = check_portable(scene);
        EXPECT_TRUE(portable.ok()) << portable.error().message;
        const std::string letter = speed_scene.letter;
        if (is_in_catalogue(speed_scene))
            EXPECT_EQ(speed_scene.steps, letter == "i" ? 120 : letter == "box_shot" ? 240 : 600);
        else
            EXPECT_TRUE(speed_scene.all_move);
    }
}

// Engines resolve initial overlaps in different ways, which the benchmark does not measure.
// Connected bones of a ragdoll may overlap, and the random placement of piles causes some overlaps.
TEST(SpeedScenes, no_bodies_overlap_at_the_start) {
    for (const SpeedScene& speed_scene : speed_scenes()) {
        const SceneDescription scene = build(speed_scene);
        if (scene.name == "bench_joint_grid_10000" || scene.name == "bench_pile_5000" ||
            scene.name == "bench_ragdolls_40" || scene.name == "bench_rain" ||
            scene.name == "bench_ragdoll_pile")
            continue;
        std::vector<jostle::physics::Transform> poses;
        for (const auto& body : scene.bodies) poses.push_back(body.body.pose);
        EXPECT_LT(AccuracyCheck(scene).penetration(poses).deepest, 1e-9) << scene.name;
    }
}

ParameterValues chosen(Parameter parameter, double value) {
    ParameterValues values;
    values[static_cast<std::size_t>(parameter)] = value;
    return values;
}

// With coarse meshes, which build fast, unless the parameter is their cell size.
SceneDescription built(const char* scene, Parameter parameter, double value) {
    ParameterValues values = chosen(Parameter::cell, 10);
    values[static_cast<std::size_t>(parameter)] = value;
    return build(*find_speed_scene(scene), values);
}

std::string error_of(std::initializer_list<const char*> scenes, Parameter parameter, double value) {
    std::vector<const SpeedScene*> selected;
    for (const char* scene : scenes) selected.push_back(find_speed_scene(scene));
    const auto status = check_parameters(selected, chosen(parameter, value));
    return status ? "" : status.error().message;
}

TEST(SpeedScenes, count_is_the_number_of_dynamic_bodies) {
    const struct {
        const char* scene;
        int bodies_per_count, fixed;
    } cases[] = {{"chain", 1, 0},         {"hanging_chain", 1, 1}, {"hinge_chain", 1, 1},
                 {"joint_tree", 89, 0},   {"debris", 1, 1},        {"mesh", 1, 1},
                 {"ragdoll_pile", 11, 5}, {"mixed_masses", 1, 5},  {"stacks", 3, 1},
                 {"spheres", 1, 5},       {"capsules", 1, 5},      {"hull_heap", 1, 5}};
    for (const auto& [scene, bodies_per_count, fixed] : cases)
        for (const int count : {2, 37})
            EXPECT_EQ(built(scene, Parameter::count, count).bodies.size(),
                      static_cast<std::size_t>(bodies_per_count * count + fixed))
                << scene;
}

TEST(SpeedScenes, chain_of_default_length_equals_that_of_the_catalogue) {
    const SceneDescription chain = build(*find_speed_scene("chain"));
    const SceneDescription catalogued = *jostle::scenes::find_scene("bench_chain");
    ASSERT_EQ(chain.bodies.size(), catalogued.bodies.size());
    EXPECT_EQ(chain.bodies.back().body.pose, catalogued.bodies.back().body.pose);
    EXPECT_EQ(chain.joints.size(), 999u);
    EXPECT_EQ(chain.description, catalogued.description);
}

TEST(SpeedScenes, wheels_are_the_bodies_of_60_vehicles) {
    for (const char* scene : {"wheels", "wheels_mesh"})
        for (const int wheels : {2, 4, 10, 32}) {
            const SceneDescription s = built(scene, Parameter::wheels, wheels);
            EXPECT_EQ(s.bodies.size(), 1u + 60 * (1 + static_cast<std::size_t>(wheels))) << scene;
            EXPECT_EQ(s.joints.size(), 60 * static_cast<std::size_t>(wheels)) << scene;
        }
}

TEST(SpeedScenes, vertices_are_those_of_each_hull) {
    for (const int vertices : {8, 30, 62, 64, 128}) {
        const SceneDescription s = built("hull_heap", Parameter::vertices, vertices);
        for (std::size_t k = 5; k < s.bodies.size(); k++) {
            const auto hull = std::get<jostle::physics::Hull>(s.bodies[k].shapes[0].geometry);
            ASSERT_EQ(hull.data->vertices.size(), static_cast<std::size_t>(vertices));
        }
    }
}

TEST(SpeedScenes, cell_sets_the_number_of_triangles) {
    const auto triangles = [](const char* scene, double cell) {
        const SceneDescription s = built(scene, Parameter::cell, cell);
        return std::get<jostle::physics::Mesh>(s.bodies[0].shapes[0].geometry)
            .data->triangles.size();
    };
    EXPECT_EQ(triangles("mesh", 0.5), 2u * 300 * 300);
    EXPECT_EQ(triangles("mesh", 10), 2u * 15 * 15);
    EXPECT_EQ(triangles("wheels_mesh", 0.4), 2u * 220 * 220);
    EXPECT_EQ(triangles("wheels_mesh", 2), 2u * 44 * 44);
}

TEST(SpeedScenes, drum_turns_at_the_chosen_speed) {
    const SceneDescription s = built("drum", Parameter::drum_speed, 180);
    EXPECT_EQ(s.bodies[0].body.type, jostle::physics::BodyType::kinematic);
    EXPECT_NEAR(s.bodies[0].body.angular_velocity.z, jostle::physics::pi, 1e-12);
    EXPECT_EQ(s.bodies.size(), 2003u);
}

TEST(SpeedScenes, mixed_masses_have_densities_from_10_to_10000) {
    const SceneDescription s = build(*find_speed_scene("mixed_masses"));
    double least = 1e9, most = 0;
    for (std::size_t k = 5; k < s.bodies.size(); k++) {
        least = std::min(least, s.bodies[k].shapes[0].density);
        most = std::max(most, s.bodies[k].shapes[0].density);
    }
    EXPECT_EQ(least, 10);
    EXPECT_NEAR(most, 10000, 1e-6);
}

TEST(SpeedScenes, small_and_large_parameters_are_portable_and_free_of_overlaps) {
    for (const SpeedScene& speed_scene : speed_scenes())
        for (const ParameterRange& range : speed_scene.parameters) {
            const double small = range.parameter == Parameter::cell ? 1 : range.least;
            const double large = std::min(range.most, 40.0);
            for (const double value : {small, large}) {
                const SceneDescription scene = built(speed_scene.letter, range.parameter, value);
                SCOPED_TRACE(std::string(speed_scene.letter) + " " + std::to_string(value));
                EXPECT_TRUE(check_portable(scene).ok());
                if (scene.name == "bench_ragdoll_pile") continue;
                std::vector<jostle::physics::Transform> poses;
                for (const auto& body : scene.bodies) poses.push_back(body.body.pose);
                EXPECT_LT(AccuracyCheck(scene).penetration(poses).deepest, 1e-9);
            }
        }
}

TEST(SpeedScenes, parameter_error_names_option_range_and_scenes) {
    EXPECT_EQ(error_of({"wheels"}, Parameter::wheels, 34),
              "--wheels: 34 is out of range for wheels; must be 2 to 32, even; scenes with "
              "--wheels: wheels (2 to 32, even), wheels_mesh (2 to 32, even)");
    EXPECT_EQ(error_of({"a", "drum"}, Parameter::wheels, 4),
              "--wheels: no selected scene has this parameter; select one of wheels (2 to 32, "
              "even), wheels_mesh (2 to 32, even)");
    EXPECT_EQ(error_of({"a", "wheels"}, Parameter::wheels, 32), "");
    // One value must suit all selected scenes.
    EXPECT_EQ(error_of({"spheres"}, Parameter::count, 100000), "");
    EXPECT_NE(error_of({"spheres", "chain"}, Parameter::count, 100000), "");
}

TEST(SpeedScenes, refuses_hostile_values) {
    const double infinite = std::numeric_limits<double>::infinity();
    for (const double value : {0.0, -4.0, 5.0, 4.5, 1e300, infinite, -infinite, std::nan("")}) {
        EXPECT_NE(error_of({"wheels"}, Parameter::wheels, value), "") << value;
        EXPECT_NE(error_of({"hull_heap"}, Parameter::vertices, value), "") << value;
    }
    for (const double value : {0.0, -1.0, 1.5, 1e300, infinite, std::nan("")})
        EXPECT_NE(error_of({"stacks"}, Parameter::count, value), "") << value;
    for (const double value : {0.0, -0.4, 0.1999, 10.001, infinite, std::nan("")})
        EXPECT_NE(error_of({"mesh"}, Parameter::cell, value), "") << value;
    for (const double value : {-0.001, 361.0, infinite, std::nan("")})
        EXPECT_NE(error_of({"drum"}, Parameter::drum_speed, value), "") << value;
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
