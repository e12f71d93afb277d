// SPDX-License-Identifier: MIT
#include <cmath>
#include <optional>
#include <utility>

#include "bench/accuracy/accuracy_bodies.h"
#include "bench/accuracy/accuracy_engine_kinds.h"
#include "jostle/physics/hull.h"
#include "jostle/physics/world.h"

namespace jostle::bench::accuracy {
namespace {

using physics::BodyDef;
using physics::BodyId;
using physics::BodyType;
using physics::ShapeDef;

Result<physics::Geometry> geometry_of(const Shape& shape) {
    if (const auto* other = std::get_if<OtherShape>(&shape)) return other->geometry;
    if (const auto* hull = std::get_if<HullPoints>(&shape)) {
        auto built = physics::build_hull(hull->points);
        if (!built) return built.error();
        return physics::Geometry{physics::Hull{*built}};
    }
    physics::Geometry geometry;
    std::visit(
        [&](const auto& primitive) {
            using Kind = std::decay_t<decltype(primitive)>;
            if constexpr (!std::is_same_v<Kind, HullPoints> && !std::is_same_v<Kind, OtherShape>)
                geometry = primitive;
        },
        shape);
    return geometry;
}

class JostleAccuracyEngine final : public Engine {
public:
    Status build(const Scene& scene, const std::string& mode) override {
        // subN: N sub-steps; tolX: a tolerance of X metres; iterative: 8 sub-steps.
        planar_ = scene.planar_world;
        physics::WorldDef def{.gravity = into_world(scene.gravity),
                              .threads = 1,
                              .sleeping = false,
                              .planar = planar_};
        if (mode == "iterative") {
            if (scene.joints.empty()) return Error{.message = "iterative is a mode of joints"};
            def.joint_solver = physics::JointSolver::iterative;
        } else if (mode.starts_with("tol"))
            def.tolerance = std::stod(mode.substr(3));
        else
            def.substeps = std::stoi(mode.substr(3));
        auto world = physics::World::create(def);
        if (!world) return world.error();
        world_.emplace(std::move(*world));
        for (const Body& body : scene.bodies)
            if (auto status = add_body(scene, body); !status) return status;
        for (const Joint& joint : scene.joints)
            if (auto status = add_joint(scene, joint); !status) return status;
        mutual_pull_ = scene.mutual_pull;
        if (scene.central_pull == 0) return {};
        const physics::RadialField pull{
            .strength = -scene.central_pull, .falloff = 2, .min_distance = 1e-3, .per_mass = true};
        if (auto field = world_->create_field({.force = pull}); !field) return field.error();
        return {};
    }

    void step(double dt) override {
        if (mutual_pull_ > 0) pull_each_other(dt);
        if (auto status = world_->step(dt); !status) failure_ = status.error().message;
        const physics::Events events = world_->events();
        triggers_.entered += static_cast<int>(events.triggers_entered.size());
        triggers_.left += static_cast<int>(events.triggers_left.size());
    }

    TriggerCounts trigger_counts() const override { return triggers_; }

    BodyState state(int body) const override {
        const auto now = *world_->body(bodies_[static_cast<std::size_t>(body)]);
        return {out_of_world(now.center), out_of_world(now.pose.rotation),
                out_of_world(now.linear_velocity), out_of_world(now.angular_velocity)};
    }

    void set_damping(double rate) override {
        for (const BodyId body : bodies_)
            if (world_->body(body)->type == BodyType::dynamic)
                static_cast<void>(world_->set_damping(body, rate, rate));
    }

    void set_velocity(int body, Vec3 velocity) override {
        static_cast<void>(world_->set_velocity(bodies_[static_cast<std::size_t>(body)],
                                               into_world(velocity), {}));
    }

    std::string failure() const override { return failure_; }

private:
    // A planar world moves in x and y, a planar scene in x and z: both are rotated about x.
    Vec3 into_world(Vec3 v) const { return planar_ ? Vec3{v.x, v.z, -v.y} : v; }
    Vec3 out_of_world(Vec3 v) const { return planar_ ? Vec3{v.x, -v.z, v.y} : v; }
    Quat into_world(Quat q) const { return planar_ ? Quat{q.x, q.z, -q.y, q.w} : q; }
    Quat out_of_world(Quat q) const { return planar_ ? Quat{q.x, -q.z, q.y, q.w} : q; }
    physics::Geometry into_world(physics::Geometry geometry) const {
        if (!planar_) return geometry;
        if (auto* box = std::get_if<physics::Box>(&geometry))
            std::swap(box->half_extents.y, box->half_extents.z);
        if (auto* plane = std::get_if<physics::Plane>(&geometry))
            plane->normal = into_world(plane->normal);
        return geometry;
    }

    // A force that is constant within a step is integrated exactly. Evaluated at the positions in
    // the middle of the step it is second order, like Jostle's own fields.
    void pull_each_other(double dt) {
        std::vector<Vec3> at;
        std::vector<double> masses;
        for (const BodyId id : bodies_) {
            const auto body = *world_->body(id);
            at.push_back(body.center + body.linear_velocity * (0.5 * dt));
            masses.push_back(body.mass);
        }
        const std::vector<Vec3> forces = mutual_forces(masses, at, mutual_pull_);
        for (std::size_t k = 0; k < bodies_.size(); k++)
            static_cast<void>(
                world_->apply_force(bodies_[k], forces[k], world_->body(bodies_[k])->center));
    }

    Status add_body(const Scene& scene, const Body& body) {
        BodyDef def{.type = body.motion == Motion::fixed       ? BodyType::static_body
                            : body.motion == Motion::kinematic ? BodyType::kinematic
                                                               : BodyType::dynamic,
                    .pose = {into_world(body.pose.position), into_world(body.pose.rotation)},
                    .linear_velocity = into_world(body.velocity),
                    .angular_velocity = into_world(body.spin)};
        if (body.rotation_locked)
            def.locks =
                physics::lock_rotation_x | physics::lock_rotation_y | physics::lock_rotation_z;
        if (body.motion == Motion::free) def.linear_damping = def.angular_damping = scene.damping;
        // The placeholder of a body without collision is as thin as possible; it must not be swept.
        def.continuous = body.shape.has_value();
        ShapeDef shape{.material = {.friction = scene.friction, .restitution = scene.restitution},
                       .mass = body.mass,
                       .trigger = body.trigger};
        if (body.shape) {
            auto geometry = geometry_of(*body.shape);
            if (!geometry) return geometry.error();
            shape.geometry = into_world(*geometry);
        } else {
            shape.geometry = physics::Box{box_of_inertia(body.mass, body.inertia)};
            shape.filter = {.category = 0, .mask = 0};
        }
        auto id = world_->create_body(def, shape);
        if (!id) return id.error();
        bodies_.push_back(*id);
        return {};
    }

    // A body without a shape, created for the first joint that needs it.
    Result<BodyId> ground_body() {
        if (!ground_) {
            auto id = world_->create_body({.type = BodyType::static_body});
            if (!id) return id.error();
            ground_ = *id;
        }
        return *ground_;
    }

    Status add_joint(const Scene& scene, const Joint& joint) {
        physics::JointDef def{.body_b = bodies_[static_cast<std::size_t>(joint.b)],
                              .kind = joint.other ? joint.other->kind : kind_of(scene, joint)};
        if (joint.a == ground) {
            auto id = ground_body();
            if (!id) return id.error();
            def.body_a = *id;
        } else {
            def.body_a = bodies_[static_cast<std::size_t>(joint.a)];
        }
        if (joint.other) {
            def.frame_a = joint.other->frame_a, def.frame_b = joint.other->frame_b;
            if (auto id = world_->create_joint(def); !id) return id.error();
            return {};
        }
        const Quat turned = axes_along(joint.axis);
        const bool two_anchors = joint.kind == JointKind::rod || joint.kind == JointKind::spring;
        const Vec3 end_b =
            two_anchors ? joint.anchor_b : joint.misaligned_anchor_b.value_or(joint.anchor);
        const Transform a = pose_of(scene, joint.a), b = pose_of(scene, joint.b);
        def.frame_a = {apply_inverse(a, joint.anchor), conjugate(a.rotation) * turned};
        def.frame_b = {apply_inverse(b, end_b), conjugate(b.rotation) * turned};
        if (auto id = world_->create_joint(def); !id) return id.error();
        return {};
    }

    static physics::JointKind kind_of(const Scene& scene, const Joint& joint) {
        switch (joint.kind) {
            case JointKind::hinge: {
                physics::HingeJoint hinge;
                if (joint.motor) hinge.motor = {true, joint.motor->speed, joint.motor->max_torque};
                if (joint.limit) hinge.limit = {true, joint.limit->lower, joint.limit->upper};
                return hinge;
            }
            case JointKind::fixed:
                return physics::FixedJoint{};
            case JointKind::rod: {
                const double length = physics::length(joint.anchor_b - joint.anchor);
                return physics::DistanceJoint{.min_length = length, .max_length = length};
            }
            case JointKind::spring: {
                const double mass = reduced_mass(scene, joint);
                const double rate = std::sqrt(joint.stiffness / mass);
                return physics::DistanceJoint{
                    .min_length = 0,
                    .max_length = 1e6,
                    .spring = {rate / (2 * physics::pi), joint.damping / (2 * mass * rate)},
                    .rest_length = joint.rest_length};
            }
            case JointKind::slider:
                return physics::SliderJoint{};
            case JointKind::ball:
                break;
        }
        return physics::BallJoint{};
    }

    std::optional<physics::World> world_;
    std::vector<BodyId> bodies_;
    std::optional<BodyId> ground_;
    double mutual_pull_ = 0;
    bool planar_ = false;
    TriggerCounts triggers_;
    std::string failure_;
};

}  // namespace

std::unique_ptr<Engine> make_jostle_engine() {
    return std::make_unique<JostleAccuracyEngine>();
}

}  // namespace jostle::bench::accuracy
