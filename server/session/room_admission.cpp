// SPDX-License-Identifier: MIT
#include "server/session/room_admission.h"

#include <spdlog/fmt/fmt.h>

#include "server/util/address.h"
#include "server/util/text.h"

namespace jostle::server {
namespace {

// Anonymous callers are administrators of a server without keys; in a room they are all alike.
bool is_admin(const Identity& who) {
    return who.role >= Role::admin && !who.anonymous;
}

bool is_owner_or_admin(const RoomState& room, const Identity& who, std::string_view address) {
    return is_admin(who) || (!room.owner.empty() && room.owner == member_of(who, address));
}

}  // namespace

std::string member_of(const Identity& who, std::string_view address) {
    return who.anonymous ? std::string(network_member) + network_of(address)
                         : std::string(subject_member) + who.subject;
}

EnterRoom room_entry(const Identity& who, std::string_view address, bool spectator) {
    return {.member = member_of(who, address), .spectator = spectator, .admin = is_admin(who)};
}

Status check_room_access(const WorldHost& world, const Identity& who, std::string_view address,
                         std::string_view join_code, bool has_ticket) {
    if (!world.properties().is_room) return {};
    const RoomView room = world.frame()->room;
    if (is_owner_or_admin(*room, who, address)) return {};
    if (const RoomBan* const ban = room->ban_of(member_of(who, address)))
        return Error{ErrorCode::permission_denied,
                     fmt::format("the room {} has banned the caller{}", in_quotes(world.name()),
                                 ban->reason.empty() ? "" : ": " + ban->reason)};
    const std::string& expected = room->properties.join_code;
    if (expected.empty() || has_ticket || join_code == expected) return {};
    return Error{ErrorCode::permission_denied,
                 fmt::format("join_code: the room {} is private, and the join code is {}",
                             in_quotes(world.name()), join_code.empty() ? "missing" : "wrong")};
}

std::uint32_t room_capacity(const WorldHost& world, const Identity& who, std::string_view address) {
    if (!world.properties().is_room) return 0;
    const RoomView room = world.frame()->room;
    return is_owner_or_admin(*room, who, address) ? 0 : room->properties.capacity;
}

Status check_room_capacity(const WorldHost& world, const SessionDirectory& sessions,
                           const Identity& who, std::string_view address) {
    const std::uint32_t capacity = room_capacity(world, who, address);
    if (capacity == 0 || sessions.clients_in(world.id()) < static_cast<int>(capacity)) return {};
    return Error{ErrorCode::resource_exhausted,
                 fmt::format("the room {} is full: {} clients", in_quotes(world.name()), capacity)};
}

}  // namespace jostle::server
