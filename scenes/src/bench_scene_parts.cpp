// SPDX-License-Identifier: MIT
#include "scenes/src/bench_scene_parts.h"

#include <array>

#include "jostle/physics/hull.h"
#include "jostle/physics/mesh.h"

namespace jostle::scenes {

using namespace physics;

SceneDescription with_bench_defaults(SceneDescription scene) {
    scene.world.gravity = {0, -9.81, 0};
    for (SceneBody& body : scene.bodies) {
        body.body.linear_damping = body.body.angular_damping = 0.05;
        for (ShapeDef& shape : body.shapes) {
            shape.density = 1000;
            shape.material = {.friction = 0.5, .restitution = 0};
        }
    }
    return scene;
}

void add_bench_floor(SceneDescription& scene, double half_width) {
    scene.bodies.push_back(fixed_box("floor", {0, -1, 0}, {half_width, 1, half_width}));
}

void add_bench_walls(SceneDescription& scene, double half_width, double height) {
    const double middle = 0.5 * height;
    for (const double side : {1.0, -1.0})
        scene.bodies.push_back(fixed_box("wall", {side * (half_width + 0.5), middle, 0},
                                         {0.5, middle, half_width + 1}));
    for (const double side : {1.0, -1.0})
        scene.bodies.push_back(fixed_box("wall", {0, middle, side * (half_width + 0.5)},
                                         {half_width + 1, middle, 0.5}));
}

Quat random_turn(Random& random) {
    const double x = random.in(-1, 1), y = random.in(-1, 1), z = random.in(-1, 1);
    return from_axis_angle(Vec3{x, y, z} + Vec3{0, 1e-3, 0}, random.in(0, 2 * pi));
}

Geometry hull_of(std::span<const Vec3> points) {
    return Hull{build_hull(points).value()};
}

std::vector<Geometry> round_stones(Random& random, int count, int corners, double radius) {
    std::vector<Geometry> stones;
    for (int k = 0; k < count; k++) {
        std::vector<Vec3> points;
        for (int corner = 0; corner < corners; corner++) {
            const double x = random.in(-1, 1), y = random.in(-1, 1), z = random.in(-1, 1);
            points.push_back(normalized(Vec3{x, y, z}) * radius);
        }
        stones.push_back(hull_of(points));
    }
    return stones;
}

Geometry prism(int sides, Vec3 from, double radius_from, Vec3 to, double radius_to) {
    const Vec3 along = normalized(to - from);
    const Vec3 x =
        normalized(cross(along, absolute(along.x) < 0.7 ? Vec3{1, 0, 0} : Vec3{0, 0, 1}));
    const Vec3 y = cross(along, x);
    std::vector<Vec3> points;
    for (int k = 0; k < sides; k++) {
        const SinCos at = sin_cos(2 * pi * k / sides);
        const Vec3 out = x * at.cos + y * at.sin;
        points.push_back(from + out * radius_from);
        points.push_back(to + out * radius_to);
    }
    return hull_of(points);
}

SceneBody mesh_ground(std::uint32_t cells, double spacing,
                      const std::function<double(double x, double z)>& height) {
    std::vector<Vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (std::uint32_t r = 0; r <= cells; r++)
        for (std::uint32_t c = 0; c <= cells; c++) {
            const double x = (c - 0.5 * cells) * spacing, z = (r - 0.5 * cells) * spacing;
            vertices.push_back({x, height(x, z), z});
        }
    for (std::uint32_t r = 0; r < cells; r++)
        for (std::uint32_t c = 0; c < cells; c++) {
            const std::uint32_t v = r * (cells + 1) + c, below = v + cells + 1;
            triangles.push_back({v, below, v + 1});
            triangles.push_back({v + 1, below, below + 1});
        }
    return {.name = "ground",
            .body = {.type = BodyType::static_body},
            .shapes = {{.geometry = Mesh{build_mesh(vertices, triangles).value()}}},
            .color = {}};
}

}  // namespace jostle::scenes
