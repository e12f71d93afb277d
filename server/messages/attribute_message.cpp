// SPDX-License-Identifier: MIT
#include "server/messages/attribute_message.h"

#include <optional>
#include <utility>
#include <variant>

#include "jostle/base/check.h"
#include "server/messages/message_parts.h"

namespace jostle::server {

namespace {

std::optional<AttributeValue> to_value(const v1::Attribute& from) {
    switch (from.value_case()) {
        case v1::Attribute::kBoolean:
            return from.boolean();
        case v1::Attribute::kInteger:
            return std::int64_t{from.integer()};
        case v1::Attribute::kNumber:
            return from.number();
        case v1::Attribute::kText:
            return from.text();
        case v1::Attribute::kVector:
            return to_vector(from.vector());
        case v1::Attribute::VALUE_NOT_SET:
            break;
    }
    return std::nullopt;
}

struct WriteValue {
    v1::Attribute& to;

    void operator()(bool value) const { to.set_boolean(value); }
    void operator()(std::int64_t value) const { to.set_integer(value); }
    void operator()(double value) const { to.set_number(value); }
    void operator()(const std::string& value) const { to.set_text(value); }
    void operator()(const physics::Vec3& value) const { write_vector(*to.mutable_vector(), value); }
};

// Whether the client reads the attributes of the target that only owners read.
bool is_owner(const AttributeTarget& target, ClientId owner, ClientId client, PlayerRole role) {
    return target.kind == AttributeTargetKind::world ? role == PlayerRole::owner : owner == client;
}

bool is_owner_only(const std::optional<Attribute>& attribute) {
    return attribute && attribute->visibility == AttributeVisibility::owner;
}

// Adds attributes to an update; consecutive attributes of one target form one set.
class UpdateWriter {
public:
    explicit UpdateWriter(std::uint32_t tick) : update_(*fields_.add_attributes()) {
        update_.set_tick(tick);
    }

    void set_complete() { update_.set_complete(true); }
    void set(const AttributeTarget& target, const std::string& key, const Attribute& attribute) {
        write_attribute(*set_of(target).add_attributes(), key, attribute);
    }
    void remove(const AttributeTarget& target, const std::string& key) {
        set_of(target).add_attributes()->set_key(key);
    }
    void end(const AttributeTarget& target) {
        ASSERT(target.kind != AttributeTargetKind::world);
        if (target.kind == AttributeTargetKind::entity)
            update_.add_entities_ended(target.id);
        else
            update_.add_players_ended(target.id);
    }
    std::string take() const {
        const bool empty = !update_.complete() && update_.sets().empty() &&
                           update_.entities_ended().empty() && update_.players_ended().empty();
        return empty ? std::string() : fields_.SerializeAsString();
    }

private:
    v1::AttributeSet& set_of(const AttributeTarget& target) {
        if (!set_ || target != target_) {
            set_ = update_.add_sets();
            write_target(*set_, target);
            target_ = target;
        }
        return *set_;
    }

    v1::Snapshot fields_;
    v1::AttributeUpdate& update_;
    v1::AttributeSet* set_ = nullptr;
    AttributeTarget target_;
};

}  // namespace

Result<SetAttributesCommand> to_attribute_changes(const v1::AttributeSet& set,
                                                  const std::string& where) {
    SetAttributesCommand command;
    switch (set.target_case()) {
        case v1::AttributeSet::kEntity:
            command.target = {AttributeTargetKind::entity, set.entity()};
            break;
        case v1::AttributeSet::kPlayer:
            command.target = {AttributeTargetKind::player, set.player()};
            break;
        case v1::AttributeSet::kWorld:
            if (set.world()) break;
            [[fallthrough]];
        case v1::AttributeSet::TARGET_NOT_SET:
            return invalid_argument(where +
                                    "target is not set; set entity, player, or world to true");
    }
    command.changes.reserve(static_cast<std::size_t>(set.attributes_size()));
    for (const v1::Attribute& from : set.attributes()) {
        if (from.visibility() < 0 || from.visibility() > v1::ATTRIBUTE_VISIBILITY_ROLES)
            return invalid_argument(where + "attributes[" + std::to_string(command.changes.size()) +
                                    "].visibility is " + std::to_string(from.visibility()) +
                                    "; it must be EVERYONE, OWNER or ROLES");
        const auto visibility = from.visibility() == v1::ATTRIBUTE_VISIBILITY_UNSPECIFIED
                                    ? AttributeVisibility::everyone
                                    : static_cast<AttributeVisibility>(from.visibility());
        command.changes.push_back({from.key(), to_value(from), visibility, from.roles()});
    }
    return command;
}

void write_target(v1::AttributeSet& to, const AttributeTarget& target) {
    switch (target.kind) {
        case AttributeTargetKind::world:
            return to.set_world(true);
        case AttributeTargetKind::player:
            return to.set_player(target.id);
        case AttributeTargetKind::entity:
            return to.set_entity(target.id);
    }
}

void write_attribute(v1::Attribute& to, const std::string& key, const Attribute& attribute) {
    to.set_key(key);
    std::visit(WriteValue{to}, attribute.value);
    if (attribute.visibility != AttributeVisibility::everyone)
        to.set_visibility(static_cast<v1::AttributeVisibility>(attribute.visibility));
    to.set_roles(attribute.roles);
    to.set_read_only(attribute.setter == scene_client);
}

std::string encode_attribute_changes(const AttributeChanges& changes, PlayerRole role) {
    UpdateWriter writer(changes.tick);
    for (const PublishedChange& change : changes.changes) {
        if (change.now && is_visible_to_role(*change.now, role))
            writer.set(change.target, change.key, *change.now);
        else if (change.before && is_visible_to_role(*change.before, role))
            writer.remove(change.target, change.key);
    }
    for (const AttributeTarget& target : changes.ended) writer.end(target);
    return writer.take();
}

std::string encode_own_attribute_changes(const AttributeChanges& changes, ClientId client,
                                         PlayerRole role) {
    UpdateWriter writer(changes.tick);
    for (const PublishedChange& change : changes.changes) {
        if (!is_owner_only(change.before) && !is_owner_only(change.now)) continue;
        if (!is_owner(change.target, change.owner, client, role)) continue;
        if (is_owner_only(change.now))
            writer.set(change.target, change.key, *change.now);
        else if (!change.now || !is_visible_to_role(*change.now, role))
            writer.remove(change.target, change.key);
    }
    return writer.take();
}

std::string encode_attribute_table(const AttributeTable& table, std::uint32_t tick,
                                   PlayerRole role) {
    UpdateWriter writer(tick);
    writer.set_complete();
    for (const auto& entry : table.targets())
        for (const auto& [key, attribute] : entry->attributes)
            if (is_visible_to_role(attribute, role)) writer.set(entry->target, key, attribute);
    return writer.take();
}

std::string encode_own_attributes(const AttributeTable& table, std::uint32_t tick, ClientId client,
                                  PlayerRole role) {
    UpdateWriter writer(tick);
    for (const auto& bucket : table.buckets) {
        if (!bucket) continue;
        for (const auto& entry : *bucket) {
            if (!is_owner(entry->target, entry->owner, client, role)) continue;
            for (const auto& [key, attribute] : entry->attributes)
                if (attribute.visibility == AttributeVisibility::owner)
                    writer.set(entry->target, key, attribute);
        }
    }
    return writer.take();
}

}  // namespace jostle::server
