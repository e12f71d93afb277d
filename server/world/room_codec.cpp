// SPDX-License-Identifier: MIT
#include "server/world/room_codec.h"

#include <type_traits>
#include <utility>
#include <variant>

#include "server/util/bytes.h"

namespace jostle::server {
namespace {

constexpr std::uint64_t room_version = 2;

// visit() lists the fields of each structure once; the writer and the reader are its visitors.
struct Writer {
    ByteWriter to;

    void operator()(std::uint32_t value) { to.number(value); }
    void operator()(std::uint64_t value) { to.number(value); }
    void operator()(bool value) { to.number(value ? 1 : 0); }
    void operator()(double value) { to.real(value); }
    void operator()(const std::string& value) { to.text(value); }
    // `values`: number of enumerators.
    template <class Enum>
    void choice(Enum value, std::size_t) {
        to.number(static_cast<std::uint64_t>(value));
    }
    template <class Item, class Each>
    void list(const std::vector<Item>& items, Each&& each) {
        to.number(items.size());
        for (const Item& item : items) each(item);
    }
    template <class Item, class Each>
    void maybe(const std::optional<Item>& item, Each&& each) {
        (*this)(item.has_value());
        if (item) each(*item);
    }
};
struct Reader {
    ByteReader from;
    bool in_range = true;

    void operator()(std::uint32_t& value) { value = from.small(); }
    void operator()(std::uint64_t& value) { value = from.number(); }
    void operator()(bool& value) {
        const std::uint64_t number = from.number();
        in_range = in_range && number <= 1;
        value = number != 0;
    }
    void operator()(double& value) { value = from.real(); }
    void operator()(std::string& value) { value = from.text(); }
    template <class Enum>
    void choice(Enum& value, std::size_t values) {
        const std::uint64_t number = from.number();
        in_range = in_range && number < values;
        value = static_cast<Enum>(number < values ? number : 0);
    }
    template <class Item, class Each>
    void list(std::vector<Item>& items, Each&& each) {
        items.resize(from.count());
        for (Item& item : items) each(item);
    }
    template <class Item, class Each>
    void maybe(std::optional<Item>& item, Each&& each) {
        bool present = false;
        (*this)(present);
        if (present) each(item.emplace());
    }

    bool is_complete() const { return from.ok() && from.at_end() && in_range; }
};

template <class Visitor, class Area>
void visit_area(Visitor& v, Area& area) {
    v(area.name);
    v(area.min.x), v(area.min.y), v(area.min.z);
    v(area.max.x), v(area.max.y), v(area.max.z);
    v.choice(area.min_role, player_roles);
}

template <class Visitor, class Properties>
void visit_properties(Visitor& v, Properties& p) {
    v(p.title), v(p.description);
    v.list(p.tags, [&](auto& tag) { v(tag); });
    v(p.capacity), v(p.join_code), v(p.unlisted), v(p.close_when_empty);
    v.choice(p.initial_role, player_roles);
    for (auto& row : p.permissions.reach)
        for (auto& reach : row) v.choice(reach, reaches);
    for (auto& quotas : p.quotas)
        v(quotas.bodies), v(quotas.joints), v(quotas.energy_per_second),
            v(quotas.explosions_per_minute);
    v.list(p.areas, [&](auto& area) { visit_area(v, area); });
    v(p.timeline_seconds);
}

template <class Visitor, class State>
void visit_state(Visitor& v, State& state) {
    const auto bucket = [&](auto& b) { v(b.level), v(b.step); };
    visit_properties(v, state.properties);
    v(state.owner), v(state.step), v(state.entered);
    v.list(state.clients, [&](auto& c) {
        v(c.client);
        v.choice(c.role, player_roles);
        v(c.member), v(c.spectator), v(c.entered), v(c.muted_until), v(c.vote_after);
        bucket(c.energy), bucket(c.explosions);
        v(c.removed), v(c.removed_reason);
    });
    v.list(state.bans, [&](auto& ban) { v(ban.member), v(ban.until), v(ban.reason); });
    v.list(state.grants, [&](auto& g) { v(g.member), v.choice(g.role, player_roles); });
    v.maybe(state.vote, [&](auto& vote) {
        v(vote.target), v(vote.until);
        v.list(vote.clients, [&](auto& client) { v(client); });
    });
}

template <class Visitor, class Command>
void visit_command(Visitor& v, Command& c) {
    using Kind = std::remove_const_t<Command>;
    if constexpr (std::is_same_v<Kind, EnterRoom>) {
        v(c.member), v(c.spectator), v(c.admin);
    } else if constexpr (std::is_same_v<Kind, SetRole>) {
        v(c.client), v.choice(c.role, player_roles);
    } else if constexpr (std::is_same_v<Kind, KickClient>) {
        v(c.client), v(c.reason);
    } else if constexpr (std::is_same_v<Kind, BanClient>) {
        v(c.client), v(c.seconds), v(c.reason);
    } else if constexpr (std::is_same_v<Kind, UnbanMember>) {
        v(c.member);
    } else if constexpr (std::is_same_v<Kind, MuteClient>) {
        v(c.client), v(c.seconds);
    } else if constexpr (std::is_same_v<Kind, CleanUpBodies> || std::is_same_v<Kind, VoteToKick>) {
        v(c.client);
    } else if constexpr (std::is_same_v<Kind, ProtectArea>) {
        visit_area(v, c.area);
    } else if constexpr (std::is_same_v<Kind, UnprotectArea>) {
        v(c.name);
    } else if constexpr (std::is_same_v<Kind, PauseRoom>) {
        v(c.paused);
    } else if constexpr (std::is_same_v<Kind, UpdateRoom>) {
        auto properties = *c.properties;
        visit_properties(v, properties);
        if constexpr (!std::is_const_v<Command>)
            c.properties = std::make_shared<const RoomProperties>(std::move(properties));
    } else if constexpr (std::is_same_v<Kind, StepRoom>) {
        v(c.steps);
    } else if constexpr (std::is_same_v<Kind, SetRoomSpeed>) {
        v(c.percent);
    } else if constexpr (std::is_same_v<Kind, RewindRoom>) {
        v(c.tick);
    } else {
        static_assert(std::is_same_v<Kind, ResetRoom>);
    }
}

using Kinds = decltype(RoomCommand::kind);

// The number of a kind is its index in RoomCommand: append new kinds at the end.
template <std::size_t index = 0>
bool make_kind(std::uint64_t number, Kinds& kind) {
    if constexpr (index < std::variant_size_v<Kinds>) {
        if (number != index) return make_kind<index + 1>(number, kind);
        kind.emplace<index>();
        return true;
    } else {
        return false;
    }
}

// What the rest of the server assumes about a room.
bool is_consistent(const RoomState& room) {
    std::uint32_t last = 0;
    for (const RoomClient& client : room.clients) {
        if (client.client <= last || client.role == PlayerRole::unspecified ||
            client.energy.step > room.step || client.explosions.step > room.step)
            return false;
        last = client.client;
    }
    return (!room.vote || room.find(room.vote->target)) && check_properties(room.properties).ok();
}

}  // namespace

std::string encode_room(const RoomState& room) {
    Writer writer;
    writer.to.number(room_version);
    visit_state(writer, room);
    return writer.to.take();
}

Result<RoomState> decode_room(std::string_view bytes) {
    Reader reader{ByteReader(bytes)};
    if (const std::uint64_t version = reader.from.number();
        reader.from.ok() && version != room_version)
        return Error{ErrorCode::failed_precondition,
                     "unsupported room: version " + std::to_string(version) +
                         "; this server reads version " + std::to_string(room_version)};
    RoomState room;
    visit_state(reader, room);
    if (!reader.is_complete() || !is_consistent(room))
        return Error{ErrorCode::corrupt_data, "corrupt room"};
    return room;
}

std::string encode_room_command(const RoomCommand& command) {
    Writer writer;
    writer.to.number(command.kind.index());
    std::visit([&](const auto& kind) { visit_command(writer, kind); }, command.kind);
    return writer.to.take();
}

Result<RoomCommand> decode_room_command(std::string_view bytes) {
    Reader reader{ByteReader(bytes)};
    RoomCommand command;
    const std::uint64_t number = reader.from.number();
    const bool is_known = make_kind(number, command.kind);
    if (is_known) std::visit([&](auto& kind) { visit_command(reader, kind); }, command.kind);
    if (!is_known || !reader.is_complete() || !check_room_command(command).ok())
        return Error{ErrorCode::corrupt_data,
                     "corrupt room command of kind " + std::to_string(number)};
    return command;
}

}  // namespace jostle::server
