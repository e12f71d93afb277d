// SPDX-License-Identifier: MIT
#include "protocol/world_feed.h"

#include <algorithm>
#include <span>

#include "protocol/event_message.h"
#include "protocol/server_message.h"

namespace jostle::server {

namespace {

// Keeps a message well below what transports and clients take by default (4 MiB).
constexpr std::size_t entities_per_message = 2000;
// Clients that lag by a few changes still share; what lags further is written for it alone.
constexpr std::size_t entity_list_changes_kept = 16;

SharedBytes share(std::string bytes) {
    return std::make_shared<const std::string>(std::move(bytes));
}

struct Difference {
    EntityList added;
    std::vector<EntityId> removed;
};

// Both entity lists are in rising order of id, and an entity never changes.
Difference difference_of(const EntityList& from, const EntityList& to) {
    Difference difference;
    std::size_t i = 0, j = 0;
    while (i < from.size() || j < to.size()) {
        if (j == to.size() || (i < from.size() && from[i]->id < to[j]->id)) {
            difference.removed.push_back(from[i++]->id);
        } else if (i == from.size() || to[j]->id < from[i]->id) {
            difference.added.push_back(to[j++]);
        } else {
            ++i, ++j;
        }
    }
    return difference;
}

std::vector<SharedBytes> messages_of(const Difference& difference) {
    std::vector<SharedBytes> messages;
    if (!difference.removed.empty())
        messages.push_back(share(encode_roster({}, difference.removed)));
    const std::span<const std::shared_ptr<const EntityDescription>> added = difference.added;
    for (std::size_t first = 0; first < added.size(); first += entities_per_message) {
        const std::size_t count = std::min(entities_per_message, added.size() - first);
        messages.push_back(share(encode_roster(added.subspan(first, count), {})));
    }
    return messages;
}

}  // namespace

WorldFeed::WorldFeed(std::shared_ptr<WorldHost> host)
    : host_(std::move(host)), snapshots_(wire::QuantSpec{}, encode_shared_snapshot) {}

std::vector<SharedBytes> WorldFeed::entity_list_change(
    const std::shared_ptr<const EntityList>& from, const std::shared_ptr<const EntityList>& to) {
    const std::lock_guard lock(mutex_);
    for (const EntityListChange& change : entity_list_changes_) {
        if (change.from == from && change.to == to) return change.messages;
    }
    static const EntityList nothing;
    std::vector<SharedBytes> messages = messages_of(difference_of(from ? *from : nothing, *to));
    if (entity_list_changes_.size() == entity_list_changes_kept)
        entity_list_changes_.erase(entity_list_changes_.begin());
    entity_list_changes_.push_back({from, to, messages});
    return messages;
}

SharedBytes WorldFeed::world_stats(const FramePtr& frame, std::uint32_t clients) {
    const std::lock_guard lock(mutex_);
    if (stats_frame_ != frame || stats_clients_ != clients) {
        stats_ = share(encode_world_stats(*frame, clients));
        stats_frame_ = frame;
        stats_clients_ = clients;
    }
    return stats_;
}

SharedBytes WorldFeed::events(const std::shared_ptr<const TickEvents>& tick) {
    const std::lock_guard lock(mutex_);
    const auto known =
        std::ranges::find(events_, tick, [](const auto& entry) { return entry.first; });
    if (known != events_.end()) return known->second;
    SharedBytes bytes = share(encode_shared_events(*tick));
    if (events_.size() == RecentEvents::ticks_max) events_.pop_front();
    events_.emplace_back(tick, bytes);
    return bytes;
}

std::shared_ptr<WorldFeed> WorldFeeds::feed_of(const std::shared_ptr<WorldHost>& host) {
    const std::lock_guard lock(mutex_);
    std::erase_if(feeds_, [](const auto& entry) { return entry.second.expired(); });
    std::weak_ptr<WorldFeed>& known = feeds_[host.get()];
    std::shared_ptr<WorldFeed> feed = known.lock();
    if (!feed) {
        feed = std::make_shared<WorldFeed>(host);
        known = feed;
    }
    return feed;
}

}  // namespace jostle::server
