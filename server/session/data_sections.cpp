// SPDX-License-Identifier: MIT
#include "server/session/data_sections.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "jostle/base/check.h"
#include "server/messages/attribute_message.h"

namespace jostle::server {

void PlayersSection::append(const FramePtr& frame, Clock::time_point now, SnapshotParts& parts) {
    SharedData& shared = broadcast_.data();
    const PlayerListPtr& list = frame->players;
    const SharedBytes pings = shared.pings(clients_, broadcast_.host().id(), now);
    const bool has_events = revision_ && list->revision - *revision_ <= list->recent.size();
    if (has_events && revision_ != list->revision)
        parts.shared_fields.push_back(shared.player_events(list, *revision_));
    if (!has_events || sends_complete_) parts.shared_fields.push_back(shared.player_list(list));
    revision_ = list->revision;
    sends_complete_ = false;
    if (pings && pings != pings_) parts.shared_fields.push_back(pings_ = pings);
}

PlayerRole AttributesSection::role_in(const Frame& frame) const {
    const Player* const player = frame.players->find(client_);
    return player ? player->role : initial_;
}

void AttributesSection::append(const FramePtr& frame, Clock::time_point, SnapshotParts& parts) {
    const AttributeTable& table = *frame->attributes;
    const bool changes_role = is_role_changed(*frame);
    if (players_ != frame->players) {
        role_ = role_in(*frame);
        players_ = frame->players;
    }
    const bool has_changes =
        revision_ && !changes_role && table.revision - *revision_ <= table.recent.size();
    if (!has_changes) return append_table(*frame, parts);
    std::size_t bytes = 0;
    while (*revision_ != table.revision && bytes < bytes_max) {
        const auto& changes = table.recent[table.recent.size() - (table.revision - *revision_)];
        if (SharedBytes shared = broadcast_.data().attribute_changes(changes, role_)) {
            bytes += shared->size();
            parts.shared_fields.push_back(std::move(shared));
        }
        ++*revision_;
        if (!changes->has_owner_only) continue;
        if (std::string own = encode_own_attribute_changes(*changes, client_, role_); !own.empty())
            parts.shared_fields.push_back(std::make_shared<const std::string>(std::move(own)));
    }
}

void AttributesSection::append_table(const Frame& frame, SnapshotParts& parts) {
    revision_ = frame.attributes->revision;
    if (frame.attributes->buckets.empty() && !has_table_) return;
    has_table_ = true;
    parts.shared_fields.push_back(
        broadcast_.data().attribute_table(frame.attributes, frame.tick, role_));
    if (std::string own = encode_own_attributes(*frame.attributes, frame.tick, client_, role_);
        !own.empty())
        parts.shared_fields.push_back(std::make_shared<const std::string>(std::move(own)));
}

void RoomSection::append(const FramePtr& frame, Clock::time_point, SnapshotParts& parts) {
    if (frame->room == room_) return;
    room_ = frame->room;
    const RoomClient* const client = room_ ? room_->find(client_) : nullptr;
    if (!client) return;
    SharedBytes bytes = broadcast_.data().room(room_, client->role);
    if (bytes == sent_) return;
    sent_ = bytes;
    parts.shared_fields.push_back(std::move(bytes));
}

MessagesSection::MessagesSection(BroadcastCache& broadcast, ClientId client,
                                 std::vector<std::string> topics)
    : broadcast_(broadcast),
      client_(client),
      topics_(std::move(topics)),
      all_topics_(std::ranges::find(topics_, "*") != topics_.end()) {}

bool MessagesSection::is_wanted(const UserMessage& message) const {
    return message.is_for(client_) &&
           (all_topics_ || std::ranges::find(topics_, message.topic) != topics_.end());
}

void MessagesSection::append(const FramePtr& frame, Clock::time_point, SnapshotParts& parts) {
    const auto& [count, messages] = *frame->messages;
    if (cursor_ >= count) return;
    const std::uint32_t dropped = count - static_cast<std::uint32_t>(messages.size());
    if (cursor_ < dropped) {
        parts.fields += encode_messages_missed(dropped - cursor_);
        cursor_ = dropped;
    }
    std::size_t bytes = 0;
    while (cursor_ < count && bytes < bytes_max) {
        const UserMessagePtr& message = messages[cursor_++ - dropped];
        if (!is_wanted(*message)) continue;
        SharedBytes shared = broadcast_.data().message(message);
        bytes += shared->size();
        parts.shared_fields.push_back(std::move(shared));
    }
}

}  // namespace jostle::server
