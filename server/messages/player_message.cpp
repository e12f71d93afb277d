// SPDX-License-Identifier: MIT
#include "server/messages/player_message.h"

#include <algorithm>

namespace jostle::server {

void write_player(v1::Player& to, const Player& player, std::uint32_t ping_ms) {
    to.set_client(player.client);
    to.set_name(player.name);
    to.set_role(static_cast<v1::PlayerRole>(player.role));
    if (player.color) to.set_color(*player.color);
    to.set_disconnected(!player.connected);
    to.set_joined_tick(player.joined_tick);
    to.set_ping_ms(ping_ms);
}

std::string encode_player_list(const PlayerList& list, std::span<const PlayerPing> pings) {
    v1::Snapshot fields;
    v1::PlayerUpdate& update = *fields.add_players();
    update.set_complete(true);
    for (const PlayerPtr& player : list.players) {
        const auto ping = std::ranges::lower_bound(pings, player->client, {}, &PlayerPing::client);
        const bool is_known = ping != pings.end() && ping->client == player->client;
        write_player(*update.add_players(), *player, is_known ? ping->ping_ms : 0);
    }
    return fields.SerializeAsString();
}

std::string encode_player_events(std::span<const PlayerEvent> events) {
    v1::Snapshot fields;
    v1::PlayerUpdate& update = *fields.add_players();
    for (const PlayerEvent& event : events) {
        v1::PlayerEvent& to = *update.add_events();
        to.set_tick(event.tick);
        to.set_kind(static_cast<v1::PlayerEventKind>(event.kind));
        write_player(*to.mutable_player(), *event.player, 0);
    }
    return fields.SerializeAsString();
}

std::string encode_pings(std::span<const PlayerPing> pings) {
    v1::Snapshot fields;
    v1::PlayerUpdate& update = *fields.add_players();
    for (const PlayerPing& ping : pings) {
        v1::PlayerPing& to = *update.add_pings();
        to.set_client(ping.client);
        to.set_ping_ms(ping.ping_ms);
    }
    return fields.SerializeAsString();
}

std::string encode_user_message(const UserMessage& message) {
    v1::Snapshot fields;
    v1::UserMessage& to = *fields.add_messages();
    to.set_number(message.number);
    to.set_tick(message.tick);
    to.set_from(message.from);
    to.set_topic(message.topic);
    to.set_data(message.data);
    to.set_direct(!message.to.empty());
    return fields.SerializeAsString();
}

std::string encode_messages_missed(std::uint32_t missed) {
    v1::Snapshot fields;
    fields.set_messages_missed(missed);
    return fields.SerializeAsString();
}

}  // namespace jostle::server
