// SPDX-License-Identifier: MIT
//
// The area of interest of one client, and the cells (cell_snapshot_cache.h) it is sent next. Near
// cells are sent with every snapshot, cells beyond half of the radius with every second one, and
// cells beyond three quarters with every fourth. Cells that waited longest and are nearest come
// first, within the client's budget: a token bucket of bytes that holds one twentieth of a second,
// and a limit on the bytes of any second. New cells have a quota of their own, half of the rate, so
// that entering a crowded area does not stop updates of moving entities; they also get what updates
// leave. While point objects wait (points_section.h), cells leave them half of the rate.
//
// Threads: one thread at a time.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "jostle/base/check.h"
#include "server/replication/baseline_tracker.h"
#include "server/replication/cell_snapshot_cache.h"
#include "server/util/clock.h"
#include "server/util/fifo.h"

namespace jostle::server {

struct Interest {
    double x_m = 0, z_m = 0;
    double radius_m = std::numeric_limits<double>::infinity();
};

class InterestView {
public:
    // `bytes_per_second`: 0 for no limit.
    explicit InterestView(double bytes_per_second) : rate_(bytes_per_second) {
        ASSERT(bytes_per_second >= 0);
    }

    void set_interest(const Interest& interest) { interest_ = interest; }
    const Interest& interest() const { return interest_; }

    struct PendingCell {
        CellState state;
        snapshot::BaselineFrames baselines;
        bool fresh = false;        // the client does not have the cell
        bool new_members = false;  // an entity entered the cell since it was last sent
    };
    // The cells to send in this tick in order of priority: new cells, then known ones. Send each as
    // long as affords() allows. Refills the budget.
    std::vector<PendingCell> pending_cells(const CellSnapshotCache& cache,
                                           const std::vector<CellSnapshotCache::CellLevels>& cells,
                                           std::uint32_t tick, Clock::time_point now);
    // Adds the tokens since the last call. pending_cells() calls it too.
    void refill(Clock::time_point now);
    // Whether `bytes` of cells or entities may be sent now; `fresh`: within the quota of new cells.
    bool affords(std::size_t bytes, bool fresh) const;
    void spend(std::size_t bytes, bool fresh);

    // --- point objects, which share the budget with cells ---
    // Whether cells or point objects are waiting. If both are, each has half of the rate.
    void set_points_waiting(bool points) { points_wait_ = points; }
    void set_cells_waiting(bool cells) { cells_wait_ = cells; }
    bool is_limited() const { return rate_ != 0; }
    // Bytes of point objects that may be sent now; negative after a large piece.
    double point_tokens() const;
    // A piece larger than the bucket is sent when the bucket is full. The bucket of point objects
    // is half of all; the other half may be in constant use.
    bool point_bucket_is_full() const;
    void spend_points(std::size_t bytes);
    // Snapshots from one update to the next at a distance.
    std::uint32_t interval(double distance_m) const;
    // Whether an object at this distance has left the area of interest.
    bool leaves(double distance_m) const;

    void on_sent(const PendingCell& part, bool is_keyframe, std::uint32_t tick);
    // Cells that the client must remove: they left its area of interest since the last call.
    std::vector<CellId> take_left() { return std::exchange(left_, {}); }
    // The client lost its state: each of its cells is sent as a keyframe.
    void reset();

private:
    // Whether a cell is sent in the precision of distant cells; `was`: it was so before.
    bool is_far(double distance_m, bool was) const;

    struct Known {
        BaselineTracker states;  // by cell state number
        bool far = false;        // CellState::far when last sent
        std::uint32_t sent_tick = 0;
        std::uint32_t members = 0;  // CellState::members when last sent
    };
    struct Sent {
        Clock::time_point at;
        double bytes;
    };
    void count_sent(std::size_t bytes);

    const double rate_;  // bytes per second
    Fifo<Sent> last_second_;
    double sent_in_second_ = 0;  // sum of last_second_
    double tokens_ = 0, fresh_tokens_ = 0;
    double point_tokens_ = 0;  // the part of the tokens that is for point objects
    bool points_wait_ = false, cells_wait_ = false;
    Clock::time_point refilled_{};
    Interest interest_;
    std::map<CellId, Known> known_;
    std::vector<CellId> left_;
};

}  // namespace jostle::server
