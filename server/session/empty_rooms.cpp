// SPDX-License-Identifier: MIT
#include "server/session/empty_rooms.h"

#include "server/util/log.h"

namespace jostle::server {

void EmptyRooms::close(PlayContext& context, Clock::time_point now) {
    std::map<std::string, Clock::time_point> empty;
    for (const auto& world : context.worlds.list()) {
        if (!world->properties().is_room) continue;
        const RoomView room = world->frame()->room;
        if (!room->properties.close_when_empty || context.sessions.clients_in(world->id()) > 0)
            continue;
        const auto before = empty_since_.find(world->id());
        const Clock::time_point since = before == empty_since_.end() ? now : before->second;
        if (now - since < (room->entered > 0 ? empty_time : first_client_time)) {
            empty[world->id()] = since;
            continue;
        }
        log_info("world {} \"{}\" is closed because it is empty", world->id(), world->name());
        context.worlds.remove(world->id());
    }
    empty_since_ = std::move(empty);
}

}  // namespace jostle::server
