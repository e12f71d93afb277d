// SPDX-License-Identifier: MIT
#include "server/world/entity_registry.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "jostle/base/check.h"
#include "server/world/controller_registry.h"

namespace jostle::server {

namespace {

double bounding_radius_of(const physics::World& world, physics::ShapeId shape,
                          physics::Vec3 origin) {
    const auto box = world.bounds(shape);
    if (!box.ok()) return std::numeric_limits<double>::infinity();
    const physics::Vec3 low = box->low - origin, high = box->high - origin;
    return length(physics::Vec3{std::max(-low.x, high.x), std::max(-low.y, high.y),
                                std::max(-low.z, high.z)});
}

}  // namespace

std::shared_ptr<EntityDescription> EntityRegistry::describe(const physics::World& world,
                                                            physics::BodyId body) {
    ASSERT(world.contains(body));
    const physics::BodyState state = *world.body(body);
    auto description = std::make_shared<EntityDescription>();
    description->type = state.type;
    for (const physics::ShapeId shape : world.shapes_of(body)) {
        description->shapes.push_back(*world.shape(shape));
        description->bounding_radius = std::max(
            description->bounding_radius, bounding_radius_of(world, shape, state.pose.position));
    }
    description->mass = state.mass;
    description->jointed = !world.joints_of(body).empty();
    const physics::BodyDef def = *world.definition(body);
    description->linear_damping = def.linear_damping;
    description->angular_damping = def.angular_damping;
    description->gravity_scale = def.gravity_scale;
    description->locks = def.locks;
    description->controllable = is_controllable(world, body);
    return description;
}

void EntityRegistry::put(EntityId id, Entity entity) {
    const physics::BodyId body = entity.body;
    ASSERT(id != 0 && entity.description && !entities_.contains(id));
    entities_.emplace(id, std::move(entity));
    if (entity_of_body_.size() <= body.index) {
        entity_of_body_.resize(body.index + 1, 0);
        generation_of_body_.resize(body.index + 1, 0);
    }
    ASSERT(entity_of_body_.size() == generation_of_body_.size());
    entity_of_body_[body.index] = id;
    generation_of_body_[body.index] = body.generation;
    list_ = nullptr;
    shape_owners_ = nullptr;
}

EntityId EntityRegistry::add(const physics::World& world, physics::BodyId body, ClientId owner,
                             std::optional<std::uint32_t> color, std::string name) {
    std::shared_ptr<EntityDescription> description = describe(world, body);
    const EntityId id = description->id = next_id_++;
    description->owner = owner;
    description->color = color;
    description->name = std::move(name);
    ASSERT(find_living(body) == 0);
    put(id, {body, std::move(description)});
    return id;
}

void EntityRegistry::update(const physics::World& world, EntityId id,
                            std::optional<std::uint32_t> color, bool frozen) {
    const auto at = entities_.find(id);
    ASSERT(at != entities_.end());
    const EntityDescription& before = *at->second.description;
    std::shared_ptr<EntityDescription> description = describe(world, at->second.body);
    description->id = id;
    description->owner = before.owner;
    description->color = color;
    description->name = before.name;
    description->frozen = frozen;
    description->revision = ++revisions_;
    at->second.description = std::move(description);
    list_ = nullptr;
    shape_owners_ = nullptr;
}

Status EntityRegistry::restore(const physics::World& world, const SavedHostState& host_state) {
    ASSERT(entities_.empty());
    for (const SavedHostState::Entity& saved : host_state.entities) {
        if (!world.contains(saved.body))
            return Error{ErrorCode::corrupt_data, "corrupt host state: entity " +
                                                      std::to_string(saved.id) +
                                                      " has no body in the saved world"};
        std::shared_ptr<EntityDescription> description = describe(world, saved.body);
        description->id = saved.id;
        description->owner = saved.owner;
        description->color = saved.color;
        description->name = saved.name;
        description->mass = saved.mass;
        description->bounding_radius = saved.bounding_radius;
        put(saved.id, {saved.body, std::move(description)});
    }
    next_id_ = host_state.next_id;
    for (const SavedHostState::Updated& saved : host_state.updated_entities) {
        const auto at = entities_.find(saved.entity);
        if (at == entities_.end())
            return Error{ErrorCode::corrupt_data, "corrupt host state: updated entity " +
                                                      std::to_string(saved.entity) +
                                                      " does not exist"};
        auto description = std::make_shared<EntityDescription>(*at->second.description);
        description->revision = saved.revision;
        description->frozen = saved.frozen != 0;
        at->second.description = std::move(description);
    }
    revisions_ = host_state.revisions;
    return {};
}

void EntityRegistry::write(SavedHostState& host_state) const {
    host_state.next_id = next_id_;
    host_state.revisions = revisions_;
    ASSERT(host_state.entities.empty());
    host_state.entities.reserve(entities_.size());
    for (const auto& [id, entity] : entities_) {
        const EntityDescription& d = *entity.description;
        host_state.entities.push_back(
            {id, entity.body, d.owner, d.color, d.name, d.mass, d.bounding_radius});
        if (d.revision != 0) host_state.updated_entities.push_back({id, d.revision, d.frozen});
    }
}

void EntityRegistry::skip_ids_of(const EntityRegistry& other) {
    next_id_ = std::max(next_id_, other.next_id_);
    revisions_ = std::max(revisions_, other.revisions_);
    for (auto& [id, entity] : entities_) {
        const Entity* const known = other.find(id);
        if (!known || known->description->revision == entity.description->revision) continue;
        auto description = std::make_shared<EntityDescription>(*entity.description);
        description->revision = ++revisions_;
        entity.description = std::move(description);
        list_ = nullptr;
    }
}

void EntityRegistry::remove(EntityId id) {
    const auto at = entities_.find(id);
    if (at == entities_.end()) return;
    ASSERT(at->second.body.index < entity_of_body_.size());
    entity_of_body_[at->second.body.index] = 0;
    removed_.emplace(at->second.body, id);
    entities_.erase(at);
    list_ = nullptr;
    shape_owners_ = nullptr;
}

void EntityRegistry::on_step() {
    removed_before_step_ = std::exchange(removed_, {});
}

const Entity* EntityRegistry::find(EntityId id) const {
    const auto at = entities_.find(id);
    return at == entities_.end() ? nullptr : &at->second;
}

EntityId EntityRegistry::entity_of(physics::BodyId body) const {
    const auto at = removed_before_step_.find(body);
    if (at != removed_before_step_.end()) return at->second;
    return body.index < entity_of_body_.size() ? entity_of_body_[body.index] : 0;
}

EntityId EntityRegistry::find_living(physics::BodyId body) const {
    if (body.index >= entity_of_body_.size()) return 0;
    return generation_of_body_[body.index] == body.generation ? entity_of_body_[body.index] : 0;
}

const std::shared_ptr<const EntityList>& EntityRegistry::list() {
    if (!list_) {
        auto list = std::make_shared<EntityList>();
        list->reserve(entities_.size());
        for (const auto& [id, entity] : entities_) list->push_back(entity.description);
        ASSERT(list->size() == entities_.size());
        list_ = std::move(list);
    }
    return list_;
}

const std::shared_ptr<const ShapeOwners>& EntityRegistry::shape_owners() {
    if (!shape_owners_)
        shape_owners_ = std::make_shared<const ShapeOwners>(shape_owners_in(*list()));
    return shape_owners_;
}

}  // namespace jostle::server
