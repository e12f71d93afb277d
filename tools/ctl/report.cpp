// SPDX-License-Identifier: MIT
#include "tools/ctl/report.h"

#include <google/protobuf/util/json_util.h>

#include "jostle/base/format_text.h"
#include "tools/common/table.h"
#include "tools/ctl/attribute_arguments.h"

namespace jostle::ctl {

using common::Align, common::Table, common::duration_text, common::number_text, common::sanitized;

namespace {

std::string clients_of(const v1::WorldInfo& world) {
    const std::string clients = std::to_string(world.clients());
    if (world.room().capacity() == 0) return clients;
    return clients + "/" + std::to_string(world.room().capacity());
}

std::string room_of(const v1::WorldInfo& world) {
    if (!world.has_room()) return "-";
    const v1::RoomInfo& room = world.room();
    return (room.title().empty() ? "untitled" : sanitized(room.title(), 40)) +
           (room.is_private() ? ", private" : "") + (room.unlisted() ? ", unlisted" : "");
}

}  // namespace

std::string room_text(const v1::GetRoomResponse& room) {
    std::string text = "title  " + sanitized(room.settings().title()) + "\nowner  " +
                       (room.owner().empty() ? "the player that is present for longest"
                                             : sanitized(room.owner())) +
                       "\n";
    for (const auto& area : room.settings().areas())
        text += "area   " + sanitized(area.name()) + ", for the role " + area.min_role() + "\n";
    for (const v1::RoomBan& ban : room.bans())
        text += "ban    " + sanitized(ban.member()) + (ban.permanent() ? "" : ", for a time") +
                (ban.reason().empty() ? "" : ": " + sanitized(ban.reason(), 100)) + "\n";
    if (room.vote_target() != 0)
        text += "vote   to kick client " + std::to_string(room.vote_target()) + ": " +
                std::to_string(room.votes()) + " votes\n";
    if (room.members().empty()) return text + "The room has no clients.\n";
    Table table({{"CLIENT", Align::right}, {"ROLE"}, {"MEMBER"}, {"STATE"}});
    for (const v1::RoomMember& member : room.members())
        table.add({std::to_string(member.client()), role_text(member.role()),
                   sanitized(member.member(), 100),
                   member.removed() ? "removed"
                   : member.muted() ? "muted"
                                    : "-"});
    return text + table.text();
}

std::string worlds_text(const v1::ListWorldsResponse& worlds) {
    if (worlds.worlds().empty())
        return "The server has no worlds. Create one with jostlectl world create.\n";
    Table table({{"ID"},
                 {"NAME"},
                 {"SCENE"},
                 {"HZ", Align::right},
                 {"BODIES", Align::right},
                 {"AWAKE", Align::right},
                 {"CLIENTS", Align::right},
                 {"ROOM"},
                 {"MS", Align::right},
                 {"TIME SCALE", Align::right},
                 {"STATE"}});
    for (const v1::WorldInfo& world : worlds.worlds())
        table.add({world.id(), sanitized(world.name()), sanitized(world.scene()),
                   number_text(world.hz(), 0), std::to_string(world.bodies()),
                   std::to_string(world.awake()), clients_of(world), room_of(world),
                   number_text(world.step_ms_mean(), 2), number_text(world.time_scale(), 2),
                   world.paused().empty() ? "runs" : "paused: " + sanitized(world.paused(), 60)});
    return table.text();
}

std::string clients_text(const v1::ListClientsResponse& clients) {
    if (clients.clients().empty()) return "No clients are connected.\n";
    Table table({{"ID", Align::right},
                 {"NAME"},
                 {"SUBJECT"},
                 {"WORLD"},
                 {"ADDRESS"},
                 {"FOR"},
                 {"KBIT/S", Align::right},
                 {"SKIPPED", Align::right},
                 {"RTT MS", Align::right}});
    for (const v1::ClientInfo& client : clients.clients())
        table.add({std::to_string(client.id()),
                   sanitized(client.name()) + (client.spectator() ? " (watches)" : ""),
                   client.subject().empty() ? "-" : sanitized(client.subject()),
                   sanitized(client.world_name()), sanitized(client.address(), 60),
                   duration_text(client.connected_seconds()),
                   number_text(client.kbit_per_second(), 1),
                   std::to_string(client.snapshots_skipped()),
                   client.round_trip_ms() > 0 ? number_text(client.round_trip_ms(), 1) : "-"});
    return table.text();
}

std::string reports_text(const v1::ListReportsResponse& reports) {
    if (reports.reports().empty()) return "There are no reports of players.\n";
    Table table({{"WORLD"}, {"TICK", Align::right}, {"TIME"}, {"FROM"}, {"ABOUT"}, {"REASON"}});
    const auto client_text = [](std::uint32_t client, const std::string& name) {
        if (client == 0) return std::string("-");
        return std::to_string(client) + " " + sanitized(name);
    };
    for (const v1::ReportInfo& report : reports.reports()) {
        std::string reason = sanitized(report.reason(), 100);
        for (const std::string& message : report.messages())
            reason += "  \"" + sanitized(message, 60) + "\"";
        table.add({sanitized(report.world_name()), std::to_string(report.tick()), report.time(),
                   client_text(report.from(), report.from_name()),
                   client_text(report.client(), report.name()), reason});
    }
    return table.text();
}

std::string players_text(const v1::ListPlayersResponse& players) {
    if (players.players().empty()) return "The world has no players.\n";
    Table table({{"ID", Align::right},
                 {"NAME"},
                 {"ROLE"},
                 {"COLOR"},
                 {"SINCE TICK", Align::right},
                 {"PING MS", Align::right},
                 {"STATE"}});
    for (const v1::Player& player : players.players())
        table.add({std::to_string(player.client()), sanitized(player.name()),
                   role_text(player.role()),
                   player.has_color() ? format_text("%06x", player.color()) : "-",
                   std::to_string(player.joined_tick()),
                   player.ping_ms() > 0 ? std::to_string(player.ping_ms()) : "-",
                   player.disconnected() ? "disconnected" : "connected"});
    return table.text();
}

std::string attributes_text(const v1::GetAttributesResponse& attributes) {
    if (attributes.sets().empty()) return "There are no attributes.\n";
    Table table({{"TARGET"}, {"KEY"}, {"VALUE"}, {"VISIBLE TO"}, {"SET BY"}});
    for (const v1::AttributeSet& set : attributes.sets())
        for (const v1::Attribute& attribute : set.attributes())
            table.add({target_text(set), sanitized(attribute.key()),
                       sanitized(value_text(attribute), 80), visibility_text(attribute),
                       attribute.read_only() ? "server" : "client"});
    return table.text();
}

std::string bans_text(const v1::ListBansResponse& bans) {
    const std::string note =
        bans.persisted() ? "" : "The server has no database: bans end when it stops.\n";
    if (bans.bans().empty()) return "There are no bans.\n" + note;
    Table table({{"SUBJECT"}, {"NETWORK"}, {"UNTIL"}, {"BY"}, {"REASON"}});
    for (const v1::BanInfo& ban : bans.bans())
        table.add({ban.subject().empty() ? "-" : sanitized(ban.subject()),
                   ban.network().empty() ? "-" : ban.network(),
                   ban.expires().empty() ? "unban" : ban.expires(), sanitized(ban.by()),
                   sanitized(ban.reason(), 100)});
    return table.text() + note;
}

std::string json_text(const google::protobuf::Message& message) {
    google::protobuf::util::JsonPrintOptions options;
    options.add_whitespace = true;
    options.always_print_primitive_fields = true;
    std::string text;
    // Only invalid UTF-8 cannot be converted, and received messages contain none.
    if (!google::protobuf::util::MessageToJsonString(message, &text, options).ok()) return "{}\n";
    return text;
}

}  // namespace jostle::ctl
