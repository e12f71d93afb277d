// SPDX-License-Identifier: MIT
//
// One optional part of the snapshots of a client. A session has sections only for the parts that
// its client requested, so that idle clients cost little memory. Used on the session's thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "server/messages/out_message.h"
#include "server/messages/server_message.h"
#include "server/metrics/metrics.h"
#include "server/util/clock.h"
#include "server/world/frame.h"
#include "server/world/frame_publisher.h"

namespace jostle::server {

// A snapshot under construction.
struct SnapshotParts {
    ClientUpdate update{};
    std::string fields{};             // encoded fields of jostle.v1.Snapshot, for this client alone
    std::uint64_t channel_kinds = 0;  // one bit per channel kind of the shared part
    bool has_poses = true;            // false: cells replace the poses of the shared part
    std::vector<SharedBytes> shared_fields{};  // of jostle.v1.Snapshot, shared with other clients

    std::size_t size() const {
        std::size_t bytes = fields.size();
        for (const SharedBytes& field : shared_fields) bytes += field->size();
        return bytes;
    }
};

// Bytes by TrafficKind.
using TrafficBytes = std::array<std::size_t, traffic_kinds>;

class SnapshotSection {
public:
    virtual ~SnapshotSection() = default;

    // The client joined or resumed, or left, a world. `listeners`: the counts of that world, by
    // which it publishes data only while a client needs it.
    virtual void on_enter(FrameListeners&) {}
    virtual void on_leave(FrameListeners&) {}
    // The section has data that justifies a snapshot although the world did not change.
    virtual bool has_changes(const Frame&) const { return false; }
    // Appends the data of the section, which counts as sent: the caller sends the snapshot if any
    // section appended data.
    virtual void append(const FramePtr& frame, Clock::time_point now, SnapshotParts& parts) = 0;
    // The complete snapshot was passed to the transport.
    virtual void on_sent(const OutMessage&) {}
    // How the bytes of append() are counted.
    virtual TrafficKind traffic_kind() const { return TrafficKind::poses; }
};

}  // namespace jostle::server
