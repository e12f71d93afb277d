// SPDX-License-Identifier: MIT
//
// Everything anyone may ask of a world, as plain values. Made by protocol/client_message, checked
// by session/admission, queued, and turned into World calls by host/apply_action and nowhere else.
// A new kind is a command here, a case in client_message.cpp, its limits in admission.cpp and what
// it does in apply_action.cpp; where one of them lacks, the compiler says so.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "jostle/base/result.h"
#include "jostle/physics/defs.h"
#include "jostle/physics/module.h"
#include "server/util/clock.h"

namespace jostle::server {

using EntityId = std::uint32_t;  // never reused in a world; 0 is none
using ClientId = std::uint32_t;  // 0 is the scene

// The world as a client saw it when it acted: so far on the way from a tick to the next.
struct ViewTime {
    std::uint32_t tick = 0;
    double fraction = 0;  // 0 to 1

    bool operator==(const ViewTime&) const = default;
};
// What a client points at: the first thing that the ray meets.
struct Aim {
    physics::Vec3 origin, motion;            // world; m
    EntityId ignore = 0;                     // an entity that the ray goes through; 0: none
    std::optional<ViewTime> view_time = {};  // nothing: as the world is when the input is applied
};

struct SpawnCommand {
    physics::ShapeDef shape;
    physics::Transform pose;
    physics::Vec3 linear_velocity, angular_velocity;
    std::optional<std::uint32_t> color;  // 0xRRGGBB
    // The jostle.v1.Shape that the shape was read from: read again it gives the same to the bit.
    // Empty: it was not.
    std::string shape_bytes = {};
};
struct ImpulseCommand {
    EntityId entity = 0;
    physics::Vec3 impulse;               // N s
    std::optional<physics::Vec3> point;  // world; nothing: the centre of mass
    std::optional<Aim> aim = {};         // in place of entity and point
};
struct GrabCommand {
    EntityId entity = 0;
    physics::Vec3 point;          // world
    std::optional<Aim> aim = {};  // in place of entity and point
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
    EntityId entity = 0;  // 0: lets go
};
struct ControlCommand {
    physics::Controls controls;
};
// The client is gone: lets go, and takes its bodies along unless they are to be kept. Carries no
// sequence.
struct LeaveCommand {
    bool retain_bodies = false;
};

// The client's connection broke, and it may come back: its hand lets go, and what it drives is as
// if it held nothing. Carries no sequence.
struct DisconnectCommand {};

using Action = std::variant<SpawnCommand, ImpulseCommand, GrabCommand, DragCommand, ReleaseCommand,
                            DeleteCommand, ExplodeCommand, PossessCommand, ControlCommand,
                            LeaveCommand, DisconnectCommand>;

// What became of one input.
struct InputResult {
    std::uint32_t sequence = 0;
    Status status;           // ok: applied. Errors are invalid_argument (a number out of range),
                             // not_found, permission_denied or resource_exhausted
    std::uint32_t tick = 0;  // in which it was applied
    EntityId entity = 0;     // which one it was about, if any; of a refused one, too
    // us that it came before the tick it was meant for was due; negative: after. Nothing: no world
    // saw it.
    std::optional<std::int64_t> margin_us = {};
    // It named a moment of which no frame was left, and was judged by the oldest one.
    bool view_time_clamped = false;
};

class ResultQueue;

struct Command {
    ClientId client = 0;
    std::uint32_t sequence = 0;  // rises by one or more per client, from 1
    Action action;
    std::shared_ptr<ResultQueue> reply;  // null: nobody waits for the result
    Clock::time_point received{};
    std::uint32_t tick = 0;  // which it is meant for, if that is still to come; 0: the next
};

}  // namespace jostle::server
