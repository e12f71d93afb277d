// SPDX-License-Identifier: MIT
//
// The output of a world: an immutable copy of the state that clients may see, made once per tick
// and shared by all threads.
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "jostle/physics/world.h"
#include "server/util/clock.h"
#include "server/world/attributes.h"
#include "server/world/command.h"
#include "server/world/joint_list.h"
#include "server/world/module_channels.h"
#include "server/world/players.h"
#include "server/world/pose_grid.h"
#include "server/world/pose_list.h"
#include "server/world/room_state.h"
#include "server/world/tick_events.h"
#include "server/world/user_messages.h"

namespace jostle::server {

// The constant properties of an entity, which clients receive when it appears and after an edit.
struct EntityDescription {
    EntityId id = 0;
    physics::BodyType type = physics::BodyType::dynamic;
    std::vector<physics::ShapeState> shapes;
    ClientId owner = 0;
    std::optional<std::uint32_t> color;
    std::string name;
    double mass = 0;            // kg
    bool controllable = false;  // clients can possess it
    bool jointed = false;
    double linear_damping = 0, angular_damping = 0, gravity_scale = 1;
    physics::AxisLocks locks = 0;
    bool frozen = false;         // an edit made the dynamic body static
    std::uint32_t revision = 0;  // 0: never edited; otherwise unique in the world
    double bounding_radius = 0;  // m from its origin to its farthest corner; infinite for planes
};

// In ascending order of id. A new list is made only when an entity appears, disappears or is
// edited, so equal pointers mean equal entity lists.
using EntityList = std::vector<std::shared_ptr<const EntityDescription>>;

// The module state of a controlled entity, encoded by jostle/modules/controlled_entity_state.h.
struct ControlledEntityState {
    ClientId client = 0;
    EntityId entity = 0;
    std::string module;  // tag
    std::vector<std::uint32_t> words;
};

struct Frame {
    std::uint32_t tick = 0;         // from 1
    Clock::time_point due;          // when the tick was due
    Clock::time_point published{};  // when clients could get it
    // Due time minus the ideal due time, which follows from the world's epoch and the tick number:
    // the total time of skipped ticks.
    std::int64_t late_us = 0;
    PoseList entities;  // same order as entity_list
    // The newest tick, this one included, that changed a pose, an awake flag, the entity list, a
    // channel or a point object; and that value as of the previous frame.
    std::uint32_t changed_at = 0, previous_changed_at = 0;
    std::shared_ptr<const EntityList> entity_list;
    // Never null; empty unless a client subscribed to events.
    std::shared_ptr<const RecentEvents> events;
    // The channels of modules; null: none. A channel that did not change shares its values with the
    // previous frame.
    std::shared_ptr<const Channels> channels;
    // Point objects of modules, while a client subscribes to them; null: none. An object that did
    // not change shares its state with the previous frame.
    std::shared_ptr<const PointObjects> points;
    // Of this tick, while a client predicts; null: no entity is controlled.
    std::shared_ptr<const std::vector<ControlledEntityState>> controlled_entities;
    // While a client subscribes to joints; null: none does.
    std::shared_ptr<const JointList> joint_list;
    RoomView room;  // null: the world is no room
    // Never null in the frames of a hosted world. Equal pointers mean equal content.
    PlayerListPtr players;
    AttributeTablePtr attributes;
    RecentMessagesPtr messages;
    bool has_new_data = false;  // one of the three differs from that of the previous frame
    int awake = 0, contacts = 0;
    double step_ms = 0;                        // of this tick, solver only
    double tick_ms_mean = 0, tick_ms_max = 0;  // of whole ticks, over the last second
    double time_scale = 1;                     // simulated by elapsed time; see TimeScale
    std::optional<std::string> paused;         // the reason; nothing: the world is not paused
    std::uint32_t speed_percent = 100;         // of real time; set by members of a room
    // Ticks to which members of a room can rewind it, ascending; null: none.
    std::shared_ptr<const std::vector<std::uint32_t>> restorable_ticks;
    std::uint32_t late_ticks = 0;  // skipped since the start of the world

    // The grid of `entities`, built by the first call. Any thread.
    const PoseGrid& pose_grid() const;

private:
    LazyPoseGrid pose_grid_;
};

using FramePtr = std::shared_ptr<const Frame>;

// A time in the past of a world, between two of its frames.
struct RewindFrames {
    FramePtr before, after;  // equal for a time exactly at a frame
    double fraction = 0;     // from `before` to `after`, 0 to 1
    bool clamped = false;    // the requested time is older than the oldest frame, which is used
};

// The newest frames of a world, for lag compensation: clients render the world as it was some time
// ago and aim at that. A world without clients has only the newest frame. The tick thread puts
// frames; any thread reads them. Readers share the ownership of the frames that they got.
class FrameRing {
public:
    // Holds the frames of `history_ms` at a rate of `hz`, and at least the newest one.
    FrameRing(double history_ms, double hz);

    // `retain`: keeps past frames, unless ticks are missing between them and this one.
    void put(FramePtr frame, bool retain);
    // A time after the newest frame yields the newest frame. Nothing: no frame was put yet.
    std::optional<RewindFrames> at(const ViewTime& view_time) const;

    std::size_t frames_max() const { return frames_max_; }

private:
    const std::size_t frames_max_;
    mutable std::mutex mutex_;
    std::deque<FramePtr> frames_;  // one per tick, consecutive ticks
};

}  // namespace jostle::server
