// SPDX-License-Identifier: MIT
//
// Limits on the bodies that players add to one world, by what they cost the others: a player behind
// several clients has one allowance, a busy world accepts no further bodies, and a world that
// cannot keep its rate loses bodies of the clients that own most, in the account that owns most.
// Not part of the state of the world: what it removes is journaled. The tick thread only.
#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <optional>
#include <vector>

#include "jostle/base/result.h"
#include "server/util/clock.h"
#include "server/world/command.h"
#include "server/world/ownership.h"

namespace jostle::server {

class BodyLimits {
public:
    struct Settings {
        int account_bodies_max = 500;  // bodies that all clients of an account own; 0: unlimited
        double spawn_load_max = 0.7;   // no spawns above this load; 0: unlimited
        double retained_seconds = 0;   // bodies of clients that left; 0: they stay
    };
    // `hz`: of the world.
    BodyLimits(const Settings& settings, double hz) : settings_(settings), hz_(hz) {}

    // Why the command must not be applied; nothing: it may. A spawn that may be applied counts.
    std::optional<Error> refusal(const Command& command, const Ownership& ownership);
    // The client leaves and its bodies stay.
    void on_retained(std::vector<EntityId> bodies, Clock::time_point now);
    // Ends a tick for which the tick thread was busy for `cpu_seconds`. `steps`: the world is not
    // paused.
    void end_tick(double cpu_seconds, bool steps);

    // Bodies to remove now, of clients that left and of a world that cannot keep its rate.
    struct Removal {
        std::vector<EntityId> expired, excess;
    };
    Removal take_removals(const Ownership& ownership, Clock::time_point now);

    // Busy time of the tick thread as a fraction of the tick period, averaged over about 0.5 s.
    double load() const { return load_; }

private:
    std::vector<EntityId> find_excess(const Ownership& ownership) const;

    const Settings settings_;
    const double hz_;
    double load_ = 0;
    int overloaded_ticks_ = 0;
    double spawns_left_ = 60;  // until the next tick
    // Of the clients that spawned bodies. Few clients; those that left are erased with their
    // bodies.
    std::map<ClientId, AccountId> accounts_;
    struct Retained {
        std::vector<EntityId> bodies;
        Clock::time_point until;
    };
    std::deque<Retained> retained_;  // by time
};

}  // namespace jostle::server
