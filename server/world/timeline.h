// SPDX-License-Identifier: MIT
//
// The recent states of a room to which its members can rewind it: one per simulated second. A
// persisted world restores them from its database, so that only their ticks are stored. The tick
// thread stores states; any thread reads them after the world has stopped.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

#include "jostle/physics/restore_point.h"
#include "server/world/hosted_world.h"

namespace jostle::server {

using RestorableTicks = std::shared_ptr<const std::vector<std::uint32_t>>;

class Timeline {
public:
    // Estimated memory of all states. Fewer states are stored beyond it.
    static constexpr std::size_t bytes_max = std::size_t{128} << 20;

    // `hz`: steps per second. `stores_states`: false: the world is persisted.
    Timeline(double hz, bool stores_states) : hz_(hz), stores_states_(stores_states) {}

    // After each tick. `seconds`: to store; 0: none. `oldest_tick`: that a persisted world can
    // restore.
    void on_tick(std::uint32_t tick, bool stepped, const HostedWorld& world, std::uint32_t seconds,
                 std::uint32_t oldest_tick);
    // Ascending; the same pointer until it changes.
    const RestorableTicks& ticks() const { return ticks_; }
    bool contains(std::uint32_t tick) const;
    std::size_t bytes() const { return bytes_; }

    // The state after a tick. not_found: it is not stored.
    Result<HostedWorld> world_at(std::uint32_t tick, const HostLimits& limits, int threads,
                                 double work_per_second) const;

private:
    struct State {
        std::uint32_t tick = 0;
        physics::RestorePoint bodies = {};
        SavedHostState host_state = {};
        std::size_t bytes = 0;
    };
    void drop_oldest();
    void publish();

    double hz_;
    bool stores_states_;
    std::deque<State> states_;  // oldest first
    physics::RestorePoint spare_;
    std::size_t bytes_ = 0;
    double steps_since_ = 0;  // the newest state
    RestorableTicks ticks_ = std::make_shared<const std::vector<std::uint32_t>>();
};

}  // namespace jostle::server
