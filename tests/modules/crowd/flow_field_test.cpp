// SPDX-License-Identifier: MIT
#include "modules/crowd/src/flow_field.h"

#include <gtest/gtest.h>

#include <cmath>

namespace jostle::modules::crowd_detail {
namespace {

using physics::Vec2;

FlowField field_with(const std::vector<Wall>& walls, const std::vector<GoalArea>& areas,
                     const RouteGrid& grid) {
    WallTree tree;
    tree.build(walls);
    FlowField field;
    field.build(grid, tree, areas);
    return field;
}

// The error of the scheme is of first order: it halves with the cells.
TEST(FlowField, distance_in_an_open_plane_converges_to_the_straight_line) {
    double errors[2];
    for (int k = 0; k < 2; k++) {
        const double cell = k == 0 ? 0.4 : 0.2;
        const double half = 50.5 * 0.4;  // the origin is the centre of a cell
        const FlowField field = field_with({}, {{{0, 0}, {0.05, 0.05}}},
                                           {{0, 0}, {half - 0.1 * k, half - 0.1 * k}, cell, 0});
        double worst = 0;
        for (int a = 0; a < 32; a++) {
            const auto turn = physics::sin_cos(2 * physics::pi * a / 32);
            const Vec2 center{std::round(turn.cos * 15 / cell) * cell,
                              std::round(turn.sin * 15 / cell) * cell};
            worst = std::max(worst, std::abs(field.distance(center) - length(center)));
        }
        errors[k] = worst;
    }
    EXPECT_LT(errors[0], 0.6);
    EXPECT_LT(errors[1], 0.65 * errors[0]);
}

TEST(FlowField, directions_point_to_the_goal) {
    const FlowField field = field_with({}, {{{3, 1}, {0.5, 0.5}}}, {{0, 0}, {20, 20}, 0.5, 0});
    for (int a = 0; a < 32; a++) {
        const auto turn = physics::sin_cos(2 * physics::pi * a / 32);
        const Vec2 away{turn.cos, turn.sin};
        const Vec2 direction = field.direction(Vec2{3, 1} + away * 12).value();
        EXPECT_NEAR(length(direction), 1, 1e-6);
        EXPECT_LT(dot(direction, away), -0.98);  // within 11 degrees
    }
    EXPECT_FALSE(field.direction({30, 0}).has_value());
}

// Walks along the field around a wall of 10 m with its goal behind it. The shortest way is
// 2 sqrt(5^2 + 4^2) m = 12.8 m around either end.
TEST(FlowField, walk_around_a_wall_takes_the_shortest_way) {
    const FlowField field =
        field_with({{{0, -5}, {0, 5}}}, {{{4, 0}, {0.3, 0.3}}}, {{0, 0}, {10, 10}, 0.25, 0.25});
    Vec2 p{-4, 0.5};
    double way = 0;
    while (length(p - Vec2{4, 0}) > 0.4 && way < 30) {
        p = p + field.direction(p).value() * 0.02;
        way += 0.02;
        ASSERT_GT(std::hypot(p.x, std::max(std::abs(p.y) - 5, 0.0)), 0.05) << "meets the wall";
    }
    EXPECT_NEAR(way, 12.8, 1.0);
}

TEST(FlowField, agents_in_a_wall_are_led_out_and_closed_goals_have_no_shortcut) {
    // A closed room around the goal: the way in leads through the wall, but is very long.
    const std::vector<Wall> room{
        {{2, -2}, {6, -2}}, {{6, -2}, {6, 2}}, {{6, 2}, {2, 2}}, {{2, 2}, {2, -2}}};
    const FlowField field =
        field_with(room, {{{4, 0}, {0.5, 0.5}}}, {{0, 0}, {10, 10}, 0.25, 0.25});
    EXPECT_LT(field.distance({3, 0}), 2);
    EXPECT_GT(field.distance({0, 0}), 1000);
    EXPECT_GT(field.direction({2.1, 0})->x, 0.9);  // from the wall into the room
}

TEST(FlowField, several_areas_attract_from_their_own_side) {
    const FlowField field =
        field_with({}, {{{-8, 0}, {0.5, 0.5}}, {{8, 0}, {0.5, 0.5}}}, {{0, 0}, {10, 5}, 0.5, 0});
    EXPECT_LT(field.direction({-3, 0})->x, -0.99);
    EXPECT_GT(field.direction({3, 0})->x, 0.99);
    const FlowField outside = field_with({}, {{{50, 0}, {1, 1}}}, {{0, 0}, {10, 5}, 0.5, 0});
    EXPECT_FALSE(outside.direction({0, 0}).has_value());
}

TEST(WallTree, finds_the_same_walls_as_a_loop) {
    std::vector<Wall> walls;
    for (int k = 0; k < 200; k++) {
        const auto turn = physics::sin_cos(0.7 * k), bend = physics::sin_cos(1.3 * k);
        const Vec2 from = Vec2{turn.cos, turn.sin} * (0.1 * k);
        walls.push_back({from, from + Vec2{bend.cos, bend.sin}});
    }
    WallTree tree;
    tree.build(walls);
    for (int k = 0; k < 100; k++) {
        const auto turn = physics::sin_cos(0.37 * k);
        const Vec2 p = Vec2{turn.cos, turn.sin} * (0.2 * k);
        double nearest = 1e9;
        for (const Wall& wall : walls) {
            const Vec2 along = wall.to - wall.from;
            const double t =
                std::clamp(dot(p - wall.from, along) / length_squared(along), 0.0, 1.0);
            nearest = std::min(nearest, length(wall.from + along * t - p));
        }
        NearWalls found;
        tree.find(p, 3, found);
        EXPECT_EQ(found.count > 0, nearest <= 3);
        if (found.count > 0) {
            EXPECT_NEAR(found.walls[0].distance, nearest, 1e-12);
        }
        EXPECT_EQ(tree.is_near(p, 0.5), nearest <= 0.5);
    }
}

}  // namespace
}  // namespace jostle::modules::crowd_detail
