// SPDX-License-Identifier: MIT
//
// The players and attributes of a world as received by one client, and inputs that change them. It
// is independent of the network: the caller passes the snapshots. One thread at a time.
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "jostle/v1/play.pb.h"

namespace jostle::client {

/// The world, a player or an entity that has attributes.
struct AttributeTarget {
    /// Kind of the target.
    enum class Kind : std::uint8_t { world, player, entity };
    Kind kind = Kind::world;
    std::uint32_t id = 0;  ///< client id or entity id; 0 for the world

    static AttributeTarget world() { return {}; }
    static AttributeTarget player(std::uint32_t client) { return {Kind::player, client}; }
    static AttributeTarget entity(std::uint32_t id) { return {Kind::entity, id}; }
    auto operator<=>(const AttributeTarget&) const = default;
};

/// Attributes of one target by key.
using AttributeMap = std::map<std::string, v1::Attribute, std::less<>>;

/// The player list, the attributes and the room that the client subscribed to.
class WorldData {
public:
    /// Applies the players, attributes and room of a snapshot, in the order in which they were
    /// received.
    void apply(const v1::Snapshot& snapshot);
    /// Discards everything, for a new stream. A resumed one starts with complete lists.
    void clear();

    /// Players by client id, with their last round-trip time (ClientOptions::players).
    const std::map<std::uint32_t, v1::Player>& players() const { return players_; }
    /// Targets with attributes (ClientOptions::attributes).
    const std::map<AttributeTarget, AttributeMap>& attributes() const { return attributes_; }
    /// Returns null if the client may not read the attribute or it does not exist.
    const v1::Attribute* attribute(const AttributeTarget& target, std::string_view key) const;
    /// The room as this client may see it (ClientOptions::room); null: the world is no room.
    const v1::RoomUpdate* room() const { return room_ ? &*room_ : nullptr; }
    /// Increases with every change of an attribute.
    std::uint64_t attribute_revision() const { return attribute_revision_; }

private:
    void apply(const v1::PlayerUpdate& update);
    void apply(const v1::AttributeUpdate& update);

    std::map<std::uint32_t, v1::Player> players_;
    std::map<AttributeTarget, AttributeMap> attributes_;
    std::optional<v1::RoomUpdate> room_;
    std::uint64_t attribute_revision_ = 0;
};

/// Returns an input that sends a user message to all clients, or to some of them.
v1::Input message_input(std::string topic, std::string data,
                        const std::vector<std::uint32_t>& to = {});
/// Returns an input that sends a user message to the server alone.
v1::Input server_message_input(std::string topic, std::string data);
/// Returns an input that sets attributes; one without a value is removed.
v1::Input attributes_input(const AttributeTarget& target,
                           const std::vector<v1::Attribute>& attributes);
/// Returns an input that renames the player.
v1::Input rename_input(std::string name);

}  // namespace jostle::client
