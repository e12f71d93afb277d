// SPDX-License-Identifier: MIT
//
// Benchmark scenes of jointed bodies with a size to choose: chains, trees and vehicles.
#include <cmath>

#include "jostle/scenes/bench_scenes.h"
#include "scenes/src/bench_scene_parts.h"

namespace jostle::scenes {

using namespace physics;

namespace {

// A fixed box from which bodies hang. It collides with nothing: ODE does not support joints to
// static bodies that collide.
void add_anchor(SceneDescription& scene, Vec3 at) {
    scene.bodies.push_back(fixed_box("anchor", at, {0.2, 0.2, 0.2}));
    scene.bodies.back().shapes[0].filter.mask = 0;
}

void join_to_last(SceneDescription& scene, std::size_t body, Vec3 anchor, const JointKind& kind) {
    join(scene, "joint", body, scene.bodies.size() - 1, {anchor, {}}, kind);
}

// A rotation that turns the y axis into the direction, which has length 1, or into its opposite:
// a capsule has no front.
Quat axis_along(Vec3 direction) {
    const Vec3 up = direction.y < 0 ? -direction : direction;
    return normalized(Quat{up.z, 0, -up.x, 1 + up.y});
}

// Two directions perpendicular to a third and to each other.
struct Across {
    Vec3 x, z;
};
Across across(Vec3 y) {
    const Vec3 other = absolute(y.x) < 0.7 ? Vec3{1, 0, 0} : Vec3{0, 0, 1};
    const Vec3 z = normalized(cross(other, y));
    return {cross(y, z), z};
}

// A branch of capsules joined end to end, whose first joint connects it to the body `parent`. After
// each fourth capsule, another branch begins, up to three levels deep.
void grow(SceneDescription& scene, Random& random, std::size_t parent, Vec3 from, Vec3 direction,
          int level) {
    constexpr double pitch = 0.5;
    const int length = level == 0 ? 16 : 8 - level;
    for (int k = 0; k < length; k++) {
        scene.bodies.push_back(dynamic_body("twig", from + direction * (0.5 * pitch),
                                            Capsule{0.05, 0.14}, axis_along(direction)));
        join_to_last(scene, parent, from, BallJoint{});
        parent = scene.bodies.size() - 1;
        from += direction * pitch;
        if (level == 3 || k % 4 != 3) continue;
        const Across sides = across(direction);
        const SinCos at = sin_cos(random.in(0, 2 * pi));
        const Vec3 out = direction * 0.5 + sides.x * at.cos + sides.z * at.sin;
        grow(scene, random, parent, from, normalized(out), level + 1);
    }
}

void set_material(SceneBody& body, double density, double friction) {
    for (ShapeDef& shape : body.shapes) {
        shape.density = density;
        shape.material.friction = friction;
    }
}

// Vehicles in ten columns on the x axis, whose wheels have motors that drive every second vehicle
// backwards.
class Convoy {
public:
    explicit Convoy(int wheels) : wheels_(wheels), axles_(0.5 * wheels) {}

    // Half of the length of a vehicle, m.
    double half_length() const {
        return maximum(half_chassis(), place(wheels_ - 1) + wheel_radius);
    }
    double pitch() const { return maximum(8, 2 * half_length() + 1); }  // m

    void add_to(SceneDescription& scene) const {
        const Geometry wheel = prism(16, {0, 0, -0.12}, wheel_radius, {0, 0, 0.12}, wheel_radius);
        for (int k = 0; k < 60; k++) {
            const Vec3 middle{(k % 10 - 4.5) * pitch(), 2.4, (k / 10 - 2.5) * 8};
            const std::size_t chassis = scene.bodies.size();
            scene.bodies.push_back(
                dynamic_body("chassis", middle, Box{{half_chassis(), 0.25, 0.5}}));
            const HingeJoint axle{
                .motor = {.enabled = true, .speed = k % 2 == 0 ? 9.0 : -9.0, .max_torque = 120}};
            for (int i = 0; i < wheels_; i++) {
                const Vec3 at = middle + Vec3{place(i), -0.25, i % 2 == 0 ? -0.8 : 0.8};
                scene.bodies.push_back(dynamic_body("wheel", at, wheel));
                join_to_last(scene, chassis, at, axle);
            }
        }
    }

private:
    static constexpr double wheel_radius = 0.35;

    double half_chassis() const { return 0.5 + 0.35 * axles_; }
    double place(int wheel) const { return (wheel / 2 - 0.5 * (axles_ - 1)) * 0.85; }  // along x

    int wheels_;
    double axles_;
};

// The defaults of the benchmark, except that wheels grip and vehicles are light.
SceneDescription with_vehicle_materials(SceneDescription scene) {
    scene = with_bench_defaults(std::move(scene));
    for (SceneBody& body : scene.bodies) {
        if (body.name == "chassis") set_material(body, 300, 0.5);
        if (body.name == "wheel") set_material(body, 400, 0.9);
        if (body.name == "ground") set_material(body, 1000, 0.9);
    }
    return scene;
}

}  // namespace

SceneDescription bench_chain() {
    return bench_chain(1000);
}

SceneDescription bench_chain(int links) {
    SceneDescription scene;
    const Quat along_x = from_axis_angle({0, 0, 1}, -pi / 2);
    for (int k = 0; k < links; k++) {
        scene.bodies.push_back(dynamic_body("link", {0.5 * k, 0, 0}, Capsule{0.1, 0.14}, along_x));
        if (k > 0)
            join_to_last(scene, scene.bodies.size() - 2, {0.5 * k - 0.25, 0, 0}, BallJoint{});
    }
    scene.bodies[0].body.type = BodyType::static_body;
    return with_bench_defaults(std::move(scene));
}

SceneDescription bench_hanging_chain(int links) {
    SceneDescription scene;
    add_anchor(scene, {});
    for (int k = 0; k < links; k++) {
        scene.bodies.push_back(dynamic_body("link", {0, -0.45 - 0.4 * k, 0}, Capsule{0.08, 0.1}));
        if (k > links / 2)
            scene.bodies.back().body.linear_velocity = {3 * sin_cos(0.02 * k).sin, 0, 0};
        join_to_last(scene, scene.bodies.size() - 2, {0, -0.25 - 0.4 * k, 0}, BallJoint{});
    }
    return with_bench_defaults(std::move(scene));
}

SceneDescription bench_hinge_chain(int links) {
    SceneDescription scene;
    const Quat along_x = from_axis_angle({0, 0, 1}, pi / 2);
    add_anchor(scene, {});
    for (int k = 0; k < links; k++) {
        scene.bodies.push_back(
            dynamic_body("link", {0.25 + 0.4 * k, 0, 0}, Capsule{0.08, 0.1}, along_x));
        join_to_last(scene, scene.bodies.size() - 2, {0.05 + 0.4 * k, 0, 0}, HingeJoint{});
    }
    return with_bench_defaults(std::move(scene));
}

SceneDescription bench_joint_tree(int trees) {
    SceneDescription scene;
    Random random;
    for (int k = 0; k < trees; k++) {
        const Vec3 root{(k % 5) * 14.0, 0, (k / 5) * 14.0};
        add_anchor(scene, root);
        grow(scene, random, scene.bodies.size() - 1, root, {0, -1, 0}, 0);
    }
    for (SceneBody& body : scene.bodies)
        if (body.body.type == BodyType::dynamic)
            body.body.linear_velocity = {2 * sin_cos(body.body.pose.position.y).sin, 0, 1};
    return with_bench_defaults(std::move(scene));
}

SceneDescription bench_wheels(int wheels) {
    SceneDescription scene;
    add_bench_floor(scene, 200);
    Convoy(wheels).add_to(scene);
    return with_vehicle_materials(std::move(scene));
}

SceneDescription bench_wheels_mesh(int wheels, double cell) {
    const Convoy convoy(wheels);
    const double width = maximum(88, 9 * convoy.pitch() + 2 * convoy.half_length() + 8);
    SceneDescription scene;
    scene.bodies.push_back(mesh_ground(
        static_cast<std::uint32_t>(std::ceil(width / cell)), cell, [](double x, double z) {
            return 0.25 * sin_cos(0.7 * x).sin * sin_cos(0.6 * z).cos +
                   0.1 * sin_cos(3 * x + z).sin;
        }));
    convoy.add_to(scene);
    return with_vehicle_materials(std::move(scene));
}

}  // namespace jostle::scenes
