// SPDX-License-Identifier: MIT
#include "server/session/broadcast_cache.h"

#include <algorithm>

#include "jostle/base/check.h"
#include "server/messages/event_message.h"
#include "server/messages/server_message.h"

namespace jostle::server {

namespace {

// Clients that lag by a few changes still share messages; a client that lags further gets its own.
constexpr std::size_t entity_list_changes_retained = 16;
constexpr std::size_t joint_list_changes_retained = 4;

SharedBytes share(std::string bytes) {
    return std::make_shared<const std::string>(std::move(bytes));
}

}  // namespace

BroadcastCache::BroadcastCache(std::shared_ptr<WorldHost> host, double interest_cell_m)
    : host_(std::move(host)),
      interest_cell_m_(interest_cell_m),
      points_(encode_points_field, encode_point_object_field) {
    ASSERT(host_ != nullptr);
}

std::shared_ptr<PoseCache> BroadcastCache::poses(const StreamPrecision& precision) {
    const std::lock_guard lock(mutex_);
    std::erase_if(poses_, [](const auto& entry) { return entry.second.expired(); });
    std::weak_ptr<PoseCache>& known = poses_[precision];
    std::shared_ptr<PoseCache> poses = known.lock();
    if (!poses) {
        poses = std::make_shared<PoseCache>(precision, interest_cell_m_, encode_shared_snapshot,
                                            encode_cell_field);
        known = poses;
    }
    last_poses_ = poses;
    return poses;
}

EntityUpdateMessages BroadcastCache::entity_update_for(const EntityList& entities,
                                                       EntityForm form) {
    const std::lock_guard lock(mutex_);
    static const EntityList nothing;
    return entity_update_messages(nothing, entities, geometry_, form);
}

std::shared_ptr<const EntityUpdateMessages> BroadcastCache::entity_list_change(
    const std::shared_ptr<const EntityList>& from, const std::shared_ptr<const EntityList>& to,
    EntityForm form) {
    ASSERT(to != nullptr);
    const std::lock_guard lock(mutex_);
    for (const EntityListChange& change : entity_list_changes_) {
        if (change.from == from && change.to == to && change.form == form) return change.messages;
    }
    static const EntityList nothing;
    const auto messages = std::make_shared<const EntityUpdateMessages>(
        entity_update_messages(from ? *from : nothing, *to, geometry_, form));
    if (entity_list_changes_.size() == entity_list_changes_retained)
        entity_list_changes_.erase(entity_list_changes_.begin());
    entity_list_changes_.push_back({from, to, form, messages});
    return messages;
}

std::shared_ptr<JointListChange> BroadcastCache::joint_list_change(
    const std::shared_ptr<const JointList>& from, const std::shared_ptr<const JointList>& to) {
    const std::lock_guard lock(mutex_);
    for (const auto& change : joint_list_changes_)
        if (change->from() == from && change->to() == to) return change;
    auto change = std::make_shared<JointListChange>(from, to);
    if (joint_list_changes_.size() == joint_list_changes_retained) joint_list_changes_.pop_front();
    joint_list_changes_.push_back(change);
    return change;
}

SharedBytes BroadcastCache::world_stats(const FramePtr& frame, std::uint32_t clients) {
    const std::lock_guard lock(mutex_);
    if (stats_frame_ != frame || stats_clients_ != clients) {
        stats_ = share(encode_stats_field(*frame, clients));
        stats_frame_ = frame;
        stats_clients_ = clients;
    }
    return stats_;
}

SharedBytes BroadcastCache::events(const std::shared_ptr<const TickEvents>& tick) {
    const std::lock_guard lock(mutex_);
    const auto known =
        std::ranges::find(events_, tick, [](const auto& entry) { return entry.first; });
    if (known != events_.end()) return known->second;
    SharedBytes bytes = share(encode_shared_events(*tick));
    if (events_.size() == RecentEvents::ticks_max) events_.pop_front();
    events_.emplace_back(tick, bytes);
    return bytes;
}

std::shared_ptr<BroadcastCache> BroadcastCaches::cache_for(const std::shared_ptr<WorldHost>& host,
                                                           double interest_cell_m) {
    const std::lock_guard lock(mutex_);
    ASSERT(host != nullptr);
    std::erase_if(caches_, [](const auto& entry) { return entry.second.expired(); });
    std::weak_ptr<BroadcastCache>& known = caches_[host.get()];
    std::shared_ptr<BroadcastCache> broadcast = known.lock();
    if (!broadcast) {
        broadcast = std::make_shared<BroadcastCache>(host, interest_cell_m);
        known = broadcast;
    }
    return broadcast;
}

}  // namespace jostle::server
