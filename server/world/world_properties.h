// SPDX-License-Identifier: MIT
//
// The constants of a hosted world, from its start to its end. Any thread.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "jostle/physics/channels.h"
#include "jostle/scenes/scene.h"
#include "server/util/clock.h"

namespace jostle::server {

struct WorldLabel {
    std::string id, name;
    std::string owner;  // subject of the creator; empty: the server itself
};

struct WorldProperties {
    WorldLabel label;
    std::shared_ptr<const scenes::SceneDescription> scene;
    double hz = 60;                // ticks per second
    double work_per_second = 0;    // estimate of scene_budget.h
    physics::Vec3 gravity;         // m/s^2
    int substeps = 0;              // per step; 0: chosen per island by the tolerance
    Clock::time_point epoch;       // due time of tick 0
    std::uint32_t first_tick = 1;  // the tick that the host started from
    bool is_room = false;          // frames have a RoomView
    // The channels that modules publish; a channel's kind is an index of this list.
    std::vector<physics::ChannelKind> channel_kinds;

    Clock::time_point due_time(std::uint32_t tick) const { return epoch + from_seconds(tick / hz); }
};

}  // namespace jostle::server
