// SPDX-License-Identifier: MIT
//
// A flat floor is a floor however it is modelled: bodies that slide or roll over its pieces feel no
// bump.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tests/support/random.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

// Squares of `side` m from (x, z) on, cut along one diagonal or the other.
struct Sheet {
    std::vector<Vec3> vertices;
    Triangles triangles;

    void add(double x, double z, int columns, int rows, double side, bool other_diagonal = false) {
        const auto base = static_cast<std::uint32_t>(vertices.size());
        const auto width = static_cast<std::uint32_t>(columns + 1);
        for (int r = 0; r <= rows; r++)
            for (int c = 0; c <= columns; c++) vertices.push_back({x + c * side, 0, z + r * side});
        for (int r = 0; r < rows; r++)
            for (int c = 0; c < columns; c++) {
                const std::uint32_t at =
                    base + static_cast<std::uint32_t>(r) * width + static_cast<std::uint32_t>(c);
                const std::uint32_t next = at + width;
                if (other_diagonal) {
                    triangles.push_back({at, next, at + 1});
                    triangles.push_back({at + 1, next, next + 1});
                } else {
                    triangles.push_back({at, next + 1, at + 1});
                    triangles.push_back({at, next, next + 1});
                }
            }
    }
    Geometry mesh() const { return Mesh{must(build_mesh(vertices, triangles))}; }
};

struct Piece {
    Geometry geometry;
    Vec3 position;
};
using Pieces = std::vector<Piece>;

Sheet sheet(bool other_diagonal = false) {
    Sheet s;
    s.add(-8, -2, 32, 8, 0.5, other_diagonal);
    return s;
}

Pieces doubled_mesh() {
    Sheet s = sheet();
    const Triangles once = s.triangles;
    for (const auto& t : once) s.triangles.push_back({t[0], t[2], t[1]});
    return {{s.mesh(), {}}};
}
Pieces mesh_with_both_diagonals() {
    Sheet s = sheet();
    s.add(-8, -2, 32, 8, 0.5, true);
    return {{s.mesh(), {}}};
}
// Each corner has its own vertex, rounded to 0.01 mm.
Pieces loose_mesh() {
    const Sheet s = sheet();
    Random random(3);
    Sheet loose;
    for (const auto& t : s.triangles) {
        const auto first = static_cast<std::uint32_t>(loose.vertices.size());
        for (const std::uint32_t corner : t)
            loose.vertices.push_back(s.vertices[corner] +
                                     Vec3{random.in(-1e-5, 1e-5), 0, random.in(-1e-5, 1e-5)});
        loose.triangles.push_back({first, first + 1, first + 2});
    }
    return {{loose.mesh(), {}}};
}
// Neighbouring squares have different sizes, so that corners lie on edges.
Pieces uneven_mesh() {
    Sheet s;
    for (int k = 0; k < 16; k++) s.add(-8 + k, -2, k % 2 + 2, 4 * (k % 2 + 2), 1.0 / (k % 2 + 2));
    return {{s.mesh(), {}}};
}
Pieces cut_mesh() {
    Pieces pieces;
    for (int k = 0; k < 16; k++) {
        Sheet s;
        s.add(-8 + k, -2, 2, 8, 0.5);
        pieces.push_back({s.mesh(), {}});
    }
    return pieces;
}
Pieces tiles(const Geometry& tile) {
    Pieces pieces;
    for (int k = 0; k < 16; k++)
        for (int r = 0; r < 4; r++) pieces.push_back({tile, {-7.5 + k, -0.5, -1.5 + r}});
    return pieces;
}
Pieces box_tiles() {
    return tiles(Box{{0.5, 0.5, 0.5}});
}
Pieces hull_tiles() {
    std::vector<Vec3> corners;
    for (int k = 0; k < 8; k++) corners.push_back({k % 2 - 0.5, k / 2 % 2 - 0.5, k / 4 - 0.5});
    return tiles(Hull{must(build_hull(corners))});
}
Pieces compound_of_tiles() {
    std::vector<CompoundChild> children;
    for (const Piece& p : box_tiles()) children.push_back({p.geometry, {p.position, {}}});
    return {{Compound{must(build_compound(children))}, {}}};
}
Pieces fields_and_boxes() {
    const Geometry field = HeightField{
        must(build_height_field({.columns = 5,
                                 .rows = 9,
                                 .spacing_x = 0.5,
                                 .spacing_z = 0.5,
                                 .heights = std::vector<double>(std::size_t{5} * 9, 0.0)}))};
    Pieces pieces;
    for (int k = 0; k < 8; k++)
        if (k % 2 == 0)
            pieces.push_back({field, {-7.0 + 2 * k, 0, 0}});
        else
            pieces.push_back({Box{{1, 0.5, 2}}, {-7.0 + 2 * k, -0.5, 0}});
    return pieces;
}

struct Rider {
    BuiltBody body;
    double height;  // m: of its centre at rest
};

Rider box_at_2_m_s() {
    return {{.geometry = Box{{0.3, 0.3, 0.3}}, .velocity = {2, 0, 0}, .friction = 0}, 0.3};
}
Rider ball_at_8_m_s() {
    return {{.geometry = Sphere{0.25}, .velocity = {8, 0, 0}, .spin = {0, 0, -32}}, 0.25};
}
Rider capsule_at_25_m_s(double yaw) {
    const Quat lying = from_rotation_vector({0, 0, 0.5 * pi});
    return {{.geometry = Capsule{0.2, 0.4},
             .rotation = from_rotation_vector({0, yaw, 0}) * lying,
             .velocity = {25, 0, 0},
             .friction = 0},
            0.2};
}

// Lets a body slide or roll over 12 m of floor, which is tilted together with gravity.
void ride(const Pieces& floor, Rider rider, Vec3 floor_velocity = {}) {
    const Quat tilt = from_rotation_vector({0, 0.3, 0}) * from_rotation_vector({0.1, 0, 0.2});
    World world = make_world({.gravity = rotate(tilt, {0, -9.81, 0})});
    for (const Piece& piece : floor)
        add(world,
            {.geometry = piece.geometry,
             .position = rotate(tilt, piece.position),
             .rotation = tilt,
             .velocity = rotate(tilt, floor_velocity),
             .friction = rider.body.friction,
             .type = floor_velocity == Vec3{} ? BodyType::static_body : BodyType::kinematic});
    const Vec3 start{-6, rider.height + 1e-4, 0.137}, velocity = rider.body.velocity;
    rider.body.position = rotate(tilt, start);
    rider.body.rotation = tilt * rider.body.rotation;
    rider.body.velocity = rotate(tilt, velocity + floor_velocity);
    rider.body.spin = rotate(tilt, rider.body.spin);
    rider.body.sleep_allowed = false;
    const BodyId body = add(world, rider.body);
    double bump = 0, speed = 0, aside = 0;
    const int steps = static_cast<int>(12 / velocity.x * 60);
    for (int k = 1; k <= steps; k++) {
        must(world.step(1.0 / 60));
        const Vec3 p =
            rotate(conjugate(tilt), position_of(world, body)) - floor_velocity * (k / 60.0);
        const Vec3 v = rotate(conjugate(tilt), velocity_of(world, body)) - floor_velocity;
        bump = std::max(bump, std::fabs(p.y - rider.height));
        speed = std::max(speed, std::fabs(v.x - velocity.x));
        aside = std::max(aside, std::fabs(p.z - start.z));
    }
    EXPECT_LT(bump, 2e-3);
    EXPECT_LT(speed, 0.02);
    EXPECT_LT(aside, 0.02);
}

void ride_all(const Pieces& floor, Vec3 floor_velocity = {}) {
    for (const Rider& rider :
         {box_at_2_m_s(), ball_at_8_m_s(), capsule_at_25_m_s(0), capsule_at_25_m_s(0.6)}) {
        SCOPED_TRACE(std::string(kind_name(kind_of(rider.body.geometry))));
        ride(floor, rider, floor_velocity);
    }
}

TEST(Floors, welded_mesh) {
    ride_all({{sheet().mesh(), {}}});
}
TEST(Floors, mesh_with_every_triangle_twice) {
    ride_all(doubled_mesh());
}
TEST(Floors, mesh_with_both_diagonals_of_every_square) {
    ride_all(mesh_with_both_diagonals());
}
TEST(Floors, mesh_whose_corners_do_not_quite_meet) {
    ride_all(loose_mesh());
}
TEST(Floors, mesh_with_corners_on_edges) {
    ride_all(uneven_mesh());
}
TEST(Floors, mesh_cut_into_bodies) {
    ride_all(cut_mesh());
}
TEST(Floors, flush_boxes) {
    ride_all(box_tiles());
}
TEST(Floors, flush_hulls) {
    ride_all(hull_tiles());
}
TEST(Floors, compound_of_flush_boxes) {
    ride_all(compound_of_tiles());
}
TEST(Floors, height_fields_beside_boxes) {
    ride_all(fields_and_boxes());
}
TEST(Floors, moving_boxes) {
    ride_all(box_tiles(), {0.7, 0, 0.2});
}

// What stands on a floor still stops a body that slides into it.
TEST(Floors, a_wall_on_flush_tiles_stops_a_box) {
    World world = make_world();
    for (const Piece& p : box_tiles())
        add_static(world, {.geometry = p.geometry, .position = p.position, .friction = 0});
    add_static(world, {.geometry = Box{{0.1, 0.5, 2}}, .position = {0.1, 0.5, 0}, .friction = 0});
    // A curb of 20 mm.
    add_static(world, {.geometry = Box{{0.1, 0.01, 2}}, .position = {4, 0.01, 0}, .friction = 0});
    const BodyId before_wall = add(world, {.geometry = Box{{0.3, 0.3, 0.3}},
                                           .position = {-3, 0.3, 0.1},
                                           .velocity = {6, 0, 0},
                                           .friction = 0});
    const BodyId before_curb = add(world, {.geometry = Box{{0.3, 0.3, 0.3}},
                                           .position = {2, 0.3, 0.1},
                                           .velocity = {0.5, 0, 0},
                                           .friction = 0});
    run(world, 4);
    EXPECT_LT(position_of(world, before_wall).x, -0.3);
    EXPECT_NEAR(position_of(world, before_wall).y, 0.3, 5e-3);
    EXPECT_LT(position_of(world, before_curb).x, 3.6);
    EXPECT_NEAR(position_of(world, before_curb).y, 0.3, 5e-3);
}

}  // namespace
}  // namespace jostle::test
