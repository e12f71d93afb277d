// SPDX-License-Identifier: MIT
#include "server/world/apply_action.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "jostle/base/check.h"
#include "jostle/modules/blast.h"
#include "jostle/modules/crowd.h"
#include "jostle/modules/deformables.h"
#include "jostle/modules/destruction.h"
#include "jostle/modules/player_interaction.h"
#include "server/world/body_record.h"

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
// Limit of shapes that overlap a spawned body. The number of pairs grows with the square of the
// bodies in one place.
constexpr std::size_t spawn_overlaps_max = 40;
// Joints that the undo of a deletion creates again.
constexpr std::size_t undone_joints_max = 64;

Error refused(ErrorCode code, std::string message) {
    return {code, std::move(message)};
}

Error no_such_entity(EntityId id) {
    return refused(ErrorCode::not_found, "entity " + std::to_string(id) + " does not exist");
}

// The solver rejects only invalid numbers.
Status from_solver(const Status& status) {
    return status.ok() ? status : refused(ErrorCode::invalid_argument, status.error().message);
}

// One overload per kind of action; a kind without one does not compile.
struct Apply {
    HostedState& state;
    ClientId client;
    Affected& affected;
    Reachable reachable = Reachable::own;

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
        state.ownership.add(client, affected.entity);
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
        if (client != scene_client) record_deletion(c.entity);
        remove(c.entity);
        return {};
    }

    Status operator()(const EditCommand& c) const {
        affected.entity = c.entity;
        const Result<const Entity*> entity = editable_entity(c.entity);
        if (!entity.ok()) return entity.error();
        const EntityDescription before = *(*entity)->description;
        const BodyId body = (*entity)->body;
        const BodyAndShapes from = definition_of(state.world, body);
        BodyAndShapes to = from;
        EditFields fields = 0;
        if (c.position) to.body.pose.position = *c.position, fields |= edit_position;
        if (c.rotation) to.body.pose.rotation = *c.rotation, fields |= edit_rotation;
        if (c.linear_velocity)
            to.body.linear_velocity = *c.linear_velocity, fields |= edit_linear_velocity;
        if (c.angular_velocity)
            to.body.angular_velocity = *c.angular_velocity, fields |= edit_angular_velocity;
        if (c.density) {
            for (ShapeDef& shape : to.shapes) shape.density = *c.density, shape.mass = 0;
            to.body.mass = 0;
            fields |= edit_density;
        }
        if (c.mass) to.body.mass = *c.mass, fields |= edit_mass;
        for (ShapeDef& shape : to.shapes) {
            if (c.friction) shape.material.friction = *c.friction, fields |= edit_friction;
            if (c.restitution)
                shape.material.restitution = *c.restitution, fields |= edit_restitution;
        }
        if (c.gravity_scale) to.body.gravity_scale = *c.gravity_scale, fields |= edit_gravity_scale;
        if (c.color) fields |= edit_color;
        if (c.frozen) fields |= edit_frozen;
        if (fields == 0) return refused(ErrorCode::invalid_argument, "the edit changes nothing");
        const bool frozen = c.frozen.value_or(before.frozen);
        constexpr EditFields of_moving_bodies =
            edit_linear_velocity | edit_angular_velocity | edit_mass | edit_density;
        if (frozen && (fields & of_moving_bodies) != 0)
            return refused(ErrorCode::permission_denied,
                           "entity " + std::to_string(c.entity) +
                               " is frozen; only velocity, mass and density of entities that are "
                               "not frozen can be edited");
        const std::string bytes = record_body(state.world, body);
        if (Status s = write_fields(body, to, fields, frozen); !s.ok()) {
            static_cast<void>(write_fields(body, from, fields, before.frozen));
            return s;
        }
        state.entities.update(state.world, c.entity, c.color ? c.color : before.color, frozen);
        // A body that freezes stops.
        if (frozen && !before.frozen) fields |= edit_linear_velocity | edit_angular_velocity;
        if (!bytes.empty())
            record({.kind = UndoStep::Kind::edited,
                    .entities = {c.entity},
                    .fields = fields,
                    .record = bytes,
                    .color = before.color,
                    .frozen = before.frozen});
        return {};
    }

    Status operator()(const CloneCommand& c) const {
        affected.entity = c.entity;
        const Result<const Entity*> entity = editable_entity(c.entity, Reachable::any);
        if (!entity.ok()) return entity.error();
        const JointedGroup group = jointed_group(state, c.entity, c.jointed);
        if (group.entities.size() > clone_bodies_max)
            return refused(ErrorCode::resource_exhausted,
                           "joints connect more than " + std::to_string(clone_bodies_max) +
                               " bodies to entity " + std::to_string(c.entity) +
                               "; clone fewer bodies");
        const int joints_owned = state.joint_owners.count(state.world, client);
        if (joints_owned + static_cast<int>(group.joints.size()) > state.limits.joints_owned_max)
            return too_many_joints();
        std::vector<BodyAndShapes> bodies;
        for (const EntityId id : group.entities) {
            BodyAndShapes def = definition_of(state.world, state.entities.find(id)->body);
            def.body.pose.position += c.offset;
            def.body.user_data = 0;
            if (Status s = check_body_limits(static_cast<int>(group.entities.size()), def.body.pose,
                                             def.shapes);
                !s.ok())
                return s;
            bodies.push_back(std::move(def));
        }
        const Result<std::vector<BodyId>> copies = state.world.create_bodies(bodies);
        if (!copies.ok()) return from_solver(copies.error());
        std::map<BodyId, BodyId> copy_of;
        UndoStep step{.kind = UndoStep::Kind::spawned};
        for (std::size_t i = 0; i < copies->size(); i++) {
            const Entity& original = *state.entities.find(group.entities[i]);
            copy_of[original.body] = (*copies)[i];
            const EntityDescription description = *original.description;
            const EntityId id =
                state.entities.add(state.world, (*copies)[i], client, description.color, {});
            if (description.frozen) state.entities.update(state.world, id, description.color, true);
            state.ownership.add(client, id);
            step.entities.push_back(id);
        }
        affected.entity = step.entities.front();
        for (const JointId joint : group.joints) {
            JointDef def = state.world.joint(joint)->def;
            def.body_a = copy_of.at(def.body_a);
            def.body_b = copy_of.at(def.body_b);
            def.user_data = 0;
            // Both bodies are valid, and the original has the same kind.
            if (const auto copy = state.world.create_joint(def); copy.ok())
                state.joint_owners.add(*copy, client);
        }
        record(std::move(step));
        return {};
    }

    Status operator()(const CreateJointCommand& c) const {
        affected.entity = c.entity_b;
        if (c.entity_a == c.entity_b)
            return refused(ErrorCode::invalid_argument,
                           "create_joint.entity_a and entity_b are equal; a joint connects two "
                           "bodies, or a body and the world");
        JointDef def = c.joint;
        if (Status s = place_joint(c, def); !s.ok()) return s;
        if (Status s = check_joint_limits(def); !s.ok()) return s;
        const Result<JointId> joint = state.world.create_joint(def);
        if (!joint.ok())
            return joint.error().code == ErrorCode::failed_precondition
                       ? refused(ErrorCode::permission_denied, joint.error().message)
                       : from_solver(joint.error());
        affected.joint = *joint;
        if (client != scene_client) state.joint_owners.add(*joint, client);
        record({.kind = UndoStep::Kind::joint_created, .joint = *joint});
        return {};
    }

    Status operator()(const DeleteJointCommand& c) const {
        const Result<JointState> joint = state.world.joint(c.target);
        if (!joint.ok() || std::holds_alternative<GrabJoint>(joint->def.kind))
            return refused(ErrorCode::not_found,
                           "joint " + std::to_string(c.joint) + " does not exist");
        affected.joint = c.target;
        if (client != scene_client && reachable == Reachable::own &&
            state.joint_owners.owner_of(c.target) != client)
            return refused(ErrorCode::permission_denied,
                           "the joint is not owned by this client; only its owner can delete it");
        UndoStep step{.kind = UndoStep::Kind::joint_deleted, .joint = c.target};
        const bool can_return = record_joint_of(joint->def, c.target, step);
        const bool destroyed = state.world.destroy_joint(c.target).ok();
        ASSERT(destroyed);
        static_cast<void>(destroyed);
        state.joint_owners.remove(c.target);
        if (can_return) record(std::move(step));
        return {};
    }

    Status operator()(const UndoCommand&) const {
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

    bool has_too_many_overlaps(const Transform& pose, const ShapeDef& shape) const {
        const auto shapes =
            state.world.queries().overlap_shape(shape.geometry, compose(pose, shape.pose));
        return shapes.ok() && shapes->size() > spawn_overlaps_max;
    }

    // Whether `count` new bodies, of which one has this pose and these shapes, keep the limits.
    Status check_body_limits(int count, const Transform& pose,
                             std::span<const ShapeDef> shapes) const {
        if (static_cast<int>(state.entities.size()) + count > state.limits.scene.bodies_max)
            return refused(ErrorCode::resource_exhausted,
                           "the world has " + std::to_string(state.entities.size()) +
                               " bodies; world.bodies_max allows " +
                               std::to_string(state.limits.scene.bodies_max));
        for (const ShapeDef& shape : shapes)
            if (has_too_many_overlaps(pose, shape))
                return refused(ErrorCode::resource_exhausted,
                               "more than " + std::to_string(spawn_overlaps_max) +
                                   " shapes overlap the spawned body; spawn it elsewhere");
        if (state.ownership.count(client) + count > state.limits.bodies_owned_max)
            return refused(ErrorCode::resource_exhausted,
                           "the client owns " + std::to_string(state.ownership.count(client)) +
                               " bodies; client.bodies_owned_max allows " +
                               std::to_string(state.limits.bodies_owned_max) +
                               "; delete a body first");
        return {};
    }

    // --- edits and joints ---

    void record(UndoStep step) const {
        if (client != scene_client) state.undo.add(client, std::move(step));
    }

    // A dynamic or frozen body that the client may change.
    Result<const Entity*> editable_entity(EntityId id, std::optional<Reachable> by = {}) const {
        const Entity* const entity = state.entities.find(id);
        if (!entity) return no_such_entity(id);
        if (entity->description->type != BodyType::dynamic && !entity->description->frozen)
            return refused(ErrorCode::permission_denied,
                           "entity " + std::to_string(id) +
                               " is not dynamic; only dynamic and frozen entities can be edited "
                               "or cloned");
        if (client != scene_client && by.value_or(reachable) == Reachable::own &&
            !state.ownership.owns(client, id))
            return refused(ErrorCode::permission_denied,
                           "entity " + std::to_string(id) +
                               " is not owned by this client; only its owner can edit it");
        return entity;
    }

    // Sets these fields of a body to those of a definition.
    Status write_fields(BodyId body, const BodyAndShapes& to, EditFields fields,
                        bool frozen) const {
        World& world = state.world;
        const auto refusal = [](const Status& s) {
            return s.error().code == ErrorCode::failed_precondition
                       ? refused(ErrorCode::permission_denied, s.error().message)
                       : from_solver(s).error();
        };
        if ((fields & edit_frozen) != 0 && !frozen)
            if (Status s = world.set_type(body, BodyType::dynamic); !s.ok()) return refusal(s);
        if ((fields & (edit_position | edit_rotation)) != 0) {
            Transform pose = world.body(body)->pose;
            if ((fields & edit_position) != 0) pose.position = to.body.pose.position;
            if ((fields & edit_rotation) != 0) pose.rotation = to.body.pose.rotation;
            if (Status s = world.set_pose(body, pose); !s.ok()) return refusal(s);
        }
        if ((fields & edit_density) != 0) {
            if (const auto shapes = world.set_shapes(body, to.shapes); !shapes.ok())
                return refusal(shapes.error());
        } else if ((fields & (edit_friction | edit_restitution)) != 0) {
            const std::vector<ShapeId> shapes = world.shapes_of(body);
            for (std::size_t i = 0; i < shapes.size() && i < to.shapes.size(); i++) {
                Material material = world.shape(shapes[i])->material;
                if ((fields & edit_friction) != 0)
                    material.friction = to.shapes[i].material.friction;
                if ((fields & edit_restitution) != 0)
                    material.restitution = to.shapes[i].material.restitution;
                if (Status s = world.set_material(shapes[i], material); !s.ok()) return refusal(s);
            }
        }
        if ((fields & (edit_mass | edit_density)) != 0)
            if (Status s = world.set_mass(body, to.body.mass); !s.ok()) return refusal(s);
        if ((fields & edit_gravity_scale) != 0)
            if (Status s = world.set_gravity_scale(body, to.body.gravity_scale); !s.ok())
                return refusal(s);
        if ((fields & edit_linear_velocity) != 0)
            if (Status s = world.set_linear_velocity(body, to.body.linear_velocity); !s.ok())
                return refusal(s);
        if ((fields & edit_angular_velocity) != 0)
            if (Status s = world.set_angular_velocity(body, to.body.angular_velocity); !s.ok())
                return refusal(s);
        if ((fields & edit_frozen) != 0 && frozen) {
            state.grabs.release_body(world, body);
            if (Status s = world.set_type(body, BodyType::static_body); !s.ok()) return refusal(s);
        }
        return {};
    }

    Error too_many_joints() const {
        return refused(
            ErrorCode::resource_exhausted,
            "the client owns " + std::to_string(state.joint_owners.count(state.world, client)) +
                " joints; client.joints_owned_max allows " +
                std::to_string(state.limits.joints_owned_max) + "; delete a joint first");
    }

    Status check_joint_limits(const JointDef& def) const {
        state.joint_owners.remove_ended(state.world);
        if (state.joint_owners.count(state.world, client) >= state.limits.joints_owned_max)
            return too_many_joints();
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
    Status place_joint(const CreateJointCommand& c, JointDef& def) const {
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

    // False: the joint cannot be recorded.
    bool record_joint_of(const JointDef& def, JointId id, UndoStep& to) const {
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

    void record_deletion(EntityId id) const {
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
                static_cast<void>(record_joint_of(def, joint, step));
        }
        record(std::move(step));
    }

    // --- undo ---

    static Error gone(EntityId id) {
        return refused(ErrorCode::not_found,
                       "entity " + std::to_string(id) + " of the undone action no longer exists");
    }

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
        if (Status s = write_fields(body, *def, fields, frozen); !s.ok()) {
            static_cast<void>(write_fields(body, before, fields, entity->description->frozen));
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

    void remove(EntityId id) const {
        const BodyId body = state.entities.find(id)->body;
        forget_entity(state, id);
        // The registry and the world agree, so the body exists.
        const bool destroyed = state.world.destroy_body(body).ok();
        ASSERT(destroyed);
        static_cast<void>(destroyed);
    }

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

JointedGroup jointed_group(const HostedState& state, EntityId entity, bool all) {
    JointedGroup group{.entities = {entity}};
    const World& world = state.world;
    const Entity* const first = state.entities.find(entity);
    if (!first) return group;
    std::set<BodyId> bodies{first->body};
    std::set<JointId> joints;
    for (std::size_t i = 0; all && i < group.entities.size(); i++)
        for (const JointId id : world.joints_of(state.entities.find(group.entities[i])->body)) {
            const JointDef def = world.joint(id)->def;
            for (const BodyId body : {def.body_a, def.body_b}) {
                const EntityId other = is_null(body) ? 0 : state.entities.find_living(body);
                const Entity* const found = state.entities.find(other);
                if (!found || bodies.contains(body) ||
                    (found->description->type != BodyType::dynamic && !found->description->frozen))
                    continue;
                if (group.entities.size() > clone_bodies_max) return group;
                bodies.insert(body);
                group.entities.push_back(other);
            }
            if (!std::holds_alternative<GrabJoint>(def.kind)) joints.insert(id);
        }
    for (const JointId id : joints) {
        const JointDef def = world.joint(id)->def;
        if (bodies.contains(def.body_a) && bodies.contains(def.body_b)) group.joints.push_back(id);
    }
    std::sort(group.entities.begin() + 1, group.entities.end());
    return group;
}

void forget_entity(HostedState& state, EntityId id) {
    const BodyId body = state.entities.find(id)->body;
    state.grabs.release_body(state.world, body);
    state.controllers.release_body(state.world, body);
    state.ownership.remove(id);
    state.attributes.remove({AttributeTargetKind::entity, id});
    state.entities.remove(id);
}

Status apply_action(HostedState& state, ClientId client, const Action& action, Affected& affected,
                    Reachable reachable) {
    return std::visit(Apply{state, client, affected, reachable}, action);
}

}  // namespace jostle::server
