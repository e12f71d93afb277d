// SPDX-License-Identifier: MIT
//
// What all clients of one world are sent alike: its snapshots, its entity list changes and its
// statistics, each made into bytes once and shared. Client links of several network threads use one
// feed; any thread.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "server/messages/entity_update_message.h"
#include "server/replication/cell_snapshot_cache.h"
#include "server/replication/snapshot_cache.h"
#include "server/world/world_host.h"

namespace jostle::server {

class BroadcastCache {
public:
    BroadcastCache(std::shared_ptr<WorldHost> host, double interest_cell_m);

    WorldHost& host() const { return *host_; }
    SnapshotCache& snapshots() { return snapshots_; }
    CellSnapshotCache& cells() { return cells_; }
    // The cells of a frame, or of a newer one.
    CellSnapshotCache::Cells cells_of(const FramePtr& frame);

    // The messages that take a client from one entity list to another; null `from`: it knows
    // nothing yet.
    std::shared_ptr<const EntityUpdateMessages> entity_list_change(
        const std::shared_ptr<const EntityList>& from, const std::shared_ptr<const EntityList>& to);
    // A field of a Snapshot.
    // The messages that tell of these entities.
    EntityUpdateMessages entity_update_for(const EntityList& entities);
    SharedBytes world_stats(const FramePtr& frame, std::uint32_t clients);
    // The fields of an Events message that all who asked for events share.
    SharedBytes events(const std::shared_ptr<const TickEvents>& tick);

private:
    struct EntityListChange {
        std::shared_ptr<const EntityList> from,
            to;  // held, so that no other entity list can have their address
        std::shared_ptr<const EntityUpdateMessages> messages;
    };

    const std::shared_ptr<WorldHost> host_;
    SnapshotCache snapshots_;
    CellSnapshotCache cells_;
    std::mutex mutex_;
    GeometryTable geometry_;
    std::vector<EntityListChange> entity_list_changes_;  // the newest few
    std::deque<std::pair<std::shared_ptr<const TickEvents>, SharedBytes>> events_;  // likewise
    FramePtr stats_frame_;
    std::uint32_t stats_clients_ = 0;
    SharedBytes stats_;
};

// The feed of each world that has clients. Any thread.
class BroadcastCaches {
public:
    // `interest_cell_m`: edge of the cells of a feed that is made.
    std::shared_ptr<BroadcastCache> cache_for(const std::shared_ptr<WorldHost>& host,
                                              double interest_cell_m);

private:
    std::mutex mutex_;
    std::map<const WorldHost*, std::weak_ptr<BroadcastCache>> feeds_;
};

}  // namespace jostle::server
