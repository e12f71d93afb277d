// SPDX-License-Identifier: MIT
//
// The channel kinds that a client requested, which select the channels in the shared part of its
// snapshots. Used on the session's thread.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "jostle/physics/channels.h"
#include "server/session/snapshot_section.h"

namespace jostle::server {

// One bit per kind that `names` contains. "*" names every kind except jostle.motion.
std::uint64_t requested_channels(const std::vector<physics::ChannelKind>& kinds,
                                 const std::vector<std::string>& names);
// The bit of jostle.motion; 0: the world has no such kind.
std::uint64_t motion_channel(const std::vector<physics::ChannelKind>& kinds);

class ChannelsSection final : public SnapshotSection {
public:
    // `motion`: the bit of jostle.motion.
    ChannelsSection(std::uint64_t kinds, std::uint64_t motion);

    void on_enter(FrameListeners& listeners) override;
    void on_leave(FrameListeners& listeners) override;
    void append(const FramePtr&, Clock::time_point, SnapshotParts& parts) override {
        parts.channel_kinds = kinds_;
    }
    std::uint64_t kinds() const { return kinds_; }

private:
    const std::uint64_t kinds_;
    const bool has_motion_;
};

}  // namespace jostle::server
