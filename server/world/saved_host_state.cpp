// SPDX-License-Identifier: MIT
#include "server/world/saved_host_state.h"

#include <utility>

#include "server/util/bytes.h"
#include "server/world/room_codec.h"

namespace jostle::server {
namespace {

// Version 3 adds the room. States without a room are written in version 1, which older servers
// read.
constexpr std::uint64_t version_without_room = 1, version_of_rooms = 3;
constexpr std::uint32_t no_color = 0xffffffff;  // colours have 24 bits

// visit() lists the fields once; the writer and the reader are its visitors.
struct HostStateWriter {
    ByteWriter to;

    void operator()(std::uint32_t value) { to.number(value); }
    void operator()(double value) { to.real(value); }
    void operator()(const std::string& value) { to.text(value); }
    void operator()(const std::optional<std::uint32_t>& value) {
        to.number(value.value_or(no_color));
    }
    template <class Item, class Each>
    void list(const std::vector<Item>& items, Each&& each) {
        to.number(items.size());
        for (const Item& item : items) each(item);
    }
};
struct HostStateReader {
    ByteReader from;

    void operator()(std::uint32_t& value) { value = from.small(); }
    void operator()(double& value) { value = from.real(); }
    void operator()(std::string& value) { value = from.text(); }
    void operator()(std::optional<std::uint32_t>& value) {
        const std::uint32_t color = from.small();
        value = color == no_color ? std::nullopt : std::optional(color);
    }
    template <class Item, class Each>
    void list(std::vector<Item>& items, Each&& each) {
        items.resize(from.count());
        for (Item& item : items) each(item);
    }
};

template <class Visitor, class Id>
void visit_id(Visitor& v, Id& id) {
    v(id.index);
    v(id.generation);
}

template <class Visitor, class HostState>
void visit(Visitor& v, HostState& host_state) {
    v(host_state.tick);
    v(host_state.next_id);
    v.list(host_state.entities, [&](auto& e) {
        v(e.id);
        visit_id(v, e.body);
        v(e.owner);
        v(e.color);
        v(e.name);
        v(e.mass);
        v(e.bounding_radius);
    });
    v.list(host_state.owned, [&](auto& o) { v(o.client), v(o.entity); });
    v.list(host_state.held, [&](auto& h) {
        v(h.client);
        visit_id(v, h.body);
        visit_id(v, h.joint);
    });
    v.list(host_state.controlled_entities, [&](auto& d) { v(d.client), visit_id(v, d.body); });
    v.list(host_state.processed, [&](auto& c) { v(c.client), v(c.sequence); });
    v.list(host_state.quarantined, [&](auto& id) { v(id); });
    v.list(host_state.scene_bodies, [&](auto& id) { visit_id(v, id); });
    v.list(host_state.scene_joints, [&](auto& id) { visit_id(v, id); });
}

Error corrupt_host_state(const std::string& fault) {
    return {ErrorCode::corrupt_data, "corrupt host state: " + fault};
}

}  // namespace

std::map<ClientId, std::uint32_t> clients_of(const SavedHostState& host_state) {
    std::map<ClientId, std::uint32_t> clients;
    for (const SavedHostState::ProcessedInput& input : host_state.processed)
        clients[input.client] = input.sequence;
    for (const SavedHostState::Owned& owned : host_state.owned) clients.try_emplace(owned.client);
    for (const SavedHostState::Held& held : host_state.held) clients.try_emplace(held.client);
    for (const SavedHostState::Controlled& controlled : host_state.controlled_entities)
        clients.try_emplace(controlled.client);
    if (host_state.room)
        for (const RoomClient& client : host_state.room->clients)
            clients.try_emplace(client.client);
    clients.erase(0);
    return clients;
}

std::string encode_host_state(const SavedHostState& host_state) {
    HostStateWriter writer;
    writer.to.number(host_state.room ? version_of_rooms : version_without_room);
    visit(writer, host_state);
    if (host_state.room) writer.to.text(encode_room(*host_state.room));
    return writer.to.take();
}

Result<SavedHostState> decode_host_state(std::string_view bytes) {
    HostStateReader reader{ByteReader(bytes)};
    const std::uint64_t version = reader.from.number();
    if (reader.from.ok() && version != version_without_room && version != version_of_rooms)
        return Error{ErrorCode::failed_precondition,
                     "unsupported host state: version " + std::to_string(version) +
                         "; this server reads versions " + std::to_string(version_without_room) +
                         " and " + std::to_string(version_of_rooms)};
    SavedHostState host_state;
    visit(reader, host_state);
    if (version == version_of_rooms) {
        Result<RoomState> room = decode_room(reader.from.text());
        if (!reader.from.ok()) return corrupt_host_state("truncated");
        if (!room.ok()) return room.error();
        host_state.room = *std::move(room);
    }
    if (!reader.from.ok()) return corrupt_host_state("truncated");
    if (!reader.from.at_end()) return corrupt_host_state("trailing bytes");
    EntityId last = 0;
    for (const SavedHostState::Entity& entity : host_state.entities) {
        if (entity.id <= last || entity.id >= host_state.next_id)
            return corrupt_host_state("entity " + std::to_string(entity.id) +
                                      " is out of order; ids must ascend from 1 and be below " +
                                      std::to_string(host_state.next_id));
        last = entity.id;
    }
    return host_state;
}

}  // namespace jostle::server
