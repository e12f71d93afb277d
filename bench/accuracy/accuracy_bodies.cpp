// SPDX-License-Identifier: MIT
#include "bench/accuracy/accuracy_bodies.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "jostle/physics/hull.h"

namespace jostle::bench::accuracy {

namespace {

constexpr double thinnest = physics::min_shape_size;

Body solid(double mass, Vec3 inertia, Shape shape, Vec3 position) {
    return {.mass = mass, .inertia = inertia, .shape = std::move(shape), .pose = {position, {}}};
}

}  // namespace

Vec3 box_inertia(double mass, Vec3 half_extents) {
    const Vec3 h = scaled(half_extents, half_extents);
    return Vec3{h.y + h.z, h.x + h.z, h.x + h.y} * (mass / 3);
}

Vec3 sphere_inertia(double mass, double radius) {
    const double inertia = 0.4 * mass * radius * radius;
    return {inertia, inertia, inertia};
}

Vec3 capsule_inertia(double mass, double radius, double half_length) {
    const double r = radius, l = 2 * half_length;
    const double density = mass / (physics::pi * r * r * (l + 4.0 / 3 * r));
    const double tube = density * physics::pi * r * r * l;
    const double caps = mass - tube;
    const double along = tube * r * r / 2 + caps * 0.4 * r * r;
    const double across =
        tube * (l * l / 12 + r * r / 4) + caps * (0.4 * r * r + l * l / 4 + 3.0 / 8 * l * r);
    return {across, along, across};
}

Vec3 box_of_inertia(double mass, Vec3 inertia) {
    const double half_sum = 0.5 * (inertia.x + inertia.y + inertia.z);
    Vec3 h;
    for (int k = 0; k < 3; k++) {
        const double square = 3 / mass * (half_sum - inertia[k]);
        h[k] = std::max(std::sqrt(std::max(square, 0.0)), thinnest);
    }
    return h;
}

Body solid_box(double mass, Vec3 half_extents, Vec3 position) {
    return solid(mass, box_inertia(mass, half_extents), physics::Box{half_extents}, position);
}

Body solid_sphere(double mass, double radius, Vec3 position) {
    return solid(mass, sphere_inertia(mass, radius), physics::Sphere{radius}, position);
}

Body solid_cylinder(double mass, double radius, double half_length, Vec3 position) {
    const double across = mass * (radius * radius / 4 + half_length * half_length / 3);
    return solid(mass, {across, mass * radius * radius / 2, across},
                 physics::Cylinder{radius, half_length}, position);
}

Body solid_capsule(double mass, double radius, double half_length, Vec3 position) {
    return solid(mass, capsule_inertia(mass, radius, half_length),
                 physics::Capsule{radius, half_length}, position);
}

Body solid_hull(double density, std::span<const Vec3> points) {
    const auto hull = physics::build_hull(points).value();
    HullPoints centered;
    for (const Vec3 point : points) centered.points.push_back(point - hull->center);
    const physics::Mat3& unit = hull->unit_inertia;
    return solid(density * hull->volume, Vec3{unit.x.x, unit.y.y, unit.z.z} * density, centered,
                 hull->center);
}

Body fixed_plane() {
    return {.motion = Motion::fixed, .shape = physics::Plane{{0, 0, 1}}};
}

Body fixed_box(Vec3 half_extents, Vec3 position) {
    return {.motion = Motion::fixed, .shape = physics::Box{half_extents}, .pose = {position, {}}};
}

Body fixed_shape(physics::Geometry geometry, Vec3 position, Quat rotation) {
    return {.motion = Motion::fixed,
            .shape = OtherShape{std::move(geometry)},
            .pose = {position, rotation}};
}

std::string feature_of_jostle_only(const Scene& scene) {
    if (scene.planar_world) return "planar worlds";
    for (const Body& body : scene.bodies) {
        if (body.trigger) return "triggers";
        if (body.rotation_locked) return "locked rotations";
        if (body.shape && std::holds_alternative<OtherShape>(*body.shape))
            return kind_name(kind_of(std::get<OtherShape>(*body.shape).geometry)) +
                   std::string(" shapes");
        if (body.motion == Motion::kinematic && length(body.spin) > 0)
            return "rotating driven bodies";
    }
    for (const Joint& joint : scene.joints)
        if (joint.other) return std::string(physics::kind_name(joint.other->kind)) + " joints";
    return {};
}

Body without_shape(Body body) {
    body.shape.reset();
    return body;
}

Joint ball_at(int a, int b, Vec3 anchor) {
    return {.kind = JointKind::ball, .a = a, .b = b, .anchor = anchor};
}

Joint hinge_at(int a, int b, Vec3 anchor, Vec3 axis) {
    return {.kind = JointKind::hinge, .a = a, .b = b, .anchor = anchor, .axis = axis};
}

Quat axes_along(Vec3 axis) {
    const Vec3 z{0, 0, 1}, turn = cross(z, axis);
    const double sine = length(turn), cosine = dot(z, axis);
    if (sine < 1e-12) return cosine > 0 ? Quat{} : Quat{1, 0, 0, 0};
    return physics::from_axis_angle(turn, std::atan2(sine, cosine));
}

Transform pose_of(const Scene& scene, int body) {
    return body == ground ? Transform{} : scene.bodies[static_cast<std::size_t>(body)].pose;
}

double reduced_mass(const Scene& scene, const Joint& joint) {
    const auto inverse_of = [&](int body) {
        if (body == ground) return 0.0;
        const Body& end = scene.bodies[static_cast<std::size_t>(body)];
        return end.motion == Motion::free ? 1 / end.mass : 0.0;
    };
    return 1 / (inverse_of(joint.a) + inverse_of(joint.b));
}

std::vector<Vec3> mutual_forces(std::span<const double> masses, std::span<const Vec3> at,
                                double pull) {
    std::vector<Vec3> forces(at.size());
    for (std::size_t a = 0; a < at.size(); a++)
        for (std::size_t b = 0; b < a; b++) {
            const Vec3 offset = at[b] - at[a];
            const double distance = length(offset);
            const Vec3 force =
                offset * (pull * masses[a] * masses[b] / (distance * distance * distance));
            forces[a] += force;
            forces[b] -= force;
        }
    return forces;
}

Vec3 azimuth(double angle) {
    return {std::cos(angle), std::sin(angle), 0};
}

double kinetic_energy(const Body& body, Quat rotation, Vec3 velocity, Vec3 spin) {
    const Vec3 local = inverse_rotate(rotation, spin);
    return 0.5 * (body.mass * dot(velocity, velocity) + dot(local, scaled(body.inertia, local)));
}

Vec3 spin_momentum(const Body& body, Quat rotation, Vec3 spin) {
    return rotate(rotation, scaled(body.inertia, inverse_rotate(rotation, spin)));
}

// Sliders first: the body of a slider is attached to its rail rather than to the end of a loop.
BodyTree tree_of(const Scene& scene) {
    BodyTree tree;
    tree.nodes.resize(scene.bodies.size());
    const auto hang = [&](const Joint& joint) {
        BodyTree::Node& node = tree.nodes[static_cast<std::size_t>(joint.b)];
        if (node.joint) {
            tree.loops.push_back(joint);
            return;
        }
        node = {joint.a, joint};
    };
    for (const Joint& joint : scene.joints)
        if (joint.kind == JointKind::slider) hang(joint);
    for (const Joint& joint : scene.joints)
        if (joint.kind != JointKind::slider && joint.kind != JointKind::spring) hang(joint);
    return tree;
}

}  // namespace jostle::bench::accuracy
