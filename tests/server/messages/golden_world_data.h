// SPDX-License-Identifier: MIT
//
// The content of proto/golden/world_data.jdat: what a client with the role builder and the id 3
// receives about players, attributes and user messages.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "server/messages/attribute_message.h"
#include "server/messages/player_message.h"

namespace jostle::server {

// The Snapshots, in order.
inline std::vector<std::string> golden_snapshots() {
    constexpr ClientId reader = 3;
    constexpr PlayerRole role = PlayerRole::builder;
    constexpr AttributeTarget world{}, player{AttributeTargetKind::player, reader},
        other{AttributeTargetKind::player, 4}, entity{AttributeTargetKind::entity, 7};
    constexpr auto owner_only = AttributeVisibility::owner, by_role = AttributeVisibility::roles;
    Players players;
    Attributes attributes;
    UserMessages messages;
    const auto set = [&](const AttributeTarget& target, ClientId owner, ClientId setter,
                         std::vector<AttributeChange> changes) {
        attributes.set(target, owner, setter, changes, {}).expect();
    };
    players.join({.client = 3, .name = "Zo\xc3\xab", .role = role, .joined_tick = 10});
    players.join({.client = 4, .name = "bob", .color = 0xff8000, .joined_tick = 12});
    const PlayerListPtr list = players.publish(12);
    set(world, 0, scene_client,
        {{"gravity", physics::Vec3{0, -9.81, 0}}, {"round", std::int64_t{3}}});
    set(player, 3, 3, {{"ready", true}, {"secret", std::string("s\xc3\xbc\xc3\x9f"), owner_only}});
    set(other, 4, 4, {{"secret", std::int64_t{1}, owner_only}, {"speed", 2.5, by_role, 1 << 3}});
    set(entity, 4, 4, {{"hp", std::int64_t{-12345678901}}, {"label", std::string("box")}});
    const AttributeTablePtr table = attributes.publish(12);
    std::vector<std::string> snapshots;
    snapshots.push_back(encode_player_list(*list, std::vector<PlayerPing>{{3, 25}}) +
                        encode_attribute_table(*table, 12, role) +
                        encode_own_attributes(*table, 12, reader, role));

    players.rename(4, "rob").expect();
    players.set_role(4, PlayerRole::owner).expect();
    players.join({.client = 5, .name = "cy", .role = PlayerRole::spectator, .joined_tick = 20});
    players.disconnect(5);
    const PlayerListPtr next = players.publish(20);
    set(other, 4, 4, {{"speed", 2.5, owner_only}});
    set(player, 3, 3, {{"ready", {}}, {"secret", std::string("open")}});
    attributes.remove(entity);
    const AttributeChanges changes = *attributes.publish(20)->recent.back();
    messages.add({.from = 4, .topic = "chat", .data = "hi"});
    messages.add({.from = 4, .topic = "chat", .data = "for bob", .to = {4}});
    messages.add({.from = scene_client, .topic = "game.start", .data = {"\x00\xff", 2}, .to = {3}});
    const RecentMessagesPtr recent = messages.publish(20);
    snapshots.push_back(
        encode_messages_missed(2) + encode_player_events(std::span(next->recent).last(4)) +
        encode_pings(std::vector<PlayerPing>{{3, 26}, {4, 140}}) +
        encode_attribute_changes(changes, role) +
        encode_own_attribute_changes(changes, reader, role) +
        encode_user_message(*recent->messages[0]) + encode_user_message(*recent->messages[2]));

    players.leave(5);
    snapshots.push_back(encode_player_events(std::span(players.publish(30)->recent).last(1)));
    return snapshots;
}

// All numbers are little-endian: "JDAT", u32 version, u32 number of snapshots, then the length
// (u32) and the bytes of each.
inline std::string golden_world_data() {
    const auto number = [](std::size_t value) {
        std::string bytes;
        for (int k = 0; k < 4; k++) bytes += static_cast<char>(value >> (8 * k));
        return bytes;
    };
    const std::vector<std::string> snapshots = golden_snapshots();
    std::string file = "JDAT" + number(1) + number(snapshots.size());
    for (const std::string& snapshot : snapshots) file += number(snapshot.size()) + snapshot;
    return file;
}

}  // namespace jostle::server
