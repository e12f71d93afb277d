// SPDX-License-Identifier: MIT
#include "speed/lab_scenes.h"

#include <cmath>

#include "speed/ragdoll.h"

namespace jostle::bench {
namespace {

using physics::Box;
using physics::Capsule;
using physics::Quat;
using physics::Sphere;
using physics::Vec3;

// The scenes' own random numbers: Numerical Recipes' LCG, of which the upper 24 bits count.
class Draws {
public:
    double between(double low, double high) {
        state_ = state_ * 1664525u + 1013904223u;
        return low + (high - low) * ((state_ >> 8) * 0x1p-24);
    }

private:
    std::uint32_t state_ = 12345;
};

void add_fixed_box(SceneDescription& scene, Vec3 half_extents, Vec3 center) {
    scene.bodies.push_back(
        {.form = Box{half_extents}, .pose = {.position = center}, .fixed = true});
}

void add_floor(SceneDescription& scene, double half_width) {
    add_fixed_box(scene, {half_width, 1, half_width}, {0, -1, 0});
}

void add_cube(SceneDescription& scene, double half_width, Vec3 center) {
    scene.bodies.push_back(
        {.form = Box{{half_width, half_width, half_width}}, .pose = {.position = center}});
}

SceneDescription pyramid(int base, double pitch) {
    SceneDescription scene;
    add_floor(scene, 200);
    for (int row = 0; row < base; row++)
        for (int k = 0; k < base - row; k++)
            add_cube(scene, 0.5, {(k - (base - row - 1) * 0.5) * pitch, 0.5 + row, 0});
    return scene;
}

SceneDescription pyramid_465() {
    return pyramid(30, 1.05);
}

SceneDescription pyramid_5050() {
    return pyramid(100, 1.0);
}

SceneDescription boxes_1000() {
    SceneDescription scene;
    add_floor(scene, 200);
    Draws draws;
    for (int y = 0; y < 10; y++)
        for (int z = 0; z < 10; z++)
            for (int x = 0; x < 10; x++) {
                const double dx = draws.between(-0.05, 0.05), dz = draws.between(-0.05, 0.05);
                add_cube(scene, 0.5, {(x - 4.5) * 1.2 + dx, 1.5 + 1.2 * y, (z - 4.5) * 1.2 + dz});
            }
    return scene;
}

// Four walls, 20 m high and 1 m thick, around a square of this inner half width.
void add_walls(SceneDescription& scene, double half_width) {
    for (const double side : {1.0, -1.0})
        add_fixed_box(scene, {0.5, 10, half_width + 1}, {side * (half_width + 0.5), 10, 0});
    for (const double side : {1.0, -1.0})
        add_fixed_box(scene, {half_width + 1, 10, 0.5}, {0, 10, side * (half_width + 0.5)});
}

Form mixed_form(int index) {
    if (index % 3 == 0) return Sphere{0.3};
    if (index % 3 == 1) return Box{{0.3, 0.25, 0.35}};
    return Capsule{0.2, 0.25};
}

// `count` bodies in layers of side * side, poured between walls.
SceneDescription poured(int count, int side, double half_width) {
    SceneDescription scene;
    add_floor(scene, 200);
    add_walls(scene, half_width);
    Draws draws;
    for (int i = 0; i < count; i++) {
        const int layer = i / (side * side), cell = i % (side * side);
        const double middle = 0.5 * (side - 1);
        Vec3 at{(cell % side - middle) * 0.75, 0.6 + 0.8 * layer, (cell / side - middle) * 0.75};
        at.x += draws.between(-0.03, 0.03);
        at.z += draws.between(-0.03, 0.03);
        Vec3 axis;
        for (int k = 0; k < 3; k++) axis[k] = draws.between(-1, 1);
        if (length(axis) < 1e-3) axis = {0, 1, 0};
        const Quat turned = physics::from_axis_angle(axis, draws.between(0, 2 * physics::pi));
        scene.bodies.push_back({.form = mixed_form(i), .pose = {at, turned}});
    }
    return scene;
}

SceneDescription pile_5000() {
    return poured(5000, 12, 5);
}

SceneDescription player_901() {
    SceneDescription scene;
    add_floor(scene, 200);
    for (int z = 0; z < 30; z++)
        for (int x = 0; x < 30; x++) add_cube(scene, 0.2, {x - 14.5, 0.2, z - 14.5});
    scene.player = static_cast<std::uint32_t>(scene.bodies.size());
    add_cube(scene, 0.75, {-18, 0.75, 0});
    return scene;
}

SceneDescription ragdolls_40() {
    SceneDescription scene;
    add_floor(scene, 200);
    const Quat leaning = physics::from_axis_angle({1, 0, 0}, 0.35);
    for (int level = 0; level < 10; level++)
        for (int corner = 0; corner < 4; corner++) {
            const Vec3 feet{corner & 1 ? 0.6 : -0.6, 0.5 + 2 * level, corner & 2 ? 0.6 : -0.6};
            const double heading = 0.62831853 * level + 0.3 * corner;
            add_ragdoll(scene, {feet, physics::from_axis_angle({0, 1, 0}, heading) * leaning});
        }
    return scene;
}

// A joint between two fixed bodies holds nothing, and engines differ in whether they take it.
void join(SceneDescription& scene, std::uint32_t a, std::uint32_t b) {
    const SceneBody &one = scene.bodies[a], &other = scene.bodies[b];
    if (one.fixed && other.fixed) return;
    scene.joints.push_back(
        {.a = a, .b = b, .anchor = (one.pose.position + other.pose.position) * 0.5});
}

SceneDescription joint_grid_10000() {
    constexpr std::uint32_t side = 100;
    SceneDescription scene;
    for (std::uint32_t x = 0; x < side; x++)
        for (std::uint32_t y = 0; y < side; y++) {
            const auto index = static_cast<std::uint32_t>(scene.bodies.size());
            scene.bodies.push_back({.form = Sphere{0.4},
                                    .pose = {.position = {1.0 * x, -1.0 * y, 0}},
                                    .fixed = y == 0 && x >= 47 && x <= 53,
                                    .collides = false});
            if (y > 0) join(scene, index - 1, index);
            if (x > 0) join(scene, index - side, index);
        }
    return scene;
}

SceneDescription asleep_10000() {
    SceneDescription scene;
    scene.asleep_first = true;
    add_floor(scene, 250);
    for (int z = 0; z < 100; z++)
        for (int x = 0; x < 100; x++) add_cube(scene, 0.5, {(x - 49.5) * 2, 0.5, (z - 49.5) * 2});
    return scene;
}

SceneDescription bullets_1000() {
    SceneDescription scene;
    scene.steps = 120;
    scene.tunnelled_beyond_x = 0;
    add_fixed_box(scene, {0.025, 10, 10}, {});
    Draws draws;
    for (int i = 0; i < 1000; i++)
        scene.bodies.push_back({.form = Sphere{0.1},
                                .pose = {.position = {draws.between(-15, -5), (i % 32 - 15.5) * 0.5,
                                                      (i / 32 - 15.5) * 0.5}},
                                .velocity = {200, 0, 0},
                                .sweeps = true});
    return scene;
}

constexpr LabScene scenes[] = {
    {"a", "pyramid-465", "a flat pyramid of 30 rows of 1 m boxes with gaps of 5 cm", pyramid_465},
    {"b", "pyramid-5050", "the same of 100 rows without gaps", pyramid_5050},
    {"c", "boxes-1000", "10 x 10 x 10 boxes dropped in a block", boxes_1000},
    {"d", "pile-5000", "5000 spheres, boxes and capsules poured between four walls", pile_5000},
    {"e", "player-901", "900 cubes on a floor and one that is driven through them", player_901},
    {"f", "ragdolls-40", "40 figures of 11 capsules and 10 joints fall on each other", ragdolls_40},
    {"g", "joint-grid-10000",
     "a cloth of 100 x 100 balls and 19,794 joints hangs from seven fixed ones", joint_grid_10000},
    {"h", "asleep-10000", "10,000 boxes at rest: timed once all are asleep", asleep_10000},
    {"i", "bullets-1000", "1000 spheres at 200 m/s against a wall of 5 cm (120 steps)",
     bullets_1000},
};

}  // namespace

std::span<const LabScene> lab_scenes() {
    return scenes;
}

const LabScene* find_lab_scene(std::string_view letter_or_name) {
    for (const LabScene& scene : scenes)
        if (letter_or_name == scene.letter || letter_or_name == scene.name) return &scene;
    return nullptr;
}

SceneDescription poured_pile(int count) {
    const double width = 10 * std::sqrt(count / 5000.0);
    // As many columns, 0.75 m apart, as leave room for the longest body to turn at the wall.
    const int side = static_cast<int>(physics::maximum(1, std::floor((width - 1.1) / 0.75) + 1));
    return poured(count, side, 0.5 * width);
}

}  // namespace jostle::bench
