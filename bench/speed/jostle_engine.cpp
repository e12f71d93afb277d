// SPDX-License-Identifier: MIT
#include "speed/jostle_engine.h"

#include <optional>
#include <vector>

#include "jostle/physics/world.h"

namespace jostle::bench {
namespace {

using physics::BodyId;
using physics::Mat3;
using physics::Quat;
using physics::Transform;
using physics::Vec3;

// The rotation whose columns are x, y, z (Shepperd's method: divide by the largest component).
Quat from_axes(const Mat3& m) {
    const double trace = m.x.x + m.y.y + m.z.z;
    if (trace > 0) {
        const double s = 2 * physics::square_root(trace + 1);
        return normalized(
            Quat{(m.y.z - m.z.y) / s, (m.z.x - m.x.z) / s, (m.x.y - m.y.x) / s, s / 4});
    }
    if (m.x.x >= m.y.y && m.x.x >= m.z.z) {
        const double s = 2 * physics::square_root(1 + m.x.x - m.y.y - m.z.z);
        return normalized(
            Quat{s / 4, (m.x.y + m.y.x) / s, (m.x.z + m.z.x) / s, (m.y.z - m.z.y) / s});
    }
    // Named anew, the two other cases are the first of the three: turn the axes round.
    const Quat turned =
        from_axes({{m.y.y, m.y.z, m.y.x}, {m.z.y, m.z.z, m.z.x}, {m.x.y, m.x.z, m.x.x}});
    return {turned.z, turned.x, turned.y, turned.w};
}

// A hinge turns about its frame's z axis; a shoulder points along x.
Transform joint_frame(const SceneJoint& joint, const Transform& body) {
    const bool hinge = joint.kind == SceneJointKind::hinge;
    const Vec3 x = hinge ? joint.normal : joint.axis, z = hinge ? joint.axis : joint.normal;
    const Quat in_world = from_axes({x, cross(z, x), z});
    return {apply_inverse(body, joint.anchor), conjugate(body.rotation) * in_world};
}

physics::JointKind joint_kind(const SceneJoint& joint) {
    const physics::JointLimit limit{true, joint.lower, joint.upper};
    if (joint.kind == SceneJointKind::hinge) return physics::HingeJoint{.limit = limit};
    if (joint.kind == SceneJointKind::cone_twist)
        return physics::ConeTwistJoint{.swing = joint.swing, .twist = limit};
    return physics::BallJoint{};
}

class JostleEngine final : public Engine {
public:
    physics::Status init(const SceneDescription& scene, int threads, bool sleep) override {
        auto world =
            physics::World::create({.gravity = gravity, .threads = threads, .sleeping = sleep});
        if (!world) return world.error();
        world_ = std::move(*world);
        for (const SceneBody& body : scene.bodies) {
            const auto id = add_body(*world_, body);
            if (!id) return id.error();
            ids_.push_back(*id);
        }
        for (const SceneJoint& joint : scene.joints) {
            const auto id =
                world_->create_joint({.body_a = ids_[joint.a],
                                      .body_b = ids_[joint.b],
                                      .frame_a = joint_frame(joint, scene.bodies[joint.a].pose),
                                      .frame_b = joint_frame(joint, scene.bodies[joint.b].pose),
                                      .kind = joint_kind(joint)});
            if (!id) return id.error();
        }
        return {};
    }

    void step() override {
        // Only a step length out of range is refused.
        static_cast<void>(world_->step(step_seconds));
    }

    Transform pose(std::uint32_t body) const override { return world_->body(ids_[body])->pose; }

    Vec3 velocity(std::uint32_t body) const override {
        return world_->body(ids_[body])->linear_velocity;
    }

    void set_velocity(std::uint32_t body, Vec3 linear) override {
        const auto state = world_->body(ids_[body]);
        static_cast<void>(world_->set_velocity(ids_[body], linear, state->angular_velocity));
    }

    int awake() const override {
        const auto all = static_cast<int>(ids_.size());  // not stepped yet: nobody knows
        return world_->step_count() == 0 ? all : world_->profile().bodies_awake;
    }

private:
    std::optional<physics::World> world_;
    std::vector<BodyId> ids_;
};

}  // namespace

physics::Result<BodyId> add_body(physics::World& world, const SceneBody& body) {
    physics::ShapeDef shape{.material = {.friction = pair_friction}, .density = density};
    std::visit([&](const auto& form) { shape.geometry = form; }, body.form);
    if (!body.collides) shape.filter.mask = 0;
    return world.create_body(
        {.type = body.fixed ? physics::BodyType::fixed : physics::BodyType::dynamic,
         .pose = body.pose,
         .linear_velocity = body.velocity,
         .linear_damping = damping,
         .angular_damping = damping},
        shape);
}

std::unique_ptr<Engine> make_jostle_engine() {
    return std::make_unique<JostleEngine>();
}

}  // namespace jostle::bench
