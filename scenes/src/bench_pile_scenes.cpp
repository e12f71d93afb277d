// SPDX-License-Identifier: MIT
//
// Benchmark scenes of many bodies with a size to choose: bodies poured between walls, stacks, a
// burst of debris, and bodies on hills.
#include <cmath>

#include "jostle/scenes/bench_scenes.h"
#include "scenes/src/bench_scene_parts.h"

namespace jostle::scenes {

using namespace physics;

namespace {

// Number of cells along a side of a layer. The number of layers is about that of the default count,
// so that the depth of a pile does not depend on the count.
int side_of(int count, int default_count, int default_side) {
    return static_cast<int>(
        maximum(1, std::floor(default_side * std::sqrt(1.0 * count / default_count) + 0.5)));
}

// A grid of cells in which bodies start: layers of side * side cells, `pitch` apart.
struct Grid {
    int side;
    double pitch;   // m
    double lowest;  // height of the first layer, m

    Vec3 cell(int k) const {
        const int in_layer = k % (side * side), layer = k / (side * side);
        const double middle = 0.5 * (side - 1);
        return {(in_layer % side - middle) * pitch, lowest + 1.05 * layer * pitch,
                (in_layer / side - middle) * pitch};
    }
};

Vec3 shifted(Random& random, Vec3 at, double most) {
    at.x += random.in(-most, most);
    at.z += random.in(-most, most);
    return at;
}

// Walls around the grid, higher than its first `count` cells.
void add_container(SceneDescription& scene, const Grid& grid, int count) {
    add_bench_floor(scene, 200);
    add_bench_walls(scene, 0.5 * grid.side * grid.pitch + 0.1,
                    maximum(20, grid.cell(count - 1).y + grid.pitch));
}

// Pours bodies of these geometries in turn, with random rotations. They do not overlap at the start
// if their diameter is below pitch - 0.06 m.
SceneDescription poured(Random& random, int count, const Grid& grid,
                        std::span<const Geometry> kinds) {
    SceneDescription scene;
    add_container(scene, grid, count);
    for (int k = 0; k < count; k++) {
        const Vec3 at = shifted(random, grid.cell(k), 0.03);
        scene.bodies.push_back(dynamic_body(
            "piece", at, kinds[static_cast<std::size_t>(k) % kinds.size()], random_turn(random)));
    }
    return with_bench_defaults(std::move(scene));
}

}  // namespace

SceneDescription bench_hull_heap(int count, int vertices) {
    Random random;
    const std::vector<Geometry> hulls =
        vertices < 64
            ? round_stones(random, 12, vertices, 0.34)
            : std::vector<Geometry>{prism(vertices / 2, {0, -0.2, 0}, 0.28, {0, 0.2, 0}, 0.28)};
    return poured(random, count, {side_of(count, 1000, 8), 0.75, 0.6}, hulls);
}

SceneDescription bench_mixed_masses(int count) {
    constexpr int steps = 30;                                 // from 10 to 10,000 kg/m^3
    constexpr double tenth_of_decade = 1.258925411794167210;  // 10^0.1
    const Geometry kinds[] = {Sphere{0.3}, Box{{0.26, 0.2, 0.28}}, Capsule{0.2, 0.2}};
    Random random;
    SceneDescription scene = poured(random, count, {side_of(count, 1500, 8), 0.93, 0.6}, kinds);
    for (SceneBody& body : scene.bodies) {
        if (body.body.type == BodyType::static_body) continue;
        double density = 10;
        for (double k = random.in(0, steps + 1); k >= 1; k--) density *= tenth_of_decade;
        body.shapes[0].density = density;
    }
    return scene;
}

SceneDescription bench_spheres(int count) {
    Random random;
    const Geometry sphere = Sphere{0.3};
    return poured(random, count, {side_of(count, 10000, 22), 0.7, 0.6}, {&sphere, 1});
}

SceneDescription bench_capsules(int count) {
    Random random;
    const Geometry capsule = Capsule{0.2, 0.25};
    return poured(random, count, {side_of(count, 4000, 14), 0.97, 0.6}, {&capsule, 1});
}

SceneDescription bench_ragdoll_pile(int figures) {
    const Vec3 middle{0, 0.9, 0};  // of a figure, above its feet
    const Grid grid{side_of(figures, 100, 3), 2, 1.1};
    SceneDescription scene;
    add_container(scene, grid, figures);
    for (int k = 0; k < figures; k++) {
        const int in_layer = k % (grid.side * grid.side);
        const Quat turn =
            from_axis_angle({0, 1, 0}, 0.7 * k) * from_axis_angle({1, 0, 0}, 0.5 + 0.3 * in_layer);
        add_bench_ragdoll(scene, {grid.cell(k) - rotate(turn, middle), turn});
    }
    return with_bench_defaults(std::move(scene));
}

SceneDescription bench_stacks(int stacks) {
    const int side = static_cast<int>(std::ceil(std::sqrt(1.0 * stacks)));
    const Grid grid{side, 3, 0.45};
    SceneDescription scene;
    add_bench_floor(scene, 1.5 * side + 50);
    for (int k = 0; k < stacks; k++)
        for (int level = 0; level < 3; level++)
            scene.bodies.push_back(dynamic_body("box", grid.cell(k) + Vec3{0, 0.9 * level, 0},
                                                Box{{0.4, 0.4, 0.4}},
                                                from_axis_angle({0, 1, 0}, 0.1 * level)));
    return with_bench_defaults(std::move(scene));
}

SceneDescription bench_debris(int hulls) {
    int side = 1;
    while (side * side * side < 1.44 * hulls) side++;
    const double middle = 0.5 * (side - 1);
    SceneDescription scene;
    add_bench_floor(scene, 200);
    Random random;
    const auto stones = round_stones(random, 8, 12, 0.25);
    for (int k = 0; k < hulls; k++) {
        const Vec3 at{(k % side - middle) * 0.5, 0.4 + 0.52 * (k / (side * side)),
                      (k / side % side - middle) * 0.5};
        const double x = random.in(-1, 1), y = random.in(0.1, 1.5), z = random.in(-1, 1);
        SceneBody body = dynamic_body("debris", at, stones[static_cast<std::size_t>(k) % 8],
                                      random_turn(random));
        body.body.linear_velocity = normalized(Vec3{x, y, z}) * random.in(10, 40);
        for (int axis = 0; axis < 3; axis++) body.body.angular_velocity[axis] = random.in(-10, 10);
        scene.bodies.push_back(body);
    }
    return with_bench_defaults(std::move(scene));
}

SceneDescription bench_mesh(int count, double cell) {
    constexpr double width = 150;  // m
    SceneDescription scene;
    scene.bodies.push_back(mesh_ground(
        static_cast<std::uint32_t>(std::ceil(width / cell)), cell, [](double x, double z) {
            return 1.2 * sin_cos(0.3 * x).sin * sin_cos(0.27 * z).cos +
                   0.12 * sin_cos(2.1 * x).sin * sin_cos(1.9 * z).cos;
        }));
    Random random;
    const auto stones = round_stones(random, 10, 14, 0.4);
    const Geometry kinds[] = {Sphere{0.35}, Box{{0.35, 0.25, 0.4}}, Capsule{0.2, 0.3}};
    const Grid grid{18, 3.2, 4};
    for (int k = 0; k < count; k++) {
        const Vec3 at = shifted(random, grid.cell(k), 0.5);
        const Geometry& geometry =
            k % 4 < 3 ? kinds[k % 4] : stones[static_cast<std::size_t>(k) % stones.size()];
        scene.bodies.push_back(dynamic_body("piece", at, geometry, random_turn(random)));
    }
    return with_bench_defaults(std::move(scene));
}

}  // namespace jostle::scenes
