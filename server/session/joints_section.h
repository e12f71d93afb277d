// SPDX-License-Identifier: MIT
//
// The list of joints for a client that subscribed to it: the complete list first, then its changes.
// A large change is spread over several snapshots. Used on the session's thread.
#pragma once

#include <deque>
#include <memory>

#include "server/session/broadcast_cache.h"
#include "server/session/snapshot_section.h"

namespace jostle::server {

class JointsSection final : public SnapshotSection {
public:
    explicit JointsSection(BroadcastCache& broadcast) : broadcast_(broadcast) {}

    void on_enter(FrameListeners& listeners) override { listeners.joints++; }
    void on_leave(FrameListeners& listeners) override { listeners.joints--; }
    bool has_changes(const Frame& frame) const override {
        return !pending_.empty() || (frame.joint_list && frame.joint_list != list_);
    }
    void append(const FramePtr& frame, Clock::time_point now, SnapshotParts& parts) override;

private:
    BroadcastCache& broadcast_;
    std::shared_ptr<const JointList> list_;  // that the client has after pending_; null: unknown
    std::deque<SharedBytes> pending_;        // one per snapshot
};

}  // namespace jostle::server
