// SPDX-License-Identifier: MIT
//
// The list of joints for a client that subscribed to it: the complete list first, then its changes.
// A large change is spread over several snapshots, at most one field in each. Used on the session's
// thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <unordered_set>

#include "server/session/broadcast_cache.h"
#include "server/session/cells_section.h"
#include "server/session/snapshot_section.h"

namespace jostle::server {

// For a client that receives all entities. Clients share the encoded fields.
class JointsSection final : public SnapshotSection {
public:
    explicit JointsSection(BroadcastCache& broadcast) : broadcast_(broadcast) {}

    void on_enter(FrameListeners& listeners) override { listeners.joints++; }
    void on_leave(FrameListeners& listeners) override { listeners.joints--; }
    bool has_changes(const Frame& frame) const override {
        return change_ || (frame.joint_list && frame.joint_list != list_);
    }
    void append(const FramePtr& frame, Clock::time_point now, SnapshotParts& parts) override;

private:
    BroadcastCache& broadcast_;
    std::shared_ptr<const JointList> list_;    // that the client has after change_; null: unknown
    std::shared_ptr<JointListChange> change_;  // being sent; null: none
    std::size_t next_field_ = 0;
};

// For a client with an area of interest: the joints of entities that the client received, after
// these entities and within the byte budget that they share. Its fields are not shared.
class KnownJointsSection final : public SnapshotSection {
public:
    // The joints that one snapshot examines at most: 1 ms for 200,000 would add up over clients.
    static constexpr std::size_t examined_per_snapshot_max = 16384;

    explicit KnownJointsSection(CellsSection& cells) : cells_(cells) {}

    void on_enter(FrameListeners& listeners) override { listeners.joints++; }
    void on_leave(FrameListeners& listeners) override { listeners.joints--; }
    bool has_changes(const Frame& frame) const override {
        return scanning() || (frame.joint_list && frame.joint_list != list_);
    }
    void append(const FramePtr& frame, Clock::time_point now, SnapshotParts& parts) override;

private:
    bool scanning() const { return list_ && scanned_ < list_->size(); }
    void remove_missing(const JointList& list, JointUpdateWriter& writer);
    void add_known(JointUpdateWriter& writer);

    CellsSection& cells_;
    std::shared_ptr<const JointList> list_;   // null: no update was sent
    std::unordered_set<std::uint32_t> sent_;  // ids of the joints that the client has
    std::size_t scanned_ = 0;                 // joints of list_ since the last change
    std::uint64_t known_revision_ = 0;        // of the entities of the client at the last change
};

}  // namespace jostle::server
