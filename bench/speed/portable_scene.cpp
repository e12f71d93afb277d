// SPDX-License-Identifier: MIT
#include "speed/portable_scene.h"

#include <stdexcept>
#include <string>

namespace jostle::bench {
namespace {

using physics::BodyDef;
using physics::pi;
using physics::ShapeKind;
using physics::Transform;
using physics::Vec3;
using scenes::SceneBody;
using scenes::SceneDescription;
using scenes::SceneJoint;

constexpr double together = 1e-9;  // m, and part of a turn

// What a body or joint is or has that is not portable; null when nothing.
using Fault = const char*;

Fault fault_of(const physics::ShapeDef& shape) {
    const physics::Filter& filter = shape.filter;
    const ShapeKind kind = kind_of(shape.geometry);
    if (kind != ShapeKind::sphere && kind != ShapeKind::capsule && kind != ShapeKind::box)
        return "is no sphere, capsule or box";
    if (shape.pose != Transform{}) return "has a shape that is off its middle";
    if (shape.mass != 0) return "has a given mass; give it a density";
    if (shape.trigger) return "is a trigger";
    if (shape.material != physics::Material{.friction = shape.material.friction})
        return "has a material of more than friction";
    if (filter.mask != 0 && filter != physics::Filter{})
        return "collides with some; let it collide with all, or with none by a mask of 0";
    return nullptr;
}

Fault fault_of(const SceneBody& body) {
    const BodyDef& def = body.body;
    if (def.type == physics::BodyType::kinematic) return "is kinematic";
    if (def.gravity_scale != 1) return "has a gravity of its own";
    if (def.locks != 0) return "has locked axes";
    if (def.mass != 0) return "has a given mass; give it a density";
    if (!def.sleep_allowed) return "may not sleep";
    if (body.shapes.size() != 1) return "has not one shape";
    return fault_of(body.shapes[0]);
}

Fault fault_of_kind(const physics::JointKind& kind) {
    if (const auto* hinge = std::get_if<physics::HingeJoint>(&kind))
        return *hinge == physics::HingeJoint{.limit = hinge->limit} && hinge->limit.enabled
                   ? nullptr
                   : "is a hinge of more than limits, or without";
    if (const auto* shoulder = std::get_if<physics::ConeTwistJoint>(&kind))
        return shoulder->friction_torque == 0 && shoulder->twist.enabled
                   ? nullptr
                   : "is a shoulder of more than limits, or without";
    return std::holds_alternative<physics::BallJoint>(kind) ? nullptr
                                                            : "is no ball, hinge or cone_twist";
}

Fault fault_of(const SceneDescription& scene, const SceneJoint& joint) {
    const physics::JointDef& def = joint.joint;
    if (joint.body_a == scenes::the_world) return "joins a body to the world";
    if (def.collide_connected) return "lets its bodies collide";
    if (def.break_force != 0 || def.break_torque != 0) return "breaks";
    const Transform a = compose(scene.bodies[joint.body_a].body.pose, def.frame_a);
    const Transform b = compose(scene.bodies[joint.body_b].body.pose, def.frame_b);
    if (length(a.position - b.position) > together) return "has ends that are apart at the start";
    const bool turned = physics::absolute((conjugate(a.rotation) * b.rotation).w) < 1 - together;
    if (turned && !std::holds_alternative<physics::BallJoint>(def.kind))
        return "has ends that are turned against each other at the start";
    return fault_of_kind(def.kind);
}

physics::Error not_portable(const char* list, std::size_t index, const std::string& name,
                            const std::string& fault) {
    return {physics::ErrorCode::invalid_argument,
            std::string(list) + "[" + std::to_string(index) + "] '" + name + "' " + fault +
                "; other engines could not be given the same"};
}

SolidMass mass_of(const physics::Sphere& sphere, double density) {
    const double r = sphere.radius, mass = density * 4 / 3 * pi * r * r * r,
                 turn = 0.4 * mass * r * r;
    return {mass, {turn, turn, turn}};
}

SolidMass mass_of(const physics::Box& box, double density) {
    const Vec3 h = box.half_extents, s = scaled(h, h);
    const double mass = density * 8 * h.x * h.y * h.z;
    return {mass, Vec3{s.y + s.z, s.x + s.z, s.x + s.y} * (mass / 3)};
}

// A cylinder and two half balls, each of which has its own centre 3/8 r from its disc.
SolidMass mass_of(const physics::Capsule& capsule, double density) {
    const double r = capsule.radius, length = 2 * capsule.half_length;
    const double tube = density * pi * r * r * length, ball = density * 4 / 3 * pi * r * r * r;
    const double along = tube * r * r / 2 + ball * 0.4 * r * r;
    const double across = tube * (length * length / 12 + r * r / 4) +
                          ball * (0.4 * r * r + length * length / 4 + 3.0 / 8 * length * r);
    return {tube + ball, {across, along, across}};
}

}  // namespace

physics::Status check_portable(const SceneDescription& scene) {
    if (scene.world.planar)
        return physics::Error{physics::ErrorCode::invalid_argument,
                              "world: is planar; other engines could not be given the same"};
    for (std::size_t i = 0; i < scene.bodies.size(); i++)
        if (const Fault fault = fault_of(scene.bodies[i]))
            return not_portable("bodies", i, scene.bodies[i].name, fault);
    for (std::size_t i = 0; i < scene.joints.size(); i++)
        if (const Fault fault = fault_of(scene, scene.joints[i]))
            return not_portable("joints", i, scene.joints[i].name, fault);
    return {};
}

Primitive primitive_of(const SceneBody& body) {
    return std::visit(
        [&]<class Shape>(const Shape& shape) -> Primitive {
            if constexpr (std::is_constructible_v<Primitive, Shape>)
                return shape;
            else
                throw std::logic_error("'" + body.name + "' is no sphere, capsule or box");
        },
        body.shapes.at(0).geometry);
}

bool is_static(const SceneBody& body) {
    return body.body.type == physics::BodyType::static_body;
}

bool collides(const SceneBody& body) {
    return body.shapes[0].filter.mask != 0;
}

SolidMass solid_mass(const SceneBody& body) {
    return std::visit([&](const auto& shape) { return mass_of(shape, body.shapes[0].density); },
                      primitive_of(body));
}

JointAxes axes_of(const SceneDescription& scene, const SceneJoint& joint) {
    const Transform frame = compose(scene.bodies[joint.body_a].body.pose, joint.joint.frame_a);
    const physics::Mat3 axes = to_matrix(normalized(frame.rotation));
    return {frame.position, axes.x, axes.y, axes.z};
}

}  // namespace jostle::bench
