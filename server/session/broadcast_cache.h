// SPDX-License-Identifier: MIT
//
// The data that all clients of one world share: snapshots, entity list changes, events and
// statistics, each encoded once. Sessions of several network threads use one cache; any thread.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "server/messages/entity_update_message.h"
#include "server/messages/joint_update_message.h"
#include "server/replication/point_cache.h"
#include "server/replication/pose_cache.h"
#include "server/session/shared_data.h"
#include "server/world/world_host.h"

namespace jostle::server {

class BroadcastCache {
public:
    BroadcastCache(std::shared_ptr<WorldHost> host, double interest_cell_m);

    WorldHost& host() const { return *host_; }
    // The poses in a granted precision, created if no client uses it yet. Never null.
    std::shared_ptr<PoseCache> poses(const StreamPrecision& precision);
    PointCache& points() { return points_; }

    // The messages that change a client's entity list from `from` to `to`; null `from`: the client
    // has no entities.
    std::shared_ptr<const EntityUpdateMessages> entity_list_change(
        const std::shared_ptr<const EntityList>& from, const std::shared_ptr<const EntityList>& to,
        EntityForm form);
    // The messages that add these entities.
    EntityUpdateMessages entity_update_for(const EntityList& entities, EntityForm form);
    // The change of a client's list of joints from `from` to `to`; null `from`: its list is
    // unknown.
    std::shared_ptr<JointListChange> joint_list_change(const std::shared_ptr<const JointList>& from,
                                                       const std::shared_ptr<const JointList>& to);
    // A field of a Snapshot.
    SharedBytes world_stats(const FramePtr& frame, std::uint32_t clients);
    // The shared fields of an Events message.
    SharedBytes events(const std::shared_ptr<const TickEvents>& tick);
    // Players, attributes and user messages.
    SharedData& data() { return data_; }

private:
    struct EntityListChange {
        // Owned, so that no other entity list can have the same address.
        std::shared_ptr<const EntityList> from, to;
        EntityForm form;
        std::shared_ptr<const EntityUpdateMessages> messages;
    };

    const std::shared_ptr<WorldHost> host_;
    const double interest_cell_m_;
    PointCache points_;
    SharedData data_;
    std::mutex mutex_;
    std::map<StreamPrecision, std::weak_ptr<PoseCache>> poses_;
    // The last one stays for a client that resumes.
    std::shared_ptr<PoseCache> last_poses_;
    GeometryTable geometry_;
    std::vector<EntityListChange> entity_list_changes_;                // oldest first
    std::deque<std::shared_ptr<JointListChange>> joint_list_changes_;  // oldest first
    std::deque<std::pair<std::shared_ptr<const TickEvents>, SharedBytes>> events_;
    FramePtr stats_frame_;
    std::uint32_t stats_clients_ = 0;
    SharedBytes stats_;
};

// The cache of each world that has clients. Any thread.
class BroadcastCaches {
public:
    // Creates the cache if there is none. `interest_cell_m`: edge of its interest cells, in m.
    std::shared_ptr<BroadcastCache> cache_for(const std::shared_ptr<WorldHost>& host,
                                              double interest_cell_m);

private:
    std::mutex mutex_;
    std::map<const WorldHost*, std::weak_ptr<BroadcastCache>> caches_;
};

}  // namespace jostle::server
