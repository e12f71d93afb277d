// SPDX-License-Identifier: MIT
#include "server/world/saved_host_state.h"

#include <utility>
#include <variant>

#include "server/util/bytes.h"
#include "server/world/attribute_bytes.h"
#include "server/world/room_codec.h"

namespace jostle::server {
namespace {

// See docs/design/format_changes.md. Version 1 has no players, attributes and messages, version 2
// no room, version 3 no edits.
constexpr std::uint64_t version_of_players = 2, version_of_rooms = 3, version_of_edits = 4;
constexpr std::uint64_t host_state_version = version_of_edits, oldest_version = 1;
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
    void operator()(const AttributeValue& value) { write_attribute_value(to, value); }
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
    void operator()(AttributeValue& value) { value = read_attribute_value(from); }
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

// Enumerations as numbers.
template <class Visitor, class Enum>
void visit_enum(Visitor& v, Enum& value) {
    auto number = static_cast<std::uint32_t>(value);
    v(number);
    if constexpr (!std::is_const_v<Enum>) value = static_cast<Enum>(number);
}

template <class Visitor, class HostState>
void visit_players(Visitor& v, HostState& host_state) {
    v.list(host_state.players, [&](auto& p) {
        v(p.client);
        v(p.name);
        v(p.role);
        v(p.color);
        v(p.connected);
        v(p.joined_tick);
    });
    v.list(host_state.attributes, [&](auto& a) {
        visit_enum(v, a.target.kind);
        v(a.target.id);
        v(a.owner);
        v(a.key);
        v(a.attribute.value);
        visit_enum(v, a.attribute.visibility);
        v(a.attribute.roles);
        v(a.attribute.setter);
    });
    v(host_state.messages);
}

template <class Visitor, class HostState>
void visit_edits(Visitor& v, HostState& host_state) {
    v(host_state.revisions);
    v.list(host_state.updated_entities, [&](auto& e) { v(e.entity), v(e.revision), v(e.frozen); });
    v.list(host_state.owned_joints, [&](auto& o) { v(o.client), visit_id(v, o.joint); });
    v.list(host_state.undo, [&](auto& of) {
        v(of.client);
        v.list(of.steps, [&](auto& step) {
            visit_enum(v, step.kind);
            v.list(step.entities, [&](auto& id) { v(id); });
            visit_id(v, step.joint);
            v(step.fields), v(step.record), v(step.owner), v(step.color), v(step.name);
            auto frozen = static_cast<std::uint32_t>(step.frozen);
            v(frozen);
            if constexpr (!std::is_const_v<std::remove_reference_t<decltype(step)>>)
                step.frozen = frozen != 0;
            v.list(step.joints, [&](auto& joint) {
                v(joint.entity_a), v(joint.entity_b), v(joint.owner), v(joint.record);
            });
        });
    });
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

// Empty: the edits are valid.
std::string fault_of_edits(const SavedHostState& host_state) {
    for (const SavedHostState::Updated& updated : host_state.updated_entities)
        if (updated.revision == 0 || updated.revision > host_state.revisions)
            return "updated entity " + std::to_string(updated.entity) + " has revision " +
                   std::to_string(updated.revision) + " of " + std::to_string(host_state.revisions);
    ClientId last = 0;
    for (const SavedHostState::ClientUndo& of : host_state.undo) {
        if (of.client <= last || of.steps.empty() || of.steps.size() > UndoLog::steps_max)
            return "the undo log of client " + std::to_string(of.client) +
                   " is out of order, empty or too long";
        last = of.client;
        for (const UndoStep& step : of.steps)
            if (step.kind > UndoStep::Kind::joint_deleted)
                return "the undo log of client " + std::to_string(of.client) +
                       " has a step of an unknown kind";
    }
    return {};
}

// Empty: the players and attributes are valid.
std::string fault_of_players(const SavedHostState& host_state) {
    ClientId last = 0;
    for (const SavedHostState::SavedPlayer& player : host_state.players) {
        if (player.client <= last || player.role >= player_roles)
            return "player " + std::to_string(player.client) + " with the role " +
                   std::to_string(player.role) + " is out of order or has an unknown role";
        last = player.client;
    }
    const SavedHostState::SavedAttribute* previous = nullptr;
    for (const SavedHostState::SavedAttribute& a : host_state.attributes) {
        if (a.target.kind > AttributeTargetKind::entity)
            return "attribute \"" + a.key + "\" has an unknown kind of target";
        if (a.attribute.visibility < AttributeVisibility::everyone ||
            a.attribute.visibility > AttributeVisibility::roles)
            return "attribute \"" + a.key + "\" has an unknown visibility";
        if (previous && std::pair(previous->target, previous->key) >= std::pair(a.target, a.key))
            return "attribute \"" + a.key + "\" of " + describe(a.target) + " is out of order";
        const AttributeChange change{a.key, a.attribute.value, a.attribute.visibility,
                                     a.attribute.roles};
        if (const Status s = check_attribute_change(change, "attributes."); !s.ok())
            return s.error().message;
        previous = &a;
    }
    return {};
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
    for (const SavedHostState::SavedPlayer& player : host_state.players)
        clients.try_emplace(player.client);
    clients.erase(0);
    return clients;
}

std::uint64_t data_hash(const SavedHostState& host_state) {
    HostStateWriter writer;
    visit_players(writer, host_state);
    if (host_state.room) writer.to.text(encode_room(*host_state.room));
    if (host_state.has_edits()) visit_edits(writer, host_state);
    std::uint64_t hash = 0xcbf29ce484222325u;  // FNV-1a
    for (const char byte : writer.to.take())
        hash = (hash ^ static_cast<std::uint8_t>(byte)) * 0x100000001b3u;
    return hash;
}

std::string encode_host_state(const SavedHostState& host_state) {
    HostStateWriter writer;
    const bool has_players =
        !host_state.players.empty() || !host_state.attributes.empty() || host_state.messages != 0;
    const std::uint64_t version = host_state.has_edits() ? version_of_edits
                                  : host_state.room      ? version_of_rooms
                                  : has_players          ? version_of_players
                                                         : oldest_version;
    writer.to.number(version);
    visit(writer, host_state);
    if (version >= version_of_players) visit_players(writer, host_state);
    if (version >= version_of_edits) {
        writer(std::uint32_t{host_state.room.has_value()});
        visit_edits(writer, host_state);
    }
    if (host_state.room) writer.to.text(encode_room(*host_state.room));
    return writer.to.take();
}

Result<SavedHostState> decode_host_state(std::string_view bytes) {
    HostStateReader reader{ByteReader(bytes)};
    const std::uint64_t version = reader.from.number();
    if (reader.from.ok() && (version < oldest_version || version > host_state_version))
        return Error{ErrorCode::failed_precondition,
                     "unsupported host state: version " + std::to_string(version) +
                         "; this server reads versions " + std::to_string(oldest_version) + " to " +
                         std::to_string(host_state_version)};
    SavedHostState host_state;
    visit(reader, host_state);
    if (version >= version_of_players) visit_players(reader, host_state);
    std::uint32_t has_room = version >= version_of_rooms;
    if (version >= version_of_edits) {
        reader(has_room);
        visit_edits(reader, host_state);
    }
    if (has_room != 0) {
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
    if (const std::string fault = fault_of_players(host_state); !fault.empty())
        return corrupt_host_state(fault);
    if (const std::string fault = fault_of_edits(host_state); !fault.empty())
        return corrupt_host_state(fault);
    return host_state;
}

}  // namespace jostle::server
