// SPDX-License-Identifier: MIT
//
// Meshes and height fields of any points: refused with a reason, or surfaces that rays and a
// falling ball can be asked about.
#include <cmath>

#include "jostle/physics/height_field.h"
#include "jostle/physics/mesh.h"
#include "jostle/physics/world.h"
#include "tests/fuzz/mutate_numbers.h"
#include "tests/fuzz/points.h"
#include "tests/fuzz/target.h"

namespace jostle::fuzz {

namespace {

using namespace physics;

Result<Geometry> take_mesh(Reader& in) {
    const PointKind kind = take_point_kind(in);
    const std::size_t count = in.number<std::uint8_t>();
    const std::vector<Vec3> vertices = take_points(in, kind, count);
    std::vector<std::array<std::uint32_t, 3>> triangles;
    while (!in.done() && triangles.size() < 256) {
        std::array<std::uint32_t, 3> corners{};
        for (std::uint32_t& corner : corners) corner = in.number<std::uint8_t>();
        triangles.push_back(corners);
    }
    const auto mesh = build_mesh(vertices, triangles);
    if (!mesh.ok()) return mesh.error();
    for (std::size_t i = 0; i < (*mesh)->triangles.size(); i++)
        for (int k = 0; k < 3; k++) {
            const std::uint32_t other = (*mesh)->neighbours[i][static_cast<std::size_t>(k)];
            if (other == 0xffffffff) continue;
            const auto& back = (*mesh)->neighbours[other];
            expect(std::ranges::find(back, static_cast<std::uint32_t>(i)) != back.end(),
                   "neighbours know each other");
        }
    return Geometry{Mesh{*mesh}};
}

Result<Geometry> take_height_field(Reader& in) {
    HeightGrid grid;
    grid.columns = in.number<std::uint8_t>() % 20;
    grid.rows = in.number<std::uint8_t>() % 20;
    const bool any = in.number<std::uint8_t>() % 2 == 0;
    grid.spacing_x = any ? in.number<double>() : in.number<std::uint8_t>() / 16.0;
    grid.spacing_z = any ? in.number<double>() : in.number<std::uint8_t>() / 16.0;
    for (std::uint32_t k = 0; k < grid.columns * grid.rows; k++)
        grid.heights.push_back(any ? in.number<double>() : in.number<std::int8_t>() / 16.0);
    for (std::uint32_t k = 1; !in.done() && k < grid.columns * grid.rows; k++)
        grid.holes.push_back(in.number<std::uint8_t>() % 2);
    const auto field = build_height_field(std::move(grid));
    if (!field.ok()) return field.error();
    return Geometry{HeightField{*field}};
}

void drop_a_ball(const Geometry& surface) {
    World world;
    const auto ground =
        world.create_body({.type = BodyType::static_body}, ShapeDef{.geometry = surface});
    if (!ground.ok()) return expect(!ground.error().message.empty(), "a refusal has a reason");
    const Aabb box = world.bounds(world.shapes_of(*ground).front()).value();
    const Vec3 middle = (box.low + box.high) * 0.5;
    const double height = box.high.y - box.low.y + 1;
    const Vec3 above = {middle.x, box.high.y + 0.4, middle.z};
    static_cast<void>(world.queries().cast_ray_all({above, {0, -2 * height, 0}}));
    if (world
            .create_body({.pose = {above, {}}, .linear_velocity = {0.5, -10, 0}},
                         ShapeDef{.geometry = Sphere{0.3}})
            .ok())
        for (int k = 0; k < 4; k++) world.step(1.0 / 60).expect();
}

}  // namespace

void run(Bytes input) {
    Reader in(input);
    const bool mesh = in.number<std::uint8_t>() % 2 == 0;
    const auto surface = mesh ? take_mesh(in) : take_height_field(in);
    if (!surface.ok()) return expect(!surface.error().message.empty(), "a refusal has a reason");
    drop_a_ball(*surface);
}

}  // namespace jostle::fuzz

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t size_max, unsigned seed) {
    return jostle::fuzz::mutate_numbers(data, size, size_max, seed);
}
