// SPDX-License-Identifier: MIT
//
// The point objects of a client: descriptions of objects that it does not have, and states of those
// that changed. With an area of interest, near objects come first and distant ones are updated less
// often. With a byte budget, an object first has few levels of points and gains levels while the
// budget lasts. Cells and point objects share the budget (interest_view.h). Used on the session's
// thread.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "server/replication/interest_view.h"
#include "server/replication/point_cache.h"
#include "server/session/broadcast_cache.h"
#include "server/session/snapshot_section.h"

namespace jostle::server {

class PointsSection final : public SnapshotSection {
public:
    // `kinds`: one bit per channel kind that the client requested. `view`: null: the whole world
    // without a budget; it outlives the section.
    PointsSection(std::uint64_t kinds, BroadcastCache& broadcast, InterestView* view)
        : kinds_(kinds), broadcast_(broadcast), view_(view) {}

    void on_enter(FrameListeners& listeners) override { listeners.points++; }
    void on_leave(FrameListeners& listeners) override { listeners.points--; }
    // The budget did not suffice for all objects. A snapshot for them alone is worth its head only
    // every few ticks.
    bool has_changes(const Frame& frame) const override {
        return has_pending_ && frame.tick >= last_tick_ + retry_ticks;
    }
    void append(const FramePtr& frame, Clock::time_point now, SnapshotParts& parts) override;
    TrafficKind traffic_kind() const override { return TrafficKind::points; }

    // The client lost its state: each object is sent again.
    void reset() { known_.clear(); }

private:
    using StatePtr = std::shared_ptr<const PointObjectState>;

    struct Known {
        SentStates sent;
        std::uint32_t sent_tick = 0;
    };
    struct Candidate {
        StatePtr state;
        double rank = 0;
        bool refines = false;  // the client has the state with fewer levels
    };

    std::vector<Candidate> candidates(const PointObjects& objects, std::uint32_t tick);
    void remove_ended(const PointObjects& objects, SnapshotParts& parts);
    double distance(const PointObjectState& state) const;
    bool is_due(const PointObjectState& state, const Known& known, std::uint32_t tick) const;
    void send(const Candidate& candidate, double allowed_bytes, std::uint32_t tick,
              SnapshotParts& parts);
    static SentStates estimate_from(const Candidate& candidate, const SentStates& sent);
    std::size_t levels_within(const PointCache::Encoding& complete, double bytes) const;

    static constexpr std::uint32_t retry_ticks = 3;

    const std::uint64_t kinds_;
    BroadcastCache& broadcast_;
    InterestView* const view_;
    std::map<std::uint32_t, Known> known_;  // by object
    std::uint32_t last_tick_ = 0;           // of append()
    bool has_pending_ = false;
};

}  // namespace jostle::server
