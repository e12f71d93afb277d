// SPDX-License-Identifier: MIT
#include "jostle/scenes/bench_scenes.h"

#include <cmath>

#include "scenes/src/bench_scene_parts.h"
#include "scenes/src/scene_helpers.h"

namespace jostle::scenes {

using namespace physics;

namespace {

void add_cube(SceneDescription& scene, const char* name, double half_width, Vec3 center) {
    scene.bodies.push_back(dynamic_body(name, center, Box{{half_width, half_width, half_width}}));
}

SceneDescription flat_pyramid(int base, double pitch) {
    SceneDescription scene;
    add_bench_floor(scene, 200);
    for (int row = 0; row < base; row++)
        for (int k = 0; k < base - row; k++)
            add_cube(scene, "box", 0.5, {(k - (base - row - 1) * 0.5) * pitch, 0.5 + row, 0});
    return with_bench_defaults(std::move(scene));
}

Geometry sphere_box_or_capsule(int index) {
    if (index % 3 == 0) return Sphere{0.3};
    if (index % 3 == 1) return Box{{0.3, 0.25, 0.35}};
    return Capsule{0.2, 0.25};
}

// `count` bodies in layers of side * side, poured between walls.
SceneDescription poured_pile(int count, int side, double half_width) {
    SceneDescription scene;
    add_bench_floor(scene, 200);
    add_bench_walls(scene, half_width);
    Random random;
    for (int i = 0; i < count; i++) {
        const int layer = i / (side * side), cell = i % (side * side);
        const double middle = 0.5 * (side - 1);
        Vec3 at{(cell % side - middle) * 0.75, 0.6 + 0.8 * layer, (cell / side - middle) * 0.75};
        at.x += random.in(-0.03, 0.03);
        at.z += random.in(-0.03, 0.03);
        Vec3 axis;
        for (int k = 0; k < 3; k++) axis[k] = random.in(-1, 1);
        if (length(axis) < 1e-3) axis = {0, 1, 0};
        scene.bodies.push_back(dynamic_body("piece", at, sphere_box_or_capsule(i),
                                            from_axis_angle(axis, random.in(0, 2 * pi))));
    }
    return with_bench_defaults(std::move(scene));
}

// Skips pairs of static bodies: such a joint has no effect, and engines differ in whether they
// accept it.
void join_in_the_middle(SceneDescription& scene, std::size_t a, std::size_t b) {
    const BodyDef &one = scene.bodies[a].body, &other = scene.bodies[b].body;
    if (one.type == BodyType::static_body && other.type == BodyType::static_body) return;
    join(scene, "joint", a, b, {(one.pose.position + other.pose.position) * 0.5, {}}, BallJoint{});
}

}  // namespace

SceneDescription bench_pyramid_465() {
    return flat_pyramid(30, 1.05);
}

SceneDescription bench_pyramid_5050() {
    return flat_pyramid(100, 1.0);
}

SceneDescription bench_boxes_1000() {
    SceneDescription scene;
    add_bench_floor(scene, 200);
    Random random;
    for (int y = 0; y < 10; y++)
        for (int z = 0; z < 10; z++)
            for (int x = 0; x < 10; x++) {
                const double dx = random.in(-0.05, 0.05), dz = random.in(-0.05, 0.05);
                add_cube(scene, "box", 0.5,
                         {(x - 4.5) * 1.2 + dx, 1.5 + 1.2 * y, (z - 4.5) * 1.2 + dz});
            }
    return with_bench_defaults(std::move(scene));
}

SceneDescription bench_pile_5000() {
    return poured_pile(5000, 12, 5);
}

SceneDescription bench_pile(int count) {
    const double width = 10 * std::sqrt(count / 5000.0);
    // As many columns, 0.75 m apart, as fit with enough room for the longest body to rotate at the
    // wall.
    const int side = static_cast<int>(maximum(1, std::floor((width - 1.1) / 0.75) + 1));
    return poured_pile(count, side, 0.5 * width);
}

SceneDescription bench_player_901() {
    SceneDescription scene;
    add_bench_floor(scene, 200);
    for (int z = 0; z < 30; z++)
        for (int x = 0; x < 30; x++) add_cube(scene, "cube", 0.2, {x - 14.5, 0.2, z - 14.5});
    add_cube(scene, "player", 0.75, {-18, 0.75, 0});
    return with_bench_defaults(std::move(scene));
}

SceneDescription bench_ragdolls_40() {
    SceneDescription scene;
    add_bench_floor(scene, 200);
    const Quat leaning = from_axis_angle({1, 0, 0}, 0.35);
    for (int level = 0; level < 10; level++)
        for (int corner = 0; corner < 4; corner++) {
            const Vec3 feet{corner & 1 ? 0.6 : -0.6, 0.5 + 2 * level, corner & 2 ? 0.6 : -0.6};
            const double heading = 0.62831853 * level + 0.3 * corner;
            add_bench_ragdoll(scene, {feet, from_axis_angle({0, 1, 0}, heading) * leaning});
        }
    return with_bench_defaults(std::move(scene));
}

SceneDescription bench_joint_grid_10000() {
    constexpr std::size_t side = 100;
    SceneDescription scene;
    for (std::size_t x = 0; x < side; x++)
        for (std::size_t y = 0; y < side; y++) {
            const std::size_t index = scene.bodies.size();
            const Vec3 at{1.0 * static_cast<double>(x), -1.0 * static_cast<double>(y), 0};
            SceneBody ball = dynamic_body("ball", at, Sphere{0.4});
            if (y == 0 && x >= 47 && x <= 53) ball.body.type = BodyType::static_body;
            ball.shapes[0].filter.mask = 0;  // collides with nothing
            scene.bodies.push_back(ball);
            if (y > 0) join_in_the_middle(scene, index - 1, index);
            if (x > 0) join_in_the_middle(scene, index - side, index);
        }
    return with_bench_defaults(std::move(scene));
}

SceneDescription bench_asleep_10000() {
    SceneDescription scene;
    add_bench_floor(scene, 250);
    for (int z = 0; z < 100; z++)
        for (int x = 0; x < 100; x++)
            add_cube(scene, "box", 0.5, {(x - 49.5) * 2, 0.5, (z - 49.5) * 2});
    return with_bench_defaults(std::move(scene));
}

SceneDescription bench_bullets_1000() {
    SceneDescription scene;
    scene.bodies.push_back(fixed_box("wall", {}, {0.025, 10, 10}));
    Random random;
    for (int i = 0; i < 1000; i++) {
        const Vec3 at{random.in(-15, -5), (i % 32 - 15.5) * 0.5, (i / 32 - 15.5) * 0.5};
        scene.bodies.push_back(dynamic_body("bullet", at, Sphere{0.1}));
        scene.bodies.back().body.linear_velocity = {200, 0, 0};
    }
    return with_bench_defaults(std::move(scene));
}

}  // namespace jostle::scenes
