// SPDX-License-Identifier: MIT
//
// What one client sees of its world, and which cells (cell_snapshot_cache.h) it is sent next. Near
// cells come with every snapshot; beyond half of the radius every second one, beyond three quarters
// every fourth. What waited longest and is nearest comes first, for as long as the client's budget
// lasts: a token bucket of bytes that holds a twentieth of a second, so that no second has more
// than a twentieth beyond the rate. What is new to the client has a quota of its own, half of the
// rate, so that entering a crowd does not stop what moves.
//
// Thread rule: one thread at a time.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "server/replication/baseline_tracker.h"
#include "server/replication/cell_snapshot_cache.h"
#include "server/util/clock.h"

namespace jostle::server {

struct Interest {
    double x_m = 0, z_m = 0;
    double radius_m = std::numeric_limits<double>::infinity();
};

class InterestView {
public:
    // `bytes_per_second`: 0 without a bound.
    explicit InterestView(double bytes_per_second) : rate_(bytes_per_second) {}

    void set_interest(const Interest& interest) { interest_ = interest; }
    const Interest& interest() const { return interest_; }

    struct PendingCell {
        CellState state;
        wire::BaselineFrames baselines;
        bool fresh = false;        // the client does not know the cell
        bool new_members = false;  // somebody is in it who was not when it was sent last
    };
    // What should go out in that tick, in the order in which it should: what is new, then what is
    // known. Of each as much as affords() lets. Refills the budget.
    std::vector<PendingCell> pending_cells(const CellSnapshotCache& feed,
                                           const std::vector<CellState>& cells, std::uint32_t tick,
                                           Clock::time_point now);
    // Whether so many bytes may go out now.
    bool affords(std::size_t bytes, bool fresh) const;
    void spend(std::size_t bytes, bool fresh);
    void on_sent(const PendingCell& part, std::uint32_t tick);
    // Cells that the client is to forget: they are out of sight since the last call of wanted().
    std::vector<CellId> take_left() { return std::exchange(left_, {}); }
    // The client lost track: each cell that it has is sent whole again.
    void reset();

private:
    struct Known {
        BaselineTracker states;  // by their numbers
        std::uint32_t sent_tick = 0;
        std::uint32_t members = 0;  // CellState::members as of then
    };
    void refill(Clock::time_point now);
    std::uint32_t interval(double distance_m) const;

    const double rate_;  // bytes a second
    double tokens_ = 0, fresh_tokens_ = 0;
    Clock::time_point refilled_{};
    Interest interest_;
    std::map<CellId, Known> known_;
    std::vector<CellId> left_;
};

}  // namespace jostle::server
