// SPDX-License-Identifier: MIT
//
// Meshes and height fields as ground: what slides over their seams does not feel them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <ctime>

#include "tests/support/near.h"
#include "tests/support/random.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

// A flat floor of n x n squares of 0.5 m, two triangles each, corners shifted in the plane so that
// no two triangles are alike; every other triangle is wound the other way round.
Geometry tessellated_floor(int n) {
    Random random(5);
    std::vector<Vec3> vertices;
    for (int r = 0; r <= n; r++)
        for (int c = 0; c <= n; c++) {
            const bool rim = r == 0 || c == 0 || r == n || c == n;
            const double jitter = rim ? 0 : 0.15;
            vertices.push_back({(c - n / 2.0) * 0.5 + random.in(-jitter, jitter), 0,
                                (r - n / 2.0) * 0.5 + random.in(-jitter, jitter)});
        }
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (int r = 0; r < n; r++)
        for (int c = 0; c < n; c++) {
            const auto v = [&](int dr, int dc) {
                return static_cast<std::uint32_t>((r + dr) * (n + 1) + c + dc);
            };
            triangles.push_back({v(0, 0), v(1, 1), v(0, 1)});
            if (c % 2 == 0)
                triangles.push_back({v(0, 0), v(1, 0), v(1, 1)});
            else
                triangles.push_back({v(0, 0), v(1, 1), v(1, 0)});
        }
    return Mesh{must(build_mesh(vertices, triangles))};
}

Geometry flat_field(int n) {
    const auto samples = static_cast<std::uint32_t>(n + 1);
    return HeightField{must(
        build_height_field({.columns = samples,
                            .rows = samples,
                            .spacing_x = 0.5,
                            .spacing_z = 0.5,
                            .heights = std::vector<double>(std::size_t{samples} * samples, 0.0)}))};
}

void add_ground(World& world, const Geometry& ground, double friction) {
    add(world, {.geometry = ground, .friction = friction, .type = BodyType::static_body});
}

struct Ride {
    double highest = 0, lowest = 0, sideways = 0, speed = 0;
};

// Slides something at 4 m/s for 3 s in a direction that no edge shares.
Ride slide(const Geometry& ground, const Geometry& slider, double rest_height) {
    World world = make_world();
    add_ground(world, ground, 0);
    const Vec3 along = normalized(Vec3{1, 0, 0.37});
    const BodyId body = add(world, {.geometry = slider,
                                    .position = along * -6 + Vec3{0, rest_height, 0},
                                    .rotation = from_rotation_vector({0, 0.4, 0}),
                                    .velocity = along * 4,
                                    .friction = 0,
                                    .sleep_allowed = false});
    Ride ride;
    for (int i = 0; i < 180; i++) {
        must(world.step(1.0 / 60));
        const Vec3 p = position_of(world, body);
        ride.highest = std::max(ride.highest, p.y - rest_height);
        ride.lowest = std::min(ride.lowest, p.y - rest_height);
        ride.sideways =
            std::max(ride.sideways, std::fabs(dot(p, normalized(cross(along, Vec3{0, 1, 0})))));
    }
    ride.speed = dot(velocity_of(world, body), along);
    return ride;
}

TEST(Terrain, seams_of_a_flat_floor_do_not_affect_sliding) {
    const Geometry hull = Hull{must(build_hull(std::vector<Vec3>{
        {-0.4, -0.3, -0.3}, {0.4, -0.3, -0.3}, {0.4, -0.3, 0.3}, {-0.4, -0.3, 0.3}, {0, 0.3, 0}}))};
    for (const bool field : {false, true}) {
        const Geometry ground = field ? flat_field(40) : tessellated_floor(40);
        for (const auto& [slider, height] : {std::pair<Geometry, double>{Sphere{0.3}, 0.3},
                                             {Box{{0.4, 0.25, 0.3}}, 0.25},
                                             {Cylinder{0.3, 0.2}, 0.2},
                                             {hull, 0.3}}) {
            SCOPED_TRACE(kind_name(kind_of(slider)));
            const Ride ride = slide(ground, slider, height);
            EXPECT_LT(ride.highest, 1e-4);
            EXPECT_GT(ride.lowest, -5e-4);
            EXPECT_LT(ride.sideways, 2e-3);
            EXPECT_NEAR(ride.speed, 4, 2e-3);
        }
    }
}

// A ball that rolls without slipping keeps 5/7 of its speed, on triangles as on a plane.
TEST(Terrain, ball_rolls_over_triangles_as_over_a_plane) {
    const auto roll = [](const Geometry& ground) {
        World world = make_world();
        add_ground(world, ground, 0.5);
        const BodyId ball =
            add(world,
                {.geometry = Sphere{0.25}, .position = {-6, 0.25, 0.1}, .velocity = {5, 0, 0.7}});
        run(world, 2);
        return position_of(world, ball);
    };
    const Vec3 plane = roll(Plane{});
    EXPECT_TRUE(near(roll(tessellated_floor(40)), plane, 0.01));
    EXPECT_TRUE(near(roll(flat_field(40)), plane, 0.01));
}

TEST(Terrain, stack_on_a_mesh_stands_and_sleeps) {
    World world = make_world();
    add_ground(world, tessellated_floor(20), 0.6);
    std::vector<BodyId> boxes;
    for (int i = 0; i < 5; i++) boxes.push_back(add(world, {.position = {0.3, 0.5 + i, 0.2}}));
    run(world, 5);
    for (int i = 0; i < 5; i++) {
        EXPECT_TRUE(near(position_of(world, boxes[static_cast<std::size_t>(i)]),
                         {0.3, 0.5 + i, 0.2}, 0.005));
        EXPECT_FALSE(state_of(world, boxes[static_cast<std::size_t>(i)]).awake);
    }
}

// A valley of a height field: what is dropped in rolls to the lowest place and stays above ground.
TEST(Terrain, balls_roll_into_a_valley) {
    HeightGrid grid{.columns = 41, .rows = 41, .spacing_x = 0.5, .spacing_z = 0.5, .heights = {}};
    for (int r = 0; r < 41; r++)
        for (int c = 0; c < 41; c++)
            grid.heights.push_back(0.02 * ((c - 20) * (c - 20) + (r - 20) * (r - 20)) * 0.25);
    World world = make_world();
    add_ground(world, HeightField{must(build_height_field(grid))}, 0.8);
    std::vector<BodyId> balls;
    for (int i = 0; i < 6; i++)
        balls.push_back(
            add(world, {.geometry = Sphere{0.3}, .position = {i * 1.3 - 3, 4, i * 0.9}}));
    run(world, 20);
    for (const BodyId ball : balls) {
        const Vec3 p = position_of(world, ball);
        EXPECT_GT(p.y, 0.25);
        EXPECT_LT(std::hypot(p.x, p.z), 4);
    }
}

// Boxes, stones and cones thrown on crumpled ground: what lies across several of its facets is held
// by all of them at once and does not rock, and what fell over a ridge is not caught by its slopes.
TEST(Terrain, rubble_comes_to_rest_on_rough_terrain) {
    HeightGrid grid{.columns = 25, .rows = 25, .spacing_x = 1, .spacing_z = 1, .heights = {}};
    Random random(3);
    for (int r = 0; r < 25; r++)
        for (int c = 0; c < 25; c++) {
            const int rim = std::max(std::abs(c - 12), std::abs(r - 12)) - 9;
            grid.heights.push_back(0.5 * std::sin(c * 0.5) * std::cos(r * 0.4) + random.in(0, 0.3) +
                                   3.0 * std::max(0, rim));
        }
    World world = make_world();
    add_ground(world, HeightField{must(build_height_field(grid))}, 0.5);
    std::vector<BodyId> stones;
    for (int i = 0; i < 90; i++) {
        Geometry shape = Box{{random.in(0.1, 0.5), random.in(0.1, 0.5), random.in(0.1, 0.5)}};
        if (i % 3 == 1) shape = Cone{random.in(0.1, 0.3), random.in(0.15, 0.5)};
        if (i % 3 == 2) {
            std::vector<Vec3> points;
            for (int k = 0; k < 12; k++) points.push_back(random.vector(0.5));
            shape = Hull{must(build_hull(points))};
        }
        const BodyId body = add(world, {.geometry = shape,
                                        .position = random.vector(7) + Vec3{0, 11, 0},
                                        .rotation = random.rotation()});
        if (i % 3 != 1) stones.push_back(body);
    }
    run(world, 15);
    EXPECT_LT(world.summary().max_penetration, 0.004);
    // A cone may roll for long and keep awake whom it touches: of eight such grounds one had
    // stones, two, that still moved with it at 2 to 7 cm/s. All others rest.
    int awake = 0;
    for (const BodyId stone : stones) {
        awake += state_of(world, stone).awake ? 1 : 0;
        EXPECT_LT(length(state_of(world, stone).linear_velocity), 0.1);
    }
    EXPECT_LE(awake, 4);
    for (const BodyId body : world.bodies()) EXPECT_GT(position_of(world, body).y, -0.6);
}

TEST(Terrain, bodies_fall_through_a_hole_and_rest_on_its_rim) {
    HeightGrid grid{.columns = 11,
                    .rows = 11,
                    .spacing_x = 1,
                    .spacing_z = 1,
                    .heights = std::vector<double>(121, 0.0),
                    .holes = std::vector<std::uint8_t>(100, 0)};
    grid.holes[5 * 10 + 5] = 1;  // x and z from 0 to 1
    World world = make_world();
    add_ground(world, HeightField{must(build_height_field(grid))}, 0.5);
    const BodyId falls = add(world, {.geometry = Sphere{0.3}, .position = {0.5, 2, 0.5}});
    const BodyId stays = add(world, {.geometry = Sphere{0.3}, .position = {2.5, 2, 0.5}});
    const BodyId wide = add(world, {.geometry = Box{{0.8, 0.1, 0.8}}, .position = {0.5, 5, 0.5}});
    run(world, 3);
    EXPECT_LT(position_of(world, falls).y, -5);
    EXPECT_NEAR(position_of(world, stays).y, 0.3, 1e-3);
    EXPECT_NEAR(position_of(world, wide).y, 0.1, 2e-3);
}

// A ball that falls fast on a large triangle and bounces a little is held the second time as well.
TEST(Terrain, small_bounce_ends_on_the_ground) {
    const std::vector<Vec3> vertices{{-5, 0, -5}, {5, 0, -5}, {5, 0, 5}, {-5, 0, 5}};
    const std::vector<std::array<std::uint32_t, 3>> triangles{{0, 2, 1}, {0, 3, 2}};
    for (const double speed : {4.0, 6.0, 8.0, 10.0}) {
        for (const double restitution : {0.1, 0.15, 0.2}) {
            World world = make_world();
            add_static(world, {.geometry = Mesh{must(build_mesh(vertices, triangles))},
                               .restitution = restitution});
            const BodyId ball = add(world, {.geometry = Sphere{0.5},
                                            .position = {1, 0.55 + speed / 30, 0.3},
                                            .velocity = {0, -speed, 0},
                                            .restitution = restitution});
            double lowest = 1;
            for (int step = 0; step < 120; step++) {
                must(world.step(1.0 / 60));
                lowest = std::min(lowest, position_of(world, ball).y - 0.5);
            }
            EXPECT_GT(lowest, -2e-3) << speed << " m/s, " << restitution;
        }
    }
}

// A roof seen from both sides: a ridge holds what straddles it, and triangles have no back.
TEST(Terrain, ridge_and_underside_collide) {
    const std::vector<Vec3> vertices{{-2, 0, -2}, {2, 0, -2}, {-2, 0, 2},
                                     {2, 0, 2},   {-2, 1, 0}, {2, 1, 0}};
    const std::vector<std::array<std::uint32_t, 3>> triangles{
        {0, 4, 1}, {1, 4, 5}, {2, 3, 4}, {3, 5, 4}};
    World world = make_world();
    add_ground(world, Mesh{must(build_mesh(vertices, triangles))}, 1);
    const BodyId saddle = must(world.create_body({.pose = {{0, 1.5, 0}, {}}}));
    for (const double z : {-0.5, 0.5})
        must(world.create_shape(saddle,
                                {.geometry = Box{{0.3, 0.1, 0.1}}, .pose = {{0, -0.35, z}, {}}}));
    run(world, 3);
    const Vec3 p = position_of(world, saddle);
    EXPECT_GT(p.y, 0.9);
    EXPECT_LT(std::fabs(p.z), 0.05);

    World below = make_world({.gravity = {0, 9.81, 0}});
    add_ground(below, tessellated_floor(8), 0.5);
    const BodyId ball = add(below, {.geometry = Sphere{0.25}, .position = {0.1, -1, 0.1}});
    run(below, 2);
    EXPECT_NEAR(position_of(below, ball).y, -0.25, 1e-3);
}

// No triangle has a neighbour that could cover its contacts, so each might be compared with all
// others: 16 million tests.
TEST(Terrain, soup_of_triangles_takes_bounded_time) {
    constexpr int count = 4000;
    std::vector<Vec3> vertices;
    for (int i = 0; i < count + 2; i++)
        vertices.push_back({(i * 7919 % 1000) / 1000.0, (i * 104729 % 1009) / 1000.0,
                            static_cast<double>(std::int64_t{i} * 1299709 % 1013) / 1000});
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (std::uint32_t i = 0; i < count; i++) triangles.push_back({i, i + 1, i + 2});
    World world = make_world();
    add_ground(world, Mesh{must(build_mesh(vertices, triangles))}, 0.5);
    add(world, {.geometry = Box{{2, 2, 2}}});
    const std::clock_t start = std::clock();
    must(world.step(1.0 / 60));
    EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, 2);
    EXPECT_GT(world.profile().manifolds, 0);
}

}  // namespace
}  // namespace jostle::test
