// SPDX-License-Identifier: MIT
#include "server/world/apply_action.h"

#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "jostle/base/check.h"
#include "jostle/modules/blast.h"
#include "jostle/modules/crowd.h"
#include "jostle/modules/deformables.h"
#include "jostle/modules/destruction.h"
#include "jostle/modules/player_interaction.h"
#include "server/world/action_context.h"
#include "server/world/clone_action.h"
#include "server/world/edit_action.h"
#include "server/world/joint_actions.h"
#include "server/world/undo_action.h"

namespace jostle::server {

using namespace physics;

namespace {

// Impulse per area and blast speed (N s/m^2 per m/s): a crate of 1 m and 1000 kg/m^3 reaches about
// the blast speed.
constexpr double blast_strength = 1000;
// Breaking distance per blast radius and blast speed (m per m and m/s). Breakable walls within it
// break.
constexpr double blast_break_scale = 1.0 / 60;
// Distance per blast radius within which a blast frightens the agents of a crowd.
constexpr double blast_alarm_scale = 3;

// One overload per kind of action; a kind without one does not compile.
struct Apply : ActionContext {
    Status operator()(const SpawnCommand& c) const {
        if (Status s = check_body_limits(1, c.pose, {&c.shape, 1}); !s.ok()) return s;
        const Result<BodyId> body =
            state.world.create_body(BodyDef{.pose = c.pose,
                                            .linear_velocity = c.linear_velocity,
                                            .angular_velocity = c.angular_velocity},
                                    c.shape);
        if (!body.ok()) return from_solver(body.error());
        affected.entity = state.entities.add(state.world, *body, client, c.color, {});
        ASSERT(affected.entity != 0);
        own(affected.entity);
        record({.kind = UndoStep::Kind::spawned, .entities = {affected.entity}});
        return {};
    }

    Status operator()(const ImpulseCommand& c) const {
        if (c.deformable)
            return on_deformable(*c.deformable, [&](modules::Deformables& of, auto at) {
                return of.push(state.world, at, c.impulse);
            });
        affected.entity = c.entity;
        const Result<const Entity*> entity = dynamic_entity(c.entity);
        if (!entity.ok()) return entity.error();
        return from_solver(modules::apply_player_impulse(
            state.world, *state.world.body((*entity)->body), c.impulse, c.point));
    }

    Status operator()(const GrabCommand& c) const {
        if (c.deformable)
            return on_deformable(*c.deformable, [&](modules::Deformables& of, auto at) {
                return state.grabs.grab_deformable(state.world, client, of, at);
            });
        affected.entity = c.entity;
        const Result<const Entity*> entity = dynamic_entity(c.entity);
        if (!entity.ok()) return entity.error();
        return from_solver(
            state.grabs.grab(state.world, client, *state.world.body((*entity)->body), c.point));
    }

    Status operator()(const DragCommand& c) const {
        if (const auto body = state.grabs.drag(state.world, client, c.target))
            affected.entity = state.entities.entity_of(*body);
        else if (!state.grabs.drag_deformable(state.world, client, c.target))
            return refused(ErrorCode::not_found,
                           "the client has grabbed nothing; send a grab input first");
        return {};
    }

    Status operator()(const ReleaseCommand&) const {
        state.grabs.release(state.world, client);
        return {};
    }

    Status operator()(const DeleteCommand& c) const {
        affected.entity = c.entity;
        if (!state.entities.find(c.entity)) return no_such_entity(c.entity);
        if (client != scene_client && reachable == Reachable::own &&
            !state.ownership.owns(client, c.entity))
            return refused(ErrorCode::permission_denied,
                           "entity " + std::to_string(c.entity) +
                               " is not owned by this client; only its owner can delete it");
        if (client != scene_client) record_deletion(*this, c.entity);
        remove(c.entity);
        return {};
    }

    Status operator()(const EditCommand& c) const { return edit_body(*this, c); }
    Status operator()(const CloneCommand& c) const { return clone_bodies(*this, c); }
    Status operator()(const CreateJointCommand& c) const { return create_joint(*this, c); }
    Status operator()(const DeleteJointCommand& c) const { return delete_joint(*this, c); }
    Status operator()(const UndoCommand&) const { return undo_newest(*this); }

    // Walls shield bodies from the blast. The centre of a click lies on a surface, so the blast has
    // a standoff.
    Status operator()(const ExplodeCommand& c) const {
        const modules::Explosion explosion{.center = c.center,
                                           .radius = c.radius,
                                           .strength = blast_strength * c.speed,
                                           .falloff = 0,
                                           .standoff = 0.3,
                                           .points = 32,
                                           .max_speed = 2 * c.speed};
        const auto pushes = modules::compute_blast(state.world, explosion);
        if (!pushes.ok()) return from_solver(pushes.error());
        if (const Status s = modules::push_deformables(state.world, explosion); !s.ok())
            return from_solver(s);
        if (auto* walls = dynamic_cast<modules::Destruction*>(state.world.module("destruction")))
            walls->break_near(state.world, c.center, blast_break_scale * c.radius * c.speed);
        if (auto* crowd = dynamic_cast<modules::Crowd*>(state.world.module("crowd")))
            static_cast<void>(crowd->alarm(c.center, blast_alarm_scale * c.radius));
        Status status;
        for (const modules::BlastImpulse& p : *pushes) {
            const Status pushed = modules::apply_limited_impulse(
                state.world, *state.world.body(p.body), p.impulse, p.center, p.angular_impulse);
            if (!pushed.ok()) status = from_solver(pushed);
        }
        return status;
    }

    Status operator()(const CutCommand& c) const {
        if (!c.deformable)
            return refused(ErrorCode::invalid_argument,
                           "the cut has no target; set its object or its aim");
        return on_deformable(*c.deformable, [&](modules::Deformables& of, auto at) {
            return of.cut_at(state.world, at.object, c.point);
        });
    }

    Status operator()(const PossessCommand& c) const {
        affected.entity = c.entity;
        if (c.entity == 0) {
            state.controllers.release(state.world, client);
            return {};
        }
        const Entity* entity = state.entities.find(c.entity);
        if (!entity) return no_such_entity(c.entity);
        return state.controllers.possess(state.world, client, entity->body);
    }

    Status operator()(const ControlCommand& c) const {
        const std::optional<BodyId> body =
            state.controllers.control(state.world, client, c.controls);
        if (!body)
            return refused(ErrorCode::not_found,
                           "the client controls no entity; send a possess input first");
        affected.entity = state.entities.entity_of(*body);
        return {};
    }

    Status operator()(const LeaveCommand& c) const {
        if (!c.retain_bodies)
            for (const EntityId id : state.ownership.owned_by(client)) remove(id);
        state.ownership.forget(client);
        state.joint_owners.remove_ended(state.world);
        state.joint_owners.forget(client);
        state.undo.forget(client);
        state.grabs.release(state.world, client);
        state.controllers.release(state.world, client);
        if (state.players.leave(client))
            state.attributes.remove({AttributeTargetKind::player, client});
        return {};
    }

    Status operator()(const JoinCommand& c) const {
        state.players.join({.client = client,
                            .name = c.name,
                            .role = c.role,
                            .color = c.color,
                            .joined_tick = c.tick});
        return {};
    }

    Status operator()(const RenameCommand& c) const { return state.players.rename(client, c.name); }

    Status operator()(const SetRoleCommand& c) const {
        if (client != scene_client && state.players.role_of(client) != PlayerRole::owner)
            return refused(ErrorCode::permission_denied,
                           "only the server and players with the role owner change roles");
        return state.players.set_role(c.player, c.role);
    }

    Status operator()(const SetAttributesCommand& c) const {
        const Result<ClientId> owner = owner_of(c.target);
        if (!owner.ok()) return owner.error();
        if (c.target.kind == AttributeTargetKind::entity) affected.entity = c.target.id;
        if (!may_set_attributes(c.target))
            return refused(ErrorCode::permission_denied,
                           "a client with the role " +
                               std::string(name_of(state.players.role_of(client))) +
                               " cannot set attributes of " + describe(c.target));
        return state.attributes.set(c.target, *owner, client, c.changes, state.limits.attributes);
    }

    Status operator()(const SendMessageCommand& c) const {
        for (const ClientId to : c.to)
            if (!state.players.find(to))
                return refused(ErrorCode::not_found,
                               "player " + std::to_string(to) + " does not exist");
        state.messages.add({.from = client,
                            .topic = c.topic,
                            .data = c.data,
                            .to = c.to,
                            .to_server = c.to_server});
        return {};
    }

    Status operator()(const DisconnectCommand&) const {
        state.players.disconnect(client);
        state.grabs.release(state.world, client);
        static_cast<void>(state.controllers.control(state.world, client, {}));
        return {};
    }

    // The rules of a room apply them (room.h).
    Status operator()(const RoomCommand&) const {
        return refused(ErrorCode::permission_denied,
                       "the world has no room; create it with room settings");
    }

private:
    template <class Use>
    Status on_deformable(const DeformableTarget& target, const Use& use) const {
        modules::Deformables* deformables = modules::deformables_of(state.world, target.module);
        if (deformables == nullptr)
            return refused(ErrorCode::not_found,
                           "the world has no deformable objects of the module " + target.module);
        return use(*deformables, modules::DeformablePoint{target.object, target.element});
    }

    // The client that owns the target; 0: no client.
    Result<ClientId> owner_of(const AttributeTarget& target) const {
        if (target.kind == AttributeTargetKind::world) return scene_client;
        if (target.kind == AttributeTargetKind::player) {
            if (!state.players.find(target.id))
                return refused(ErrorCode::not_found, describe(target) + " does not exist");
            return target.id;
        }
        const Entity* const entity = state.entities.find(target.id);
        if (!entity) return no_such_entity(target.id);
        return entity->description->owner;
    }

    bool may_set_attributes(const AttributeTarget& target) const {
        if (client == scene_client) return true;
        const PlayerRole role = state.players.role_of(client);
        if (role == PlayerRole::owner) return true;
        if (target.kind == AttributeTargetKind::player) return target.id == client;
        if (target.kind == AttributeTargetKind::world) return false;
        return role == PlayerRole::builder || state.ownership.owns(client, target.id);
    }

    // --- edits and joints ---

    // --- undo ---

    Result<const Entity*> dynamic_entity(EntityId id) const {
        const Entity* entity = state.entities.find(id);
        if (!entity) return no_such_entity(id);
        ASSERT(entity->description);
        if (entity->description->type != BodyType::dynamic)
            return refused(ErrorCode::permission_denied,
                           "entity " + std::to_string(id) +
                               " is not dynamic; only dynamic entities can be pushed or grabbed");
        return entity;
    }
};

}  // namespace

Status apply_action(HostedState& state, ClientId client, const Action& action, Affected& affected,
                    Reachable reachable) {
    return std::visit(Apply{{state, client, affected, reachable}}, action);
}

}  // namespace jostle::server
