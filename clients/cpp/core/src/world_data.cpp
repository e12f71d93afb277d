// SPDX-License-Identifier: MIT
#include "jostle/client/world_data.h"

#include <utility>

namespace jostle::client {

namespace {

AttributeTarget target_of(const v1::AttributeSet& set) {
    switch (set.target_case()) {
        case v1::AttributeSet::kEntity:
            return AttributeTarget::entity(set.entity());
        case v1::AttributeSet::kPlayer:
            return AttributeTarget::player(set.player());
        default:
            return AttributeTarget::world();
    }
}

}  // namespace

void WorldData::clear() {
    players_.clear();
    attributes_.clear();
    room_.reset();
    attribute_revision_++;
}

void WorldData::apply(const v1::Snapshot& snapshot) {
    for (const v1::PlayerUpdate& update : snapshot.players()) apply(update);
    for (const v1::AttributeUpdate& update : snapshot.attributes()) apply(update);
    if (snapshot.has_room()) room_ = snapshot.room();
}

void WorldData::apply(const v1::PlayerUpdate& update) {
    if (update.complete()) players_.clear();
    for (const v1::Player& player : update.players()) players_[player.client()] = player;
    for (const v1::PlayerEvent& event : update.events()) {
        const std::uint32_t client = event.player().client();
        if (event.kind() == v1::PLAYER_EVENT_KIND_LEFT) {
            players_.erase(client);
            continue;
        }
        v1::Player& player = players_[client];
        const std::uint32_t ping_ms = player.ping_ms();
        player = event.player();
        player.set_ping_ms(ping_ms);
    }
    for (const v1::PlayerPing& ping : update.pings())
        if (const auto player = players_.find(ping.client()); player != players_.end())
            player->second.set_ping_ms(ping.ping_ms());
}

void WorldData::apply(const v1::AttributeUpdate& update) {
    attribute_revision_++;
    if (update.complete()) attributes_.clear();
    for (const v1::AttributeSet& set : update.sets()) {
        AttributeMap& attributes = attributes_[target_of(set)];
        for (const v1::Attribute& attribute : set.attributes()) {
            if (attribute.value_case() == v1::Attribute::VALUE_NOT_SET)
                attributes.erase(attribute.key());
            else
                attributes.insert_or_assign(attribute.key(), attribute);
        }
        if (attributes.empty()) attributes_.erase(target_of(set));
    }
    for (const std::uint32_t entity : update.entities_ended())
        attributes_.erase(AttributeTarget::entity(entity));
    for (const std::uint32_t client : update.players_ended())
        attributes_.erase(AttributeTarget::player(client));
}

const v1::Attribute* WorldData::attribute(const AttributeTarget& target,
                                          std::string_view key) const {
    const auto attributes = attributes_.find(target);
    if (attributes == attributes_.end()) return nullptr;
    const auto attribute = attributes->second.find(key);
    return attribute == attributes->second.end() ? nullptr : &attribute->second;
}

v1::Input message_input(std::string topic, std::string data, const std::vector<std::uint32_t>& to) {
    v1::Input input;
    v1::SendMessageInput& message = *input.mutable_send_message();
    message.set_topic(std::move(topic));
    message.set_data(std::move(data));
    message.mutable_to()->Add(to.begin(), to.end());
    return input;
}

v1::Input server_message_input(std::string topic, std::string data) {
    v1::Input input = message_input(std::move(topic), std::move(data));
    input.mutable_send_message()->set_to_server(true);
    return input;
}

v1::Input attributes_input(const AttributeTarget& target,
                           const std::vector<v1::Attribute>& attributes) {
    v1::Input input;
    v1::AttributeSet& set = *input.mutable_set_attributes()->mutable_set();
    switch (target.kind) {
        case AttributeTarget::Kind::world:
            set.set_world(true);
            break;
        case AttributeTarget::Kind::player:
            set.set_player(target.id);
            break;
        case AttributeTarget::Kind::entity:
            set.set_entity(target.id);
            break;
    }
    for (const v1::Attribute& attribute : attributes) *set.add_attributes() = attribute;
    return input;
}

v1::Input rename_input(std::string name) {
    v1::Input input;
    input.mutable_rename()->set_name(std::move(name));
    return input;
}

}  // namespace jostle::client
