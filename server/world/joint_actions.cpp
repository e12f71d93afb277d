// SPDX-License-Identifier: MIT
#include "server/world/joint_actions.h"

#include <algorithm>
#include <string>
#include <utility>
#include <variant>

#include "jostle/base/check.h"
#include "server/world/body_record.h"

namespace jostle::server {

using namespace physics;

namespace {

Status check_joint_limits(const ActionContext& context, const JointDef& def) {
    HostedState& state = context.state;
    state.joint_owners.remove_ended(state.world);
    if (state.joint_owners.count(state.world, context.client) >= state.limits.joints_owned_max)
        return too_many_joints(state, context.client);
    const BodyId known = is_null(def.body_a) ? def.body_b : def.body_a;
    int of_pair = 0;
    for (const JointId id : state.world.joints_of(known)) {
        const JointDef other = state.world.joint(id)->def;
        if (std::minmax(other.body_a, other.body_b) == std::minmax(def.body_a, def.body_b))
            of_pair++;
    }
    if (of_pair >= state.limits.scene.joints_per_pair_max)
        return refused(ErrorCode::resource_exhausted,
                       std::to_string(of_pair) +
                           " joints connect the two bodies; scene.joints_per_pair_max allows " +
                           std::to_string(state.limits.scene.joints_per_pair_max));
    return {};
}

// Sets the bodies of a joint, and its frames if the command has one in the world.
Status place_joint(const HostedState& state, const CreateJointCommand& c, JointDef& def) {
    const auto local = [](const Transform& pose, const Transform& world) {
        return Transform{inverse_rotate(pose.rotation, world.position - pose.position),
                         conjugate(pose.rotation) * world.rotation};
    };
    if (c.frame) def.frame_a = *c.frame;
    if (c.entity_a != 0) {
        const Entity* const a = state.entities.find(c.entity_a);
        if (!a) return no_such_entity(c.entity_a);
        def.body_a = a->body;
        if (c.frame) def.frame_a = local(state.world.body(a->body)->pose, *c.frame);
    }
    const Entity* const b = state.entities.find(c.entity_b);
    if (!b) return no_such_entity(c.entity_b);
    def.body_b = b->body;
    if (c.frame) def.frame_b = local(state.world.body(b->body)->pose, *c.frame);
    return {};
}

}  // namespace

Status create_joint(const ActionContext& context, const CreateJointCommand& c) {
    HostedState& state = context.state;
    context.affected.entity = c.entity_b;
    if (c.entity_a == c.entity_b)
        return refused(ErrorCode::invalid_argument,
                       "create_joint.entity_a and entity_b are equal; a joint connects two "
                       "bodies, or a body and the world");
    JointDef def = c.joint;
    if (Status s = place_joint(state, c, def); !s.ok()) return s;
    if (Status s = check_joint_limits(context, def); !s.ok()) return s;
    const Result<JointId> joint = state.world.create_joint(def);
    if (!joint.ok())
        return joint.error().code == ErrorCode::failed_precondition
                   ? refused(ErrorCode::permission_denied, joint.error().message)
                   : from_solver(joint.error());
    context.affected.joint = *joint;
    if (context.client != scene_client) state.joint_owners.add(*joint, context.client);
    context.record({.kind = UndoStep::Kind::joint_created, .joint = *joint});
    return {};
}

Status delete_joint(const ActionContext& context, const DeleteJointCommand& c) {
    HostedState& state = context.state;
    const Result<JointState> joint = state.world.joint(c.target);
    if (!joint.ok() || std::holds_alternative<GrabJoint>(joint->def.kind))
        return refused(ErrorCode::not_found,
                       "joint " + std::to_string(c.joint) + " does not exist");
    context.affected.joint = c.target;
    if (context.client != scene_client && context.reachable == Reachable::own &&
        state.joint_owners.owner_of(c.target) != context.client)
        return refused(ErrorCode::permission_denied,
                       "the joint is not owned by this client; only its owner can delete it");
    UndoStep step{.kind = UndoStep::Kind::joint_deleted, .joint = c.target};
    const bool can_return = record_joint_of(state, joint->def, c.target, step);
    const bool destroyed = state.world.destroy_joint(c.target).ok();
    ASSERT(destroyed);
    static_cast<void>(destroyed);
    state.joint_owners.remove(c.target);
    if (can_return) context.record(std::move(step));
    return {};
}

Error too_many_joints(const HostedState& state, ClientId client) {
    return refused(ErrorCode::resource_exhausted,
                   "the client owns " +
                       std::to_string(state.joint_owners.count(state.world, client)) +
                       " joints; client.joints_owned_max allows " +
                       std::to_string(state.limits.joints_owned_max) + "; delete a joint first");
}

bool record_joint_of(const HostedState& state, const JointDef& def, JointId id, UndoStep& to) {
    UndoStep::Joint joint{
        .entity_a = is_null(def.body_a) ? 0 : state.entities.find_living(def.body_a),
        .entity_b = state.entities.find_living(def.body_b),
        .owner = state.joint_owners.owner_of(id),
        .record = record_joint(def)};
    if (joint.record.empty() || joint.entity_b == 0 ||
        (joint.entity_a == 0 && !is_null(def.body_a)))
        return false;
    to.joints.push_back(std::move(joint));
    return true;
}

}  // namespace jostle::server
