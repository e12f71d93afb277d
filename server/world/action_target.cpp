// SPDX-License-Identifier: MIT
#include "server/world/action_target.h"

#include <algorithm>
#include <variant>

#include "server/world/clone_action.h"

namespace jostle::server {

using namespace physics;

namespace {

// Actions change the speed of a body by at most this (modules/player_interaction).
constexpr double speed_change_max = 20;  // m/s
constexpr double explosion_mass = 1000;  // kg, of the crate that ExplodeInput.speed refers to

ActionTarget on_entity(const HostedState& world, ClientId client, RoomAction action, EntityId id) {
    const Entity* const entity = world.entities.find(id);
    if (!entity) return {action};  // apply_action() refuses it
    const ClientId owner = entity->description->owner;
    const Result<BodyState> body = world.world.body(entity->body);
    return {.action = action,
            .owner = owner == client         ? TargetOwner::self
                     : owner == scene_client ? TargetOwner::scene
                                             : TargetOwner::other,
            .point = body.ok() ? std::optional(body->pose.position) : std::nullopt};
}

// Two bodies: the rights of the one to which fewer roles have access.
ActionTarget on_pair(const HostedState& world, ClientId client, EntityId a, EntityId b) {
    ActionTarget target = on_entity(world, client, RoomAction::joints, b);
    if (a == 0) return target;
    const ActionTarget other = on_entity(world, client, RoomAction::joints, a);
    target.owner = std::max(target.owner, other.owner);
    target.second_point = other.point;
    return target;
}

ActionTarget on_joint(const HostedState& world, ClientId client, JointId id) {
    ActionTarget target{.action = RoomAction::joints};
    const Result<JointState> joint = world.world.joint(id);
    if (!joint.ok()) return target;  // apply_action() refuses it
    // A joint without an owner belongs to the scene.
    const ClientId owner = world.joint_owners.owner_of(id);
    target.owner = owner == client         ? TargetOwner::self
                   : owner == scene_client ? TargetOwner::scene
                                           : TargetOwner::other;
    const auto position = [&](BodyId body) -> std::optional<Vec3> {
        const Result<BodyState> state = world.world.body(body);
        return state.ok() ? std::optional(state->pose.position) : std::nullopt;
    };
    target.point = position(joint->def.body_b);
    target.second_point = position(joint->def.body_a);
    return target;
}

// An undo requires the permission for the action that reverts the other one.
std::optional<ActionTarget> on_undo(const HostedState& world, ClientId client) {
    const UndoStep* const step = world.undo.newest(client);
    if (!step) return std::nullopt;
    switch (step->kind) {
        case UndoStep::Kind::spawned:
            return on_entity(world, client, RoomAction::remove, step->entities.front());
        case UndoStep::Kind::deleted:
            return ActionTarget{.action = RoomAction::spawn};
        case UndoStep::Kind::edited:
            return on_entity(world, client, RoomAction::edit, step->entities.front());
        case UndoStep::Kind::joint_created:
            return on_joint(world, client, step->joint);
        case UndoStep::Kind::joint_deleted:
            return on_pair(world, client, step->joints.front().entity_a,
                           step->joints.front().entity_b);
    }
    return std::nullopt;
}

}  // namespace

std::optional<ActionTarget> target_of(const HostedState& world, ClientId client,
                                      const Action& action) {
    if (const auto* edit = std::get_if<EditCommand>(&action)) {
        ActionTarget target = on_entity(world, client, RoomAction::edit, edit->entity);
        target.second_point = edit->position;
        return target;
    }
    if (const auto* clone = std::get_if<CloneCommand>(&action)) {
        ActionTarget target = on_entity(world, client, RoomAction::clone, clone->entity);
        if (target.point) target.point = *target.point + clone->offset;
        return target;
    }
    if (const auto* joint = std::get_if<CreateJointCommand>(&action))
        return on_pair(world, client, joint->entity_a, joint->entity_b);
    if (const auto* joint = std::get_if<DeleteJointCommand>(&action))
        return on_joint(world, client, joint->target);
    if (std::holds_alternative<UndoCommand>(action)) return on_undo(world, client);
    if (const auto* spawn = std::get_if<SpawnCommand>(&action))
        return ActionTarget{.action = RoomAction::spawn, .point = spawn->pose.position};
    if (const auto* push = std::get_if<ImpulseCommand>(&action)) {
        if (push->deformable)
            return ActionTarget{RoomAction::push, TargetOwner::scene, push->point};
        return on_entity(world, client, RoomAction::push, push->entity);
    }
    if (const auto* grab = std::get_if<GrabCommand>(&action)) {
        if (grab->deformable)
            return ActionTarget{RoomAction::drag, TargetOwner::scene, grab->point};
        return on_entity(world, client, RoomAction::drag, grab->entity);
    }
    if (const auto* drag = std::get_if<DragCommand>(&action))
        return ActionTarget{.action = RoomAction::drag, .point = drag->target};
    if (const auto* remove = std::get_if<DeleteCommand>(&action))
        return on_entity(world, client, RoomAction::remove, remove->entity);
    if (const auto* explode = std::get_if<ExplodeCommand>(&action))
        return ActionTarget{
            .action = RoomAction::explode, .point = explode->center, .radius = explode->radius};
    if (const auto* cut = std::get_if<CutCommand>(&action))
        return ActionTarget{RoomAction::joints, TargetOwner::scene, cut->point};
    if (const auto* possess = std::get_if<PossessCommand>(&action); possess && possess->entity != 0)
        return on_entity(world, client, RoomAction::control, possess->entity);
    return std::nullopt;
}

bool needs_energy(const Action& action) {
    const auto* const edit = std::get_if<EditCommand>(&action);
    return (edit && edit->linear_velocity) || std::holds_alternative<SpawnCommand>(action) ||
           std::holds_alternative<ImpulseCommand>(action) ||
           std::holds_alternative<ExplodeCommand>(action);
}

double energy_of(const HostedState& world, const Action& action, EntityId affected) {
    const auto mass_of = [&](EntityId id) {
        const Entity* const entity = world.entities.find(id);
        return entity ? entity->description->mass : 0.0;
    };
    if (const auto* spawn = std::get_if<SpawnCommand>(&action))
        return 0.5 * mass_of(affected) * dot(spawn->linear_velocity, spawn->linear_velocity);
    if (const auto* edit = std::get_if<EditCommand>(&action)) {
        if (!edit->linear_velocity) return 0;
        return 0.5 * mass_of(edit->entity) * dot(*edit->linear_velocity, *edit->linear_velocity);
    }
    if (const auto* push = std::get_if<ImpulseCommand>(&action)) {
        const double impulse = length(push->impulse);
        if (push->deformable) return 0.5 * impulse * speed_change_max;
        const double mass = mass_of(push->entity);
        const double speed = mass > 0 ? std::min(impulse / mass, speed_change_max) : 0;
        return 0.5 * mass * speed * speed;
    }
    if (const auto* explode = std::get_if<ExplodeCommand>(&action))
        return 0.5 * explosion_mass * explode->speed * explode->speed;
    return 0;
}

AddedObjects added_objects(const HostedState& world, ClientId client, const Action& action) {
    if (std::holds_alternative<SpawnCommand>(action)) return {.bodies = 1};
    if (std::holds_alternative<CreateJointCommand>(action)) return {.joints = 1};
    if (const auto* clone = std::get_if<CloneCommand>(&action)) {
        const JointedGroup group = jointed_group(world, clone->entity, clone->jointed);
        return {group.entities.size(), group.joints.size()};
    }
    if (!std::holds_alternative<UndoCommand>(action)) return {};
    const UndoStep* const step = world.undo.newest(client);
    if (!step) return {};
    const auto own =
        static_cast<std::size_t>(std::ranges::count(step->joints, client, &UndoStep::Joint::owner));
    return {.bodies = step->kind == UndoStep::Kind::deleted && step->owner == client ? 1u : 0u,
            .joints = own};
}

}  // namespace jostle::server
