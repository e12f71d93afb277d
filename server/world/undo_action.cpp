// SPDX-License-Identifier: MIT
#include "server/world/undo_action.h"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "server/world/edit_action.h"
#include "server/world/joint_actions.h"

namespace jostle::server {

using namespace physics;

namespace {

// Joints that the undo of a deletion creates again.
constexpr std::size_t undone_joints_max = 64;

Error gone(EntityId id) {
    return refused(ErrorCode::not_found,
                   "entity " + std::to_string(id) + " of the undone action no longer exists");
}

struct Undo : ActionContext {
    Status newest() const {
        if (!state.undo.newest(client))
            return refused(ErrorCode::not_found, "the client has no action to undo");
        const UndoStep step = state.undo.take(client);
        switch (step.kind) {
            case UndoStep::Kind::spawned:
                return undo_spawn(step);
            case UndoStep::Kind::deleted:
                return undo_deletion(step);
            case UndoStep::Kind::edited:
                return undo_edit(step);
            case UndoStep::Kind::joint_created:
                if (!state.world.destroy_joint(step.joint).ok())
                    return refused(ErrorCode::not_found, "the created joint no longer exists");
                affected.joint = step.joint;
                state.joint_owners.remove(step.joint);
                return {};
            case UndoStep::Kind::joint_deleted:
                return create_joint_again(step.joints.front(), step.joint);
        }
        return {};
    }

private:
    Status undo_spawn(const UndoStep& step) const {
        bool found = false;
        for (const EntityId id : step.entities) {
            if (!state.entities.find(id)) continue;
            affected.entity = found ? affected.entity : id;
            found = true;
            remove(id);
        }
        return found ? Status() : gone(step.entities.front());
    }

    Status undo_deletion(const UndoStep& step) const {
        const Result<BodyAndShapes> def = body_of_record(step.record);
        if (!def.ok()) return refused(ErrorCode::not_found, def.error().message);
        if (Status s = check_body_limits(1, def->body.pose, def->shapes); !s.ok()) {
            state.undo.add(client, step);  // it can be undone later
            return s;
        }
        const Result<BodyId> body = state.world.create_body(def->body, def->shapes);
        if (!body.ok()) return from_solver(body.error());
        const EntityId id =
            state.entities.add(state.world, *body, step.owner, step.color, step.name);
        if (step.frozen) state.entities.update(state.world, id, step.color, true);
        if (step.owner != scene_client && is_present(step.owner))
            state.ownership.add(step.owner, id);
        affected.entity = id;
        state.undo.replace(step.entities.front(), id);
        for (UndoStep::Joint joint : step.joints) {
            if (joint.entity_a == step.entities.front()) joint.entity_a = id;
            if (joint.entity_b == step.entities.front()) joint.entity_b = id;
            static_cast<void>(create_joint_again(joint, {}));
        }
        affected.joint = {};
        return {};
    }

    // Clients that left own nothing any more.
    bool is_present(ClientId owner) const {
        return owner == client || state.players.find(owner) || state.ownership.count(owner) > 0;
    }

    Status undo_edit(const UndoStep& step) const {
        const EntityId id = step.entities.front();
        affected.entity = id;
        const Entity* const entity = state.entities.find(id);
        if (!entity) return gone(id);
        const Result<BodyAndShapes> def = body_of_record(step.record);
        if (!def.ok()) return refused(ErrorCode::not_found, def.error().message);
        const BodyId body = entity->body;
        const bool frozen =
            (step.fields & edit_frozen) != 0 ? step.frozen : entity->description->frozen;
        EditFields fields = step.fields;
        if (frozen)
            fields &= ~(edit_linear_velocity | edit_angular_velocity | edit_mass | edit_density);
        const std::optional<std::uint32_t> color =
            (fields & edit_color) != 0 ? step.color : entity->description->color;
        const BodyAndShapes before = definition_of(state.world, body);
        if (Status s = write_fields(state, body, *def, fields, frozen); !s.ok()) {
            static_cast<void>(
                write_fields(state, body, before, fields, entity->description->frozen));
            return s;
        }
        state.entities.update(state.world, id, color, frozen);
        return {};
    }

    // `before`: the id of the joint when it was deleted; null: unknown.
    Status create_joint_again(const UndoStep::Joint& from, JointId before) const {
        Result<JointDef> def = joint_of_record(from.record);
        if (!def.ok()) return refused(ErrorCode::not_found, def.error().message);
        def->body_a = {};
        if (from.entity_a != 0) {
            const Entity* const a = state.entities.find(from.entity_a);
            if (!a) return gone(from.entity_a);
            def->body_a = a->body;
        }
        const Entity* const b = state.entities.find(from.entity_b);
        if (!b) return gone(from.entity_b);
        def->body_b = b->body;
        const Result<JointId> joint = state.world.create_joint(*def);
        if (!joint.ok()) return refused(ErrorCode::permission_denied, joint.error().message);
        if (from.owner != scene_client && is_present(from.owner))
            state.joint_owners.add(*joint, from.owner);
        if (!is_null(before)) state.undo.replace(before, *joint);
        affected.joint = *joint;
        return {};
    }
};

}  // namespace

Status undo_newest(const ActionContext& context) {
    return Undo{context}.newest();
}

void record_deletion(const ActionContext& context, EntityId id) {
    HostedState& state = context.state;
    const Entity& entity = *state.entities.find(id);
    UndoStep step{.kind = UndoStep::Kind::deleted,
                  .entities = {id},
                  .record = record_body(state.world, entity.body),
                  .owner = entity.description->owner,
                  .color = entity.description->color,
                  .name = entity.description->name,
                  .frozen = entity.description->frozen};
    if (step.record.empty()) return;
    for (const JointId joint : state.world.joints_of(entity.body)) {
        if (step.joints.size() == undone_joints_max) break;
        const JointDef def = state.world.joint(joint)->def;
        if (!std::holds_alternative<GrabJoint>(def.kind))
            static_cast<void>(record_joint_of(state, def, joint, step));
    }
    context.record(std::move(step));
}

}  // namespace jostle::server
