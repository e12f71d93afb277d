// SPDX-License-Identifier: MIT
//
// The inputs of clients as plain values. messages/client_message decodes them, limits/admission
// checks them, CommandMailbox queues them, and only world/apply_action turns them into World calls.
// A new kind needs a command here and a case in each of client_message.cpp, admission.cpp and
// apply_action.cpp; the compiler reports a missing one.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "jostle/base/result.h"
#include "jostle/physics/defs.h"
#include "jostle/physics/joint_defs.h"
#include "jostle/physics/module.h"
#include "server/util/clock.h"
#include "server/world/attribute.h"
#include "server/world/player_role.h"
#include "server/world/room_command.h"

namespace jostle::server {

using EntityId = std::uint32_t;  // never reused in a world; 0: none
using ClientId = std::uint32_t;
inline constexpr ClientId scene_client = 0;  // the scene and the host, which may delete any entity
// The player behind one or more clients, for limits: a subject or a network. 0: nobody.
using AccountId = std::uint64_t;

// The rendered time for which a client aimed: between a tick and the next one.
struct ViewTime {
    std::uint32_t tick = 0;
    double fraction = 0;  // 0 to 1

    bool operator==(const ViewTime&) const = default;
};
// A ray whose first hit is the target of an input.
struct Aim {
    physics::Vec3 origin, motion;            // world; m
    EntityId ignore = 0;                     // an entity that the ray passes through; 0: none
    std::optional<ViewTime> view_time = {};  // nothing: the time at which the input is applied
};

// A node of a rope or a vertex of a cloth (jostle/modules/deformables.h).
struct DeformableTarget {
    std::string module;  // tag
    std::uint32_t object = 0, element = 0;

    bool operator==(const DeformableTarget&) const = default;
};

struct SpawnCommand {
    physics::ShapeDef shape;
    physics::Transform pose;
    physics::Vec3 linear_velocity, angular_velocity;
    std::optional<std::uint32_t> color;  // 0xRRGGBB
    // The encoded jostle.v1.Shape from which the shape was decoded; decoding it again yields a
    // bit-identical shape. Empty: the shape was not decoded from a message.
    std::string shape_bytes = {};
};
struct ImpulseCommand {
    EntityId entity = 0;
    physics::Vec3 impulse;               // N s
    std::optional<physics::Vec3> point;  // world; nothing: the centre of mass
    std::optional<Aim> aim = {};         // in place of entity, point and point_object
    std::uint32_t point_object = 0;      // in place of entity: its nearest point
    // In place of the entity, after the target was resolved.
    std::optional<DeformableTarget> deformable = {};
};
struct GrabCommand {
    EntityId entity = 0;
    physics::Vec3 point;             // world
    std::optional<Aim> aim = {};     // in place of entity, point and point_object
    std::uint32_t point_object = 0;  // in place of entity: its nearest point
    // In place of the entity, after the target was resolved.
    std::optional<DeformableTarget> deformable = {};
};
struct DragCommand {
    physics::Vec3 target;  // world
};
struct ReleaseCommand {};
struct DeleteCommand {
    EntityId entity = 0;
};
struct ExplodeCommand {
    physics::Vec3 center;
    double radius = 0;            // m
    double speed = 0;             // m/s at the centre
    std::optional<Aim> aim = {};  // in place of the centre
};
struct PossessCommand {
    EntityId entity = 0;  // 0: release the controlled entity
};
struct ControlCommand {
    physics::Controls controls;
};
// Cuts a rope or tears a cloth.
struct CutCommand {
    std::uint32_t point_object = 0;
    physics::Vec3 point;                         // world
    std::optional<Aim> aim = {};                 // in place of point_object and point
    std::optional<DeformableTarget> deformable;  // after the target was resolved
};
// Changes properties of a body. Nothing: the property stays unchanged.
struct EditCommand {
    EntityId entity = 0;
    std::optional<physics::Vec3> position = {};                                // m
    std::optional<physics::Quat> rotation = {};                                // unit length
    std::optional<physics::Vec3> linear_velocity = {}, angular_velocity = {};  // m/s, rad/s
    std::optional<double> mass = {}, density = {};                             // kg, kg/m^3
    std::optional<double> friction = {}, restitution = {};
    std::optional<std::uint32_t> color = {};  // 0xRRGGBB
    std::optional<bool> frozen = {};          // true: static
    std::optional<double> gravity_scale = {};
};
// Spawns a copy of a body, or of all bodies that joints connect to it.
struct CloneCommand {
    EntityId entity = 0;
    physics::Vec3 offset = {};  // m
    bool jointed = false;
};
struct CreateJointCommand {
    EntityId entity_a = 0, entity_b = 0;           // entity_a 0: the world
    std::optional<physics::Transform> frame = {};  // world; in place of the frames of the joint
    physics::JointDef joint = {};                  // without its bodies
};
struct DeleteJointCommand {
    std::uint32_t joint = 0;       // as clients name it
    physics::JointId target = {};  // after it was resolved
};
// Reverts the newest action of the client in the undo log (undo_log.h).
struct UndoCommand {};
// The client left: releases its grab and its controlled entity, and deletes its bodies unless they
// are retained. Has no sequence number.
struct LeaveCommand {
    bool retain_bodies = false;
};

// The client's connection broke and the client may resume: releases its grab and sets neutral
// controls on its controlled entity. Has no sequence number.
struct DisconnectCommand {};

// The client joined, or resumed after its connection broke. Has no sequence number.
struct JoinCommand {
    std::string name;
    PlayerRole role = PlayerRole::player;
    std::optional<std::uint32_t> color = {};  // 0xRRGGBB
    std::uint32_t tick = 0;                   // in which it is applied
};
struct RenameCommand {
    std::string name;
};
struct SetRoleCommand {
    ClientId player = 0;
    PlayerRole role = PlayerRole::player;
};
struct SetAttributesCommand {
    AttributeTarget target;
    std::vector<AttributeChange> changes;
};
// Sends a user message (user_messages.h).
struct SendMessageCommand {
    std::string topic, data;
    std::vector<ClientId> to = {};  // empty: all clients, unless to_server
    bool to_server = false;         // to the server alone
};

using Action =
    std::variant<SpawnCommand, ImpulseCommand, GrabCommand, DragCommand, ReleaseCommand,
                 DeleteCommand, ExplodeCommand, PossessCommand, ControlCommand, LeaveCommand,
                 DisconnectCommand, CutCommand, JoinCommand, RenameCommand, SetRoleCommand,
                 SetAttributesCommand, SendMessageCommand, RoomCommand, EditCommand, CloneCommand,
                 CreateJointCommand, DeleteJointCommand, UndoCommand>;

// Inputs that do not change bodies; they are also applied while the world is paused.
inline bool is_data_command(const Action& action) {
    return std::holds_alternative<RenameCommand>(action) ||
           std::holds_alternative<SetAttributesCommand>(action) ||
           std::holds_alternative<SendMessageCommand>(action);
}

// Inputs that build: they are also applied while a member of the room paused the world.
inline bool is_build_command(const Action& action) {
    return std::holds_alternative<SpawnCommand>(action) ||
           std::holds_alternative<DeleteCommand>(action) ||
           std::holds_alternative<EditCommand>(action) ||
           std::holds_alternative<CloneCommand>(action) ||
           std::holds_alternative<CreateJointCommand>(action) ||
           std::holds_alternative<DeleteJointCommand>(action) ||
           std::holds_alternative<UndoCommand>(action);
}

// The server sends these commands about a client; they have no sequence number.
inline bool is_session_command(const Action& action) {
    const auto* const about_room = std::get_if<RoomCommand>(&action);
    return std::holds_alternative<LeaveCommand>(action) ||
           std::holds_alternative<DisconnectCommand>(action) ||
           std::holds_alternative<JoinCommand>(action) ||
           (about_room && std::holds_alternative<EnterRoom>(about_room->kind));
}

// What an action created, deleted or changed.
struct Affected {
    EntityId entity = 0;
    physics::JointId joint = {};
};

// The outcome of one input.
struct InputResult {
    std::uint32_t sequence = 0;
    Status status;           // ok: applied. Errors are invalid_argument (a number out of range),
                             // not_found, permission_denied or resource_exhausted
    std::uint32_t tick = 0;  // in which it was applied
    EntityId entity = 0;     // the affected entity, if any; set for refused inputs, too
    // The input margin in us: the due time of the input's tick minus its time of arrival. Nothing:
    // the input did not reach a world.
    std::optional<std::int64_t> margin_us = {};
    // The view time was older than the oldest frame of the history, which was used instead.
    bool view_time_clamped = false;
    std::uint32_t joint = 0;  // the created or deleted joint, as clients name it; 0: none
};

class ResultQueue;

struct Command {
    ClientId client = 0;
    AccountId account = 0;
    std::uint32_t sequence = 0;  // per client, from 1, strictly increasing
    Action action;
    std::shared_ptr<ResultQueue> reply;  // null: the result is discarded
    Clock::time_point received{};
    std::uint32_t tick = 0;  // scheduled tick; 0 or a past tick: the next one
};

// A command as it was applied to a world. Replaying it on the previous state of the world yields
// the same next state.
struct JournaledCommand {
    ClientId client = 0;
    std::uint32_t sequence = 0;
    // Its target is resolved. Nothing: there was no target, so only the sequence number counts.
    std::optional<Action> action;
};
struct JournaledTick {
    std::uint32_t tick = 0;
    std::vector<JournaledCommand> commands;  // in the order in which they were applied
};

}  // namespace jostle::server
