// SPDX-License-Identifier: MIT
//
// Benchmark scenes with persistent motion: hulls, compounds, meshes and many fast bodies.
#include <array>

#include "jostle/physics/mesh.h"
#include "jostle/scenes/bench_scenes.h"
#include "scenes/src/bench_scene_parts.h"
#include "scenes/src/scene_helpers.h"

namespace jostle::scenes {

using namespace physics;

namespace {

// A lying ring, as a mesh.
Geometry torus(double radius, double tube) {
    constexpr std::uint32_t around = 24, across = 12;
    std::vector<Vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (std::uint32_t i = 0; i < around; i++)
        for (std::uint32_t j = 0; j < across; j++) {
            const SinCos a = sin_cos(2 * pi * i / around), b = sin_cos(2 * pi * j / across);
            const double r = radius + tube * b.cos;
            vertices.push_back({r * a.cos, tube * b.sin, r * a.sin});
            const std::uint32_t next = (i + 1) % around * across, adjacent = (j + 1) % across;
            const std::uint32_t p = i * across + j, q = i * across + adjacent;
            triangles.push_back({p, q, next + j});
            triangles.push_back({q, next + adjacent, next + j});
        }
    return Mesh{build_mesh(vertices, triangles).value()};
}

// Stones in columns, with random rotations.
void add_stones(SceneDescription& scene, Random& random, const std::vector<Geometry>& stones,
                int side, int layers, double pitch, double lowest) {
    const double middle = 0.5 * (side - 1);
    for (int y = 0; y < layers; y++)
        for (int z = 0; z < side; z++)
            for (int x = 0; x < side; x++) {
                const Vec3 at{(x - middle) * pitch, lowest + y * pitch, (z - middle) * pitch};
                const std::size_t which = scene.bodies.size() % stones.size();
                scene.bodies.push_back(
                    dynamic_body("stone", at, stones[which], random_turn(random)));
            }
}

// A trunk of six segments and sixteen branches.
SceneBody tree(Random& random, double height) {
    SceneBody body{.name = "tree", .body = {}, .shapes = {}, .color = {}};
    const auto add = [&](Vec3 from, double radius_from, Vec3 to, double radius_to) {
        body.shapes.push_back({.geometry = prism(6, from, radius_from, to, radius_to)});
    };
    const double piece = height / 6, thick = 0.02 * height;
    for (int k = 0; k < 6; k++)
        add({0, (k - 3) * piece, 0}, thick * (1 - 0.14 * k), {0, (k - 2) * piece, 0},
            thick * (1 - 0.14 * (k + 1)));
    for (int k = 0; k < 16; k++) {
        const double up = height * (-0.15 + 0.038 * k), length = height * (0.14 - 0.005 * k);
        const SinCos at = sin_cos(2.4 * k + random.in(-0.3, 0.3));
        const Vec3 out{at.cos, 0, at.sin}, from{0, up, 0};
        add(from + out * (0.5 * thick), 0.3 * thick, from + out * length + Vec3{0, 0.4 * length, 0},
            0.15 * thick);
    }
    return body;
}

// A drum of 36 staves along the z axis, which turns at this angular velocity (rad/s), and its fixed
// ends. Every ninth stave is a paddle.
void add_drum(SceneDescription& scene, double angular_velocity) {
    constexpr int staves = 36;
    constexpr double radius = 4, half_length = 3, thickness = 0.25, paddle = 0.5;
    SceneBody drum{
        .name = "drum",
        .body = {.type = BodyType::kinematic, .angular_velocity = {0, 0, angular_velocity}},
        .shapes = {},
        .color = {}};
    for (int k = 0; k < staves; k++) {
        const double inside = radius - (k % 9 == 0 ? paddle : 0), outside = radius + 2 * thickness;
        const double half_width = outside * 1.02 * pi / staves;
        const Quat turn = from_axis_angle({0, 0, 1}, 2 * pi * k / staves);
        std::vector<Vec3> corners;
        for (const double x : {inside, outside})
            for (const double y : {-half_width, half_width})
                for (const double z : {-half_length, half_length})
                    corners.push_back(rotate(turn, {x, y, z}));
        drum.shapes.push_back({.geometry = hull_of(corners)});
    }
    scene.bodies.push_back(drum);
    for (const double side : {1.0, -1.0})
        scene.bodies.push_back(fixed_box("end", {0, 0, side * (half_length + 0.5)}, {6, 6, 0.5}));
}

}  // namespace

SceneDescription bench_trees() {
    SceneDescription scene;
    scene.bodies.push_back(mesh_ground(100, 4, [](double x, double z) {
        return 2.5 * sin_cos(0.11 * x).sin + 1.5 * sin_cos(0.07 * z + 1).sin;
    }));
    Random random;
    const Quat lying = from_axis_angle({1, 0, 0}, pi / 2);
    for (int row = 0; row < 5; row++)
        for (int k = 0; k < 10; k++) {
            SceneBody body = tree(random, random.in(25, 45));
            body.body.pose = {{(k - 4.5) * 16, 14, (row - 2.0) * 55},
                              from_axis_angle({0, 1, 0}, random.in(-0.1, 0.1)) * lying};
            body.body.linear_velocity = {6, 0, 0};
            scene.bodies.push_back(body);
        }
    return with_bench_defaults(std::move(scene));
}

SceneDescription bench_convex_pile() {
    SceneDescription scene;
    add_bench_floor(scene, 200);
    add_bench_walls(scene, 5);
    Random random;
    const auto stones = round_stones(random, 16, 32, 0.25);
    add_stones(scene, random, stones, 16, 20, 0.6, 0.4);
    return with_bench_defaults(std::move(scene));
}

SceneDescription bench_washer() {
    SceneDescription scene;
    add_drum(scene, 0.5);
    for (int y = 0; y < 20; y++)
        for (int z = 0; z < 20; z++)
            for (int x = 0; x < 20; x++)
                scene.bodies.push_back(
                    dynamic_body("cube", {(x - 9.5) * 0.22, (y - 9.5) * 0.22, (z - 9.5) * 0.22},
                                 Box{{0.1, 0.1, 0.1}}));
    return with_bench_defaults(std::move(scene));
}

SceneDescription bench_drum(double degrees_per_second) {
    constexpr int columns = 14, rows = 16;
    const Geometry kinds[] = {Box{{0.15, 0.15, 0.15}}, Sphere{0.16}, Capsule{0.1, 0.12}};
    SceneDescription scene;
    add_drum(scene, degrees_per_second * pi / 180);
    for (int k = 0; k < 2000; k++) {
        const int x = k % columns, z = k / columns % rows, y = k / (columns * rows);
        const Vec3 at{(x - 6.5) * 0.35, (y - 4.0) * 0.46, (z - 7.5) * 0.35};
        scene.bodies.push_back(dynamic_body("piece", at, kinds[k % 3]));
    }
    return with_bench_defaults(std::move(scene));
}

SceneDescription bench_hull_terrain() {
    SceneDescription scene;
    scene.bodies.push_back(mesh_ground(60, 1, [](double x, double z) {
        return 0.8 * sin_cos(0.5 * x).sin * sin_cos(0.4 * z).cos + 0.15 * sin_cos(2.3 * x + z).sin +
               0.004 * (x * x + z * z);
    }));
    Random random;
    const auto stones = round_stones(random, 30, 24, 0.5);
    add_stones(scene, random, stones, 10, 3, 1.6, 5);
    return with_bench_defaults(std::move(scene));
}

SceneDescription bench_rain() {
    SceneDescription scene;
    // Adjacent bowls.
    scene.bodies.push_back(mesh_ground(60, 0.5, [](double x, double z) {
        return 0.8 * sin_cos(0.9 * x).sin * sin_cos(0.9 * x).sin +
               0.8 * sin_cos(0.9 * z).sin * sin_cos(0.9 * z).sin;
    }));
    const Geometry ring = torus(1.2, 0.3);
    for (int k = 0; k < 9; k++)
        scene.bodies.push_back({.name = "ring",
                                .body = {.type = BodyType::static_body,
                                         .pose = {{(k % 3 - 1) * 4.0, 3, (k / 3 - 1) * 4.0}, {}}},
                                .shapes = {{.geometry = ring}},
                                .color = {}});
    for (int level = 0; level < 8; level++)
        for (int k = 0; k < 9; k++) {
            const Vec3 feet{(k % 3 - 1) * 4.0 + 0.3 * (level % 3 - 1), 4.5 + 2.4 * level,
                            (k / 3 - 1) * 4.0 + 0.2 * (level % 2)};
            add_bench_ragdoll(scene, {feet, from_axis_angle({0, 1, 0}, 0.7 * level + k)});
        }
    return with_bench_defaults(std::move(scene));
}

SceneDescription bench_vehicles() {
    constexpr double wheel_radius = 0.45, speed = 10;
    const auto height = [](double x, double z) {
        return 0.5 * sin_cos(0.15 * x).sin + 0.5 * sin_cos(0.2 * z).sin;
    };
    SceneDescription scene;
    scene.bodies.push_back(mesh_ground(120, 2.5, height));
    const Geometry wheel = prism(16, {-0.15, 0, 0}, wheel_radius, {0.15, 0, 0}, wheel_radius);
    // A hinge rotates about the z axis of its frame, which points along x.
    const Quat axle = from_axis_angle({0, 1, 0}, pi / 2);
    for (int k = 0; k < 100; k++) {
        const double x = (k % 10 - 4.5) * 8, z = (k / 10 - 9.5) * 8;
        const std::size_t chassis = scene.bodies.size();
        const Vec3 middle{x, height(x, z) + 1.6, z};
        scene.bodies.push_back(dynamic_body("chassis", middle, Box{{0.8, 0.25, 1.8}}));
        scene.bodies.back().body.linear_velocity = {0, 0, speed};
        for (int corner = 0; corner < 4; corner++) {
            const Vec3 at = middle + Vec3{corner & 1 ? 1.0 : -1.0, -0.25, corner & 2 ? 1.3 : -1.3};
            scene.bodies.push_back(dynamic_body("wheel", at, wheel));
            scene.bodies.back().body.linear_velocity = {0, 0, speed};
            scene.bodies.back().body.angular_velocity = {speed / wheel_radius, 0, 0};
            join(scene, "axle", chassis, scene.bodies.size() - 1, {at, axle}, HingeJoint{});
        }
    }
    return with_bench_defaults(std::move(scene));
}

SceneDescription bench_rods() {
    SceneDescription scene;
    add_bench_floor(scene, 200);
    add_bench_walls(scene, 3);
    Random random;
    const Quat along_x = from_axis_angle({0, 0, 1}, pi / 2),
               along_z = from_axis_angle({1, 0, 0}, pi / 2);
    for (int k = 0; k < 2000; k++) {
        const int layer = k / 100, cell = k % 100;
        const double across = (cell % 20 - 9.5) * 0.25, along = (cell / 20 - 2) * 1.1;
        Vec3 at = layer % 2 == 0 ? Vec3{along, 0, across} : Vec3{across, 0, along};
        at += {random.in(-0.03, 0.03), 0.5 + 0.3 * layer, random.in(-0.03, 0.03)};
        const Quat askew = from_axis_angle({0, 1, 0}, random.in(-0.1, 0.1));
        scene.bodies.push_back(dynamic_body("rod", at, Capsule{0.03, 0.45},
                                            askew * (layer % 2 == 0 ? along_x : along_z)));
    }
    return with_bench_defaults(std::move(scene));
}

SceneDescription bench_box_shot() {
    SceneDescription scene;
    scene.bodies.push_back(fixed_box("wall", {0.25, 0, 0}, {0.25, 100, 100}));
    Random random;
    for (int i = 0; i < 1000; i++) {
        const double x = random.in(-30, -5);
        const Vec3 at{x, (i % 32 - 15.5) * 0.6, (i / 32 - 15.5) * 0.6};
        scene.bodies.push_back(
            dynamic_body("box", at, Box{{0.15, 0.15, 0.15}}, random_turn(random)));
        scene.bodies.back().body.linear_velocity = {150, 0, 0};
    }
    return with_bench_defaults(std::move(scene));
}

SceneDescription bench_brick_wall() {
    SceneDescription scene;
    add_bench_floor(scene, 200);
    for (int row = 0; row < 20; row++)
        for (int k = 0; k < 20; k++)
            scene.bodies.push_back(
                dynamic_body("brick", {(k - 9.75 + 0.5 * (row % 2)) * 0.5, 0.125 + 0.25 * row, 0},
                             Box{{0.25, 0.125, 0.125}}));
    scene.bodies.push_back(dynamic_body("ball", {0, 2, 8}, Sphere{1}));
    scene.bodies.back().body.linear_velocity = {0, 2, -16};
    return with_bench_defaults(std::move(scene));
}

SceneDescription bench_l_shapes() {
    SceneDescription scene;
    add_bench_floor(scene, 200);
    add_bench_walls(scene, 4);
    Random random;
    for (int k = 0; k < 500; k++) {
        const int layer = k / 9, cell = k % 9;
        const Vec3 at{(cell % 3 - 1) * 2.1, 1.2 + 2.1 * layer, (cell / 3 - 1) * 2.1};
        SceneBody body = dynamic_body("L", at, Box{{0.5, 0.15, 0.15}}, random_turn(random));
        body.shapes.push_back({.geometry = Box{{0.15, 0.35, 0.15}}, .pose = {{0.35, 0.5, 0}, {}}});
        scene.bodies.push_back(body);
    }
    return with_bench_defaults(std::move(scene));
}

SceneDescription bench_junkyard() {
    SceneDescription scene;
    add_bench_floor(scene, 200);
    add_bench_walls(scene, 8);
    SceneBody sweeper = fixed_box("sweeper", {0, 0.6, 0}, {7.5, 0.5, 0.25});
    sweeper.body.type = BodyType::kinematic;
    sweeper.body.angular_velocity = {0, 1, 0};
    scene.bodies.push_back(sweeper);
    Random random;
    const auto stones = round_stones(random, 12, 14, 0.3);
    add_stones(scene, random, stones, 21, 24, 0.7, 1.6);
    return with_bench_defaults(std::move(scene));
}

}  // namespace jostle::scenes
