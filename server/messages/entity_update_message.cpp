// SPDX-License-Identifier: MIT
#include "server/messages/entity_update_message.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "jostle/base/check.h"
#include "jostle/scenes/locks_message.h"
#include "jostle/scenes/shape_message.h"
#include "jostle/snapshot/entity_list.h"
#include "jostle/v1/play.pb.h"
#include "server/messages/message_parts.h"

namespace jostle::server {

namespace {

struct Difference {
    EntityList added;
    std::vector<EntityId> removed;
};

Difference difference_of(const EntityList& from, const EntityList& to) {
    Difference difference;
    std::size_t i = 0, j = 0;
    while (i < from.size() || j < to.size()) {
        if (j == to.size() || (i < from.size() && from[i]->id < to[j]->id)) {
            difference.removed.push_back(from[i++]->id);
        } else if (i == from.size() || to[j]->id < from[i]->id) {
            difference.added.push_back(to[j++]);
        } else {
            // An edited entity is removed and added again.
            if (from[i]->revision != to[j]->revision) {
                difference.removed.push_back(from[i]->id);
                difference.added.push_back(to[j]);
            }
            ++i, ++j;
        }
    }
    return difference;
}

// The mass of the entity alone then determines its mass distribution.
bool has_one_density(const EntityDescription& entity) {
    return entity.shapes.size() == 1 ||
           std::ranges::all_of(entity.shapes, [&](const physics::ShapeState& shape) {
               return shape.mass == 0 && shape.density == entity.shapes.front().density;
           });
}

// Splits entity updates into messages of bounded size.
class EntityUpdateWriter {
public:
    EntityUpdateWriter(GeometryTable& table, EntityForm form) : table_(table), form_(form) {}

    void remove(EntityId id) {
        entity_update().add_removed(id);
        count(id_bytes);
    }
    void add(const EntityDescription& entity) {
        ASSERT(entity.id != 0);
        if (form_ == EntityForm::packed) {
            add_packed(entity);
            return;
        }
        v1::Entity& to = *entity_update().add_added();
        to.set_id(entity.id);
        write(to, entity);
        count(to.ByteSizeLong() + frame_bytes);
    }
    EntityUpdateMessages take() {
        flush();
        ASSERT(bytes_ == 0);
        return std::move(out_);
    }

private:
    static constexpr std::size_t id_bytes = 5;
    static constexpr std::size_t frame_bytes = 4;   // tag and length of an entity
    static constexpr std::size_t packed_bytes = 8;  // at most, of a packed entity

    v1::EntityUpdate& entity_update() { return *message_.mutable_entity_update(); }

    void add_packed(const EntityDescription& entity) {
        v1::Entity prototype;
        write(prototype, entity);
        std::string bytes = prototype.SerializeAsString();
        std::size_t added = packed_bytes;
        const auto next = static_cast<std::uint32_t>(prototypes_.size());
        const auto [known, fresh] = prototypes_.try_emplace(std::move(bytes), next);
        if (fresh) {
            added += known->first.size() + frame_bytes;
            *entity_update().add_prototypes() = std::move(prototype);
        }
        entities_.push_back({entity.id, known->second});
        ASSERT(entities_.size() < 2 || entities_[entities_.size() - 2].id < entity.id);
        count(added);
        if (prototypes_.size() == snapshot::prototypes_max) flush();
    }
    // Writes everything except the id.
    void write(v1::Entity& to, const EntityDescription& entity) {
        to.set_type(to_message(entity.type));
        const bool even = has_one_density(entity);
        for (const physics::ShapeState& shape : entity.shapes)
            write(*to.add_shapes(), shape, !even);
        to.set_owner(entity.owner);
        if (entity.color) to.set_color(*entity.color);
        to.set_name(entity.name);
        to.set_mass(entity.mass);
        to.set_controllable(entity.controllable);
        to.set_jointed(entity.jointed);
        to.set_linear_damping(entity.linear_damping);
        to.set_angular_damping(entity.angular_damping);
        if (entity.gravity_scale != 1) to.set_gravity_scale(entity.gravity_scale);
        if (entity.locks != 0) *to.mutable_locks() = scenes::locks_message(entity.locks);
    }

    // Writes appearance, pose, size and contact properties.
    void write(v1::Shape& to, const physics::ShapeState& shape, bool with_mass) {
        const auto large = table_.find_or_add(shape.geometry);
        scenes::write_geometry(to, large ? physics::Geometry{} : shape.geometry, shape.pose);
        scenes::write_contact_properties(to, physics::def_of(shape));
        if (with_mass && shape.mass > 0)
            to.set_mass(shape.mass);
        else if (with_mass)
            to.set_density(shape.density);
        if (!large) return;
        to.set_geometry(large->id);
        if (std::ranges::find(out_.geometry, large) == out_.geometry.end())
            out_.geometry.push_back(large);
    }
    void count(std::size_t bytes) {
        bytes_ += bytes;
        if (bytes_ >= chunk_bytes_max) flush();
        ASSERT(bytes_ < chunk_bytes_max);
    }
    void flush() {
        if (bytes_ == 0) return;
        if (!entities_.empty()) {
            const std::vector<std::byte> packed =
                snapshot::encode_entity_list(entities_, prototypes_.size());
            entity_update().set_packed(packed.data(), packed.size());
            entities_.clear();
            prototypes_.clear();
        }
        out_.entity_updates.push_back(
            std::make_shared<const std::string>(message_.SerializeAsString()));
        message_.Clear();
        bytes_ = 0;
    }

    GeometryTable& table_;
    const EntityForm form_;
    // Of the message under construction, if packed: the prototypes by their bytes, and the
    // entities.
    std::unordered_map<std::string, std::uint32_t> prototypes_;
    std::vector<snapshot::ListedEntity> entities_;
    v1::ServerMessage message_;
    std::size_t bytes_ = 0;
    EntityUpdateMessages out_;
};

}  // namespace

EntityUpdateMessages entity_update_messages(const EntityList& from, const EntityList& to,
                                            GeometryTable& geometry, EntityForm form) {
    Difference difference = difference_of(from, to);
    EntityUpdateWriter writer(geometry, form);
    for (const EntityId id : difference.removed) writer.remove(id);
    for (const auto& entity : difference.added) writer.add(*entity);
    EntityUpdateMessages messages = writer.take();
    messages.removed = std::move(difference.removed);
    return messages;
}

std::string encode_removed(std::span<const EntityId> entities) {
    v1::ServerMessage message;
    message.mutable_entity_update()->mutable_removed()->Add(entities.begin(), entities.end());
    return message.SerializeAsString();
}

}  // namespace jostle::server
