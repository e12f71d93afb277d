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

constexpr double tolerance = 1e-9;  // m; for rotations the deviation of |w| from 1

// The reason why a body or joint is not portable; null if it is portable.
using Fault = const char*;

bool is_mesh(const physics::ShapeDef& shape) {
    return kind_of(shape.geometry) == ShapeKind::mesh;
}

Fault fault_of(const physics::ShapeDef& shape) {
    const physics::Filter& filter = shape.filter;
    const ShapeKind kind = kind_of(shape.geometry);
    if (kind != ShapeKind::sphere && kind != ShapeKind::capsule && kind != ShapeKind::box &&
        kind != ShapeKind::hull && kind != ShapeKind::mesh)
        return "must be a sphere, capsule, box, hull or mesh";
    if (shape.mass != 0) return "has a mass; must have a density instead";
    if (shape.trigger) return "is a trigger";
    if (shape.material != physics::Material{.friction = shape.material.friction})
        return "has a material with more than friction";
    if (filter.mask != 0 && filter != physics::Filter{})
        return "has a collision filter; must collide with all or, with a mask of 0, with none";
    return nullptr;
}

Fault fault_of(const SceneBody& body) {
    const BodyDef& def = body.body;
    if (def.gravity_scale != 1) return "has a gravity scale";
    if (def.locks != 0) return "has locked axes";
    if (def.mass != 0) return "has a mass; must have a density instead";
    if (!def.sleep_allowed) return "does not allow sleeping";
    for (const physics::ShapeDef& shape : body.shapes) {
        if (const Fault fault = fault_of(shape)) return fault;
        if (is_mesh(shape) && !is_static(body)) return "is a mesh that is not static";
        if (shape.material != body.shapes[0].material) return "has shapes with different friction";
        if (shape.filter != body.shapes[0].filter) return "has shapes with different filters";
    }
    return nullptr;
}

Fault fault_of_kind(const physics::JointKind& kind) {
    if (const auto* hinge = std::get_if<physics::HingeJoint>(&kind))
        return *hinge == physics::HingeJoint{.limit = hinge->limit, .motor = hinge->motor}
                   ? nullptr
                   : "is a hinge with more than limits and a motor";
    if (const auto* shoulder = std::get_if<physics::ConeTwistJoint>(&kind))
        return shoulder->friction_torque == 0 && shoulder->twist.enabled
                   ? nullptr
                   : "is a cone_twist joint with friction or without twist limits";
    return std::holds_alternative<physics::BallJoint>(kind)
               ? nullptr
               : "must be a ball, hinge or cone_twist joint";
}

Fault fault_of(const SceneDescription& scene, const SceneJoint& joint) {
    const physics::JointDef& def = joint.joint;
    if (joint.body_a == scenes::world_body) return "connects a body to the world";
    if (def.collide_connected) return "has collide_connected set";
    if (def.break_force != 0 || def.break_torque != 0) return "is breakable";
    const Transform a = compose(scene.bodies[joint.body_a].body.pose, def.frame_a);
    const Transform b = compose(scene.bodies[joint.body_b].body.pose, def.frame_b);
    if (length(a.position - b.position) > tolerance)
        return "has anchors that are apart at the start";
    const bool turned = physics::absolute((conjugate(a.rotation) * b.rotation).w) < 1 - tolerance;
    if (turned && !std::holds_alternative<physics::BallJoint>(def.kind))
        return "has misaligned frames at the start";
    return fault_of_kind(def.kind);
}

physics::Error not_portable(const char* list, std::size_t index, const std::string& name,
                            const std::string& fault) {
    return {physics::ErrorCode::invalid_argument, std::string(list) + "[" + std::to_string(index) +
                                                      "] '" + name + "' " + fault +
                                                      "; not supported by all engines"};
}

}  // namespace

physics::Status check_portable(const SceneDescription& scene) {
    if (scene.world.planar)
        return physics::Error{physics::ErrorCode::invalid_argument,
                              "world: is planar; not supported by all engines"};
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
