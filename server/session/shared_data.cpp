// SPDX-License-Identifier: MIT
#include "server/session/shared_data.h"

#include <algorithm>
#include <string>

#include "jostle/base/check.h"
#include "server/messages/attribute_message.h"
#include "server/messages/room_message.h"

namespace jostle::server {

namespace {

constexpr std::size_t events_retained = 16;
constexpr auto ping_period = std::chrono::seconds(1);

SharedBytes share_if_any(std::string bytes) {
    return bytes.empty() ? nullptr : std::make_shared<const std::string>(std::move(bytes));
}

std::size_t index_of(PlayerRole role) {
    const auto index = static_cast<std::size_t>(role);
    ASSERT(index < player_roles);
    return index;
}

}  // namespace

SharedBytes SharedData::player_list(const PlayerListPtr& list) {
    const std::lock_guard lock(mutex_);
    if (list_ != list) {
        list_bytes_ = share_if_any(encode_player_list(*list, pings_));
        list_ = list;
    }
    return list_bytes_;
}

SharedBytes SharedData::player_events(const PlayerListPtr& list, std::uint32_t since) {
    const std::lock_guard lock(mutex_);
    for (const Events& known : events_)
        if (known.list == list && known.since == since) return known.bytes;
    const std::size_t count = list->revision - since;
    ASSERT(count > 0 && count <= list->recent.size());
    SharedBytes bytes = share_if_any(encode_player_events(std::span(list->recent).last(count)));
    if (events_.size() == events_retained) events_.pop_front();
    events_.push_back({list, since, bytes});
    return bytes;
}

SharedBytes SharedData::pings(const ConnectedClients& clients, const std::string& world_id,
                              Clock::time_point now) {
    const std::lock_guard lock(mutex_);
    if (pings_at_ != Clock::time_point{} && now - pings_at_ < ping_period) return pings_bytes_;
    pings_at_ = now;
    pings_.clear();
    for (const auto& [client, round_trip_s] : clients.round_trips(world_id))
        pings_.push_back({client, static_cast<std::uint32_t>(1000 * round_trip_s + 0.5)});
    pings_bytes_ = pings_.empty() ? nullptr : share_if_any(encode_pings(pings_));
    return pings_bytes_;
}

SharedBytes SharedData::attribute_table(const AttributeTablePtr& table, std::uint32_t tick,
                                        PlayerRole role) {
    const std::lock_guard lock(mutex_);
    if (table_ != table) {
        table_ = table;
        table_bytes_ = {};
    }
    SharedBytes& bytes = table_bytes_[index_of(role)];
    if (!bytes) bytes = share_if_any(encode_attribute_table(*table, tick, role));
    return bytes;
}

SharedBytes SharedData::attribute_changes(const std::shared_ptr<const AttributeChanges>& changes,
                                          PlayerRole role) {
    const std::lock_guard lock(mutex_);
    auto at = std::find_if(changes_.rbegin(), changes_.rend(),
                           [&](const Changes& known) { return known.changes == changes; });
    if (at == changes_.rend()) {
        if (changes_.size() == AttributeTable::recent_max) changes_.pop_front();
        changes_.push_back({changes, {}, {}});
        at = changes_.rbegin();
    }
    const std::size_t index = index_of(role);
    if (!std::exchange(at->is_encoded[index], true))
        at->bytes[index] = share_if_any(encode_attribute_changes(*changes, role));
    return at->bytes[index];
}

SharedBytes SharedData::message(const UserMessagePtr& message) {
    const std::lock_guard lock(mutex_);
    const auto number_of = [](const auto& entry) { return entry.first->number; };
    const auto at = std::ranges::lower_bound(messages_, message->number, {}, number_of);
    if (at != messages_.end() && at->first == message) return at->second;
    SharedBytes bytes = share_if_any(encode_user_message(*message));
    // Behind the newest ones; a client that lags further encodes alone.
    if (at == messages_.end()) {
        if (messages_.size() == RecentMessages::messages_max) messages_.pop_front();
        messages_.emplace_back(message, bytes);
    }
    return bytes;
}

SharedBytes SharedData::room(const RoomView& room, PlayerRole role) {
    const std::lock_guard lock(mutex_);
    if (room_ != room) {
        room_ = room;
        room_is_encoded_ = {};
    }
    const std::size_t index = index_of(role);
    SharedBytes& bytes = room_bytes_[index];
    if (std::exchange(room_is_encoded_[index], true)) return bytes;
    std::string encoded = encode_room_update(*room, role);
    if (!bytes || *bytes != encoded) bytes = share_if_any(std::move(encoded));
    return bytes;
}

}  // namespace jostle::server
