// SPDX-License-Identifier: MIT
//
// Statistics of the world, a few times per second. Used on the session's thread.
#pragma once

#include "server/config/config.h"
#include "server/limits/session_directory.h"
#include "server/session/broadcast_cache.h"
#include "server/session/snapshot_section.h"

namespace jostle::server {

class StatsSection final : public SnapshotSection {
public:
    StatsSection(const StreamSettings& settings, const SessionDirectory& sessions,
                 BroadcastCache& broadcast)
        : period_(from_seconds(1 / settings.stats_per_second)),
          sessions_(sessions),
          broadcast_(broadcast) {}

    void append(const FramePtr& frame, Clock::time_point now, SnapshotParts& parts) override {
        if (now - last_sent_ < period_) return;
        last_sent_ = now;
        const int clients = sessions_.clients_in(broadcast_.host().id());
        parts.fields += *broadcast_.world_stats(frame, static_cast<std::uint32_t>(clients));
    }

private:
    const Clock::duration period_;
    const SessionDirectory& sessions_;
    BroadcastCache& broadcast_;
    Clock::time_point last_sent_{};
};

}  // namespace jostle::server
