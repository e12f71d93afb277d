// SPDX-License-Identifier: MIT
//
// Jumps, slopes and walls, compared with closed forms.
#include <array>
#include <vector>

#include "jostle/physics/mesh.h"
#include "tests/modules/character/stage.h"

namespace jostle::modules {
namespace {

using namespace physics;

TEST(Ground, stands_still_where_it_is_placed) {
    Stage stage;
    test::add_floor(stage.world);
    const CharacterId hero = stage.add({.feet = {1, 0, 2}});
    stage.run(3);
    const CharacterState state = stage.of(hero);
    EXPECT_EQ(state.ground, GroundKind::on_ground);
    EXPECT_TRUE(test::near(state.feet, {1, 0, 2}, 1e-5));
    EXPECT_TRUE(test::near(state.velocity, {}, 1e-9));
    EXPECT_TRUE(test::near(state.ground_normal, {0, 1, 0}, 1e-9));
}

TEST(Ground, queries_and_contacts_hit_its_capsule) {
    Stage stage;
    test::add_floor(stage.world);
    const CharacterId hero = stage.add({.feet = {0, 0, 0}});
    stage.walk(hero, {3, 0, 0});
    stage.run(1);
    const CharacterState state = stage.of(hero);
    const auto hit =
        test::must(stage.world.queries().cast_ray({state.feet + Vec3{0, 1, 5}, {0, 0, -10}}));
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->body, state.body);
    EXPECT_NEAR(hit->point.z, 0.28, 1e-6) << "the radius minus the skin";
    EXPECT_EQ(stage.crowd->character_of(hit->body), hero);
}

// The pose of the body, which follows by its velocity, equals that of the character.
TEST(Ground, walks_at_the_requested_speed) {
    Stage stage;
    test::add_floor(stage.world);
    const CharacterId hero = stage.add({.feet = {0, 0, 0}});
    stage.walk(hero, {3, 0, 4});
    stage.run(1);
    const Vec3 start = stage.of(hero).feet;
    stage.run(10);
    EXPECT_TRUE(test::near(stage.of(hero).feet - start, {30, 0, 40}, 1e-4));
    EXPECT_TRUE(
        test::near(test::position_of(stage.world, stage.of(hero).body), stage.of(hero).feet, 1e-9));
    EXPECT_NEAR(stage.of(hero).heading, arc_tangent(-3, -4), 1e-6);
}

double apex(CharacterKind kind, double speed, double rate) {
    Stage stage;
    test::add_floor(stage.world);
    const CharacterId hero =
        stage.add({.kind = kind, .feet = {0, 0, 0}, .abilities = {.jump_speed = speed}});
    stage.run(0.5, rate);
    stage.steer(hero, {.jump = true});
    const double floor = stage.of(hero).feet.y;
    double highest = floor;
    for (int k = 0; k < 2 * rate; k++) {
        stage.run(1 / rate, rate);
        // The rest of the parabola.
        const CharacterState state = stage.of(hero);
        const double rise = maximum(state.velocity.y, 0);
        highest = maximum(highest, state.feet.y + rise * rise / (2 * 9.81));
    }
    EXPECT_EQ(stage.of(hero).ground, GroundKind::on_ground) << "a held button jumps once";
    return highest - floor;
}

TEST(Ground, jump_height_matches_jump_speed) {
    double worst = 0, worst_rigid = 0;
    for (const CharacterKind kind : {CharacterKind::sweeping, CharacterKind::rigid})
        for (const double speed : {2.0, 5.0, 8.0})
            for (const double rate : {30.0, 60.0, 240.0}) {
                const double height = speed * speed / (2 * 9.81);
                const double off = absolute(apex(kind, speed, rate) / height - 1);
                EXPECT_LE(off, 0.01) << speed << " m/s at " << rate << " Hz";
                double& kind_worst = kind == CharacterKind::sweeping ? worst : worst_rigid;
                kind_worst = maximum(kind_worst, off);
            }
    record("jump_apex_relative_error", worst);
    record("rigid_jump_apex_relative_error", worst_rigid);
    EXPECT_LE(worst, 1e-5);
}

TEST(Ground, jumps_again_only_after_button_release) {
    Stage stage;
    test::add_floor(stage.world);
    const CharacterId hero = stage.add({.feet = {0, 0, 0}});
    stage.run(0.2);
    for (int k = 0; k < 2; k++) {
        stage.steer(hero, {.jump = true});
        stage.run(0.2);
        EXPECT_EQ(stage.of(hero).ground, GroundKind::in_air);
        stage.run(2);
        EXPECT_EQ(stage.of(hero).ground, GroundKind::on_ground);
        stage.steer(hero, {});
        stage.run(0.1);
    }
}

TEST(Ground, walks_slopes_one_degree_below_its_limit) {
    double worst = 0;
    for (const double limit : {20.0, 35.0, 50.0, 65.0}) {
        const double angle = radians(limit - 1);
        Stage stage;
        add_slope(stage.world, angle);
        const CharacterId hero = stage.add(
            {.feet = feet_on_slope(angle, 0.3, 0), .abilities = {.slope_limit = radians(limit)}});
        stage.run(0.1);
        const Vec3 stood = stage.of(hero).feet;
        EXPECT_TRUE(test::near(stood, feet_on_slope(angle, 0.3, 0), 0.003));
        stage.run(3);
        EXPECT_TRUE(test::near(stage.of(hero).feet, stood, 1e-6)) << "stands still";
        for (const double speed : {3.0, -3.0}) {
            stage.walk(hero, {speed, 0, 0});
            stage.run(0.5);
            const Vec3 start = stage.of(hero).feet;
            stage.run(3);
            EXPECT_EQ(stage.of(hero).ground, GroundKind::on_ground);
            const double off =
                length(stage.of(hero).feet - start - feet_on_slope(angle, 0, 3 * speed));
            worst = maximum(worst, off);
        }
    }
    record("walk_on_slope_error_m", worst);
    EXPECT_LE(worst, 0.001);
}

// Slides with g sin(angle), regardless of its controls, and never moves up.
TEST(Ground, slides_down_slopes_one_degree_above_its_limit) {
    double worst = 0;
    for (const double limit : {20.0, 35.0, 50.0, 65.0})
        for (const double walk : {0.0, 3.0}) {
            const double angle = radians(limit + 1);
            Stage stage;
            add_slope(stage.world, angle);
            const CharacterId hero = stage.add({.feet = feet_on_slope(angle, 0.3, 0),
                                                .abilities = {.slope_limit = radians(limit)}});
            stage.walk(hero, {walk, 0, 0});
            stage.run(0.2);
            EXPECT_EQ(stage.of(hero).ground, GroundKind::on_steep_ground);
            const double start = length(stage.of(hero).velocity);
            stage.run(2);
            const CharacterState state = stage.of(hero);
            EXPECT_LT(state.velocity.x, 0);
            const double a = (length(state.velocity) - start) / 2;
            worst = maximum(worst, absolute(a / (9.81 * sin_cos(angle).sin) - 1));
        }
    record("slide_acceleration_relative_error", worst);
    EXPECT_LE(worst, 0.02);
}

TEST(Ground, cannot_walk_from_level_ground_onto_a_too_steep_slope) {
    for (const double speed : {0.5, 3.0, 10.0}) {
        Stage stage;
        test::add_floor(stage.world);
        add_slope(stage.world, radians(51));
        const CharacterId hero = stage.add({.feet = {-3, 0, 0}});
        stage.walk(hero, {speed, 0, 0});
        double highest = 0;
        for (int k = 0; k < 600; k++) {
            stage.run(1 / hz);
            highest = maximum(highest, stage.of(hero).feet.y);
        }
        EXPECT_LE(highest, 0.001) << speed;
        EXPECT_GT(stage.of(hero).feet.x, -0.2) << "it stops in front of the slope";
    }
}

TEST(Ground, slides_along_a_wall_and_stops_in_a_corner) {
    Stage stage;
    test::add_floor(stage.world);
    test::add_static(stage.world, {.geometry = Box{{0.5, 2, 20}}, .position = {2.5, 2, 0}});
    test::add_static(stage.world, {.geometry = Box{{20, 2, 0.5}}, .position = {0, 2, 10.5}});
    const CharacterId hero = stage.add({.feet = {0, 0, 0}});
    stage.walk(hero, {2, 0, 2});
    stage.run(3);
    EXPECT_NEAR(stage.of(hero).feet.x, 2 - 0.3, 1e-4);
    EXPECT_TRUE(test::near(stage.of(hero).velocity, {0, 0, 2}, 1e-6));
    stage.run(7);
    EXPECT_TRUE(test::near(stage.of(hero).feet, {1.7, 0, 9.7}, 1e-4));
    EXPECT_TRUE(test::near(stage.of(hero).velocity, {}, 1e-6));
}

// Edges between coplanar triangles are not obstacles.
TEST(Ground, flat_mesh_walks_like_a_plane) {
    std::vector<Vec3> corners;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    constexpr std::uint32_t n = 60;
    for (std::uint32_t row = 0; row <= n; row++)
        for (std::uint32_t column = 0; column <= n; column++)
            corners.push_back({column - 30.0, 0, row - 30.0});
    for (std::uint32_t row = 0; row < n; row++)
        for (std::uint32_t column = 0; column < n; column++) {
            const std::uint32_t a = row * (n + 1) + column, b = a + 1, c = a + n + 1, d = c + 1;
            triangles.push_back({a, c, b});
            triangles.push_back({b, c, d});
        }
    Stage stage;
    test::add_static(stage.world, {.geometry = Mesh{test::must(build_mesh(corners, triangles))}});
    const CharacterId hero = stage.add({.feet = {-25.2, 0, -14.9}});
    stage.walk(hero, {4, 0, 2.7});
    stage.run(0.5);
    const Vec3 start = stage.of(hero).feet;
    double worst = 0;
    for (int k = 0; k < 600; k++) {
        stage.run(1 / hz);
        const Vec3 expected = start + Vec3{4, 0, 2.7} * ((k + 1) / hz);
        worst = maximum(worst, length(stage.of(hero).feet - expected));
    }
    record("level_triangles_error_m", worst);
    EXPECT_LE(worst, 1e-5);
}

// A character placed inside a solid leaves it and stands.
TEST(Ground, recovers_from_initial_overlap) {
    Stage stage;
    test::add_floor(stage.world);
    test::add_static(stage.world, {.geometry = Box{{0.5, 1.5, 4}}, .position = {0, 1.5, 0}});
    const CharacterId hero = stage.add({.feet = {0.4, 0, 0}});
    stage.run(2);
    EXPECT_NEAR(stage.of(hero).feet.x, 0.8, 0.001);
    EXPECT_NEAR(stage.of(hero).feet.y, 0, 0.001);
    EXPECT_EQ(stage.of(hero).ground, GroundKind::on_ground);
}

TEST(Ground, falls_on_a_parabola_after_walking_off_an_edge) {
    Stage stage;
    test::add_static(stage.world, {.geometry = Box{{2, 5, 2}}, .position = {0, -5, 0}});
    const CharacterId hero =
        stage.add({.feet = {0, 0, 0}, .abilities = {.floor_snap = 0, .air_acceleration = 0}});
    stage.run(0.1);
    stage.walk(hero, {4, 0, 0});
    while (stage.of(hero).ground != GroundKind::in_air) stage.run(1 / hz);
    const CharacterState start = stage.of(hero);
    stage.run(0.5);
    const Vec3 fall = start.feet + start.velocity * 0.5 + Vec3{0, -9.81 * 0.125, 0};
    EXPECT_TRUE(test::near(stage.of(hero).feet, fall, 1e-6));
}

TEST(Ground, follows_a_descending_floor) {
    Stage stage;
    add_slope(stage.world, radians(-30));
    test::add_static(stage.world, {.geometry = Box{{5, 1, 5}}, .position = {-5, -1, 0}});
    const CharacterId hero = stage.add({.feet = {-3, 0, 0}});
    stage.walk(hero, {6, 0, 0});
    for (int k = 0; k < 120; k++) {
        stage.run(1 / hz);
        EXPECT_EQ(stage.of(hero).ground, GroundKind::on_ground) << "step " << k;
    }
}

}  // namespace
}  // namespace jostle::modules
