// SPDX-License-Identifier: MIT
#include "bench/speed/portable_scene.h"

#include <stdexcept>
#include <string>

namespace jostle::bench {
namespace {

using physics::BodyDef;
using physics::ShapeKind;
using physics::Transform;
using physics::Vec3;
using scenes::SceneBody;
using scenes::SceneDescription;
using scenes::SceneJoint;

constexpr double together = 1e-9;  // m, and part of a turn

// What a body or joint is or has that is not portable; null when nothing.
using Fault = const char*;

bool is_mesh(const physics::ShapeDef& shape) {
    return kind_of(shape.geometry) == ShapeKind::mesh;
}

Fault fault_of(const physics::ShapeDef& shape) {
    const physics::Filter& filter = shape.filter;
    const ShapeKind kind = kind_of(shape.geometry);
    if (kind != ShapeKind::sphere && kind != ShapeKind::capsule && kind != ShapeKind::box &&
        kind != ShapeKind::hull && kind != ShapeKind::mesh)
        return "is no sphere, capsule, box, hull or mesh";
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
    if (def.gravity_scale != 1) return "has a gravity of its own";
    if (def.locks != 0) return "has locked axes";
    if (def.mass != 0) return "has a given mass; give it a density";
    if (!def.sleep_allowed) return "may not sleep";
    for (const physics::ShapeDef& shape : body.shapes) {
        if (const Fault fault = fault_of(shape)) return fault;
        if (is_mesh(shape) && !is_static(body)) return "is a mesh that moves";
        if (shape.material != body.shapes[0].material) return "has shapes of different friction";
        if (shape.filter != body.shapes[0].filter) return "has shapes that collide differently";
    }
    return nullptr;
}

Fault fault_of_kind(const physics::JointKind& kind) {
    if (const auto* hinge = std::get_if<physics::HingeJoint>(&kind))
        return *hinge == physics::HingeJoint{.limit = hinge->limit}
                   ? nullptr
                   : "is a hinge of more than limits";
    if (const auto* shoulder = std::get_if<physics::ConeTwistJoint>(&kind))
        return shoulder->friction_torque == 0 && shoulder->twist.enabled
                   ? nullptr
                   : "is a shoulder of more than limits, or without";
    return std::holds_alternative<physics::BallJoint>(kind) ? nullptr
                                                            : "is no ball, hinge or cone_twist";
}

Fault fault_of(const SceneDescription& scene, const SceneJoint& joint) {
    const physics::JointDef& def = joint.joint;
    if (joint.body_a == scenes::world_body) return "joins a body to the world";
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

std::vector<Part> parts_of(const SceneBody& body) {
    std::vector<Part> parts;
    for (const physics::ShapeDef& shape : body.shapes)
        parts.push_back({std::visit(
                             [&]<class Shape>(const Shape& one) -> Primitive {
                                 if constexpr (std::is_constructible_v<Primitive, Shape>)
                                     return one;
                                 else
                                     throw std::logic_error("'" + body.name + "' is not portable");
                             },
                             shape.geometry),
                         shape.pose});
    return parts;
}

bool is_dynamic(const SceneBody& body) {
    return body.body.type == physics::BodyType::dynamic;
}

bool is_static(const SceneBody& body) {
    return body.body.type == physics::BodyType::static_body;
}

bool collides(const SceneBody& body) {
    return body.shapes[0].filter.mask != 0;
}

physics::Result<std::vector<SolidMass>> solid_masses(const SceneDescription& scene) {
    const auto built = scenes::build_scene(scene);
    if (!built) return built.error();
    std::vector<SolidMass> masses;
    for (const physics::BodyId id : built->bodies) {
        const physics::BodyState body = built->world.body(id).value();
        const physics::Mat3 axes = to_matrix(body.pose.rotation);
        masses.push_back({body.mass, apply_inverse(body.pose, body.center),
                          transpose(axes) * body.inertia * axes});
    }
    return masses;
}

JointAxes axes_of(const SceneDescription& scene, const SceneJoint& joint) {
    const Transform frame = compose(scene.bodies[joint.body_a].body.pose, joint.joint.frame_a);
    const physics::Mat3 axes = to_matrix(normalized(frame.rotation));
    return {frame.position, axes.x, axes.y, axes.z};
}

}  // namespace jostle::bench
