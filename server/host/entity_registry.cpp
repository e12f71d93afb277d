// SPDX-License-Identifier: MIT
#include "host/entity_registry.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "host/drivers.h"

namespace jostle::server {

namespace {

double reach_of(const physics::World& world, physics::ShapeId shape, physics::Vec3 origin) {
    const auto box = world.bounds(shape);
    if (!box.ok()) return std::numeric_limits<double>::infinity();
    const physics::Vec3 low = box->low - origin, high = box->high - origin;
    return length(physics::Vec3{std::max(-low.x, high.x), std::max(-low.y, high.y),
                                std::max(-low.z, high.z)});
}

}  // namespace

EntityId EntityRegistry::add(const physics::World& world, physics::BodyId body, ClientId owner,
                             std::optional<std::uint32_t> color, std::string name) {
    const physics::BodyState state = *world.body(body);
    auto description = std::make_shared<EntityDescription>();
    const EntityId id = description->id = next_id_++;
    description->type = state.type;
    for (const physics::ShapeId shape : world.shapes_of(body)) {
        description->shapes.push_back(*world.shape(shape));
        description->reach =
            std::max(description->reach, reach_of(world, shape, state.pose.position));
    }
    description->owner = owner;
    description->color = color;
    description->name = std::move(name);
    description->mass = state.mass;
    description->drivable = can_be_driven(world, body);
    entities_.emplace(id, Entity{body, std::move(description)});
    if (entity_of_body_.size() <= body.index) {
        entity_of_body_.resize(body.index + 1, 0);
        generation_of_body_.resize(body.index + 1, 0);
    }
    entity_of_body_[body.index] = id;
    generation_of_body_[body.index] = body.generation;
    list_ = nullptr;
    places_ = nullptr;
    return id;
}

void EntityRegistry::remove(EntityId id) {
    const auto at = entities_.find(id);
    if (at == entities_.end()) return;
    entity_of_body_[at->second.body.index] = 0;
    removed_.emplace(at->second.body, id);
    entities_.erase(at);
    list_ = nullptr;
    places_ = nullptr;
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

EntityId EntityRegistry::living(physics::BodyId body) const {
    if (body.index >= entity_of_body_.size()) return 0;
    return generation_of_body_[body.index] == body.generation ? entity_of_body_[body.index] : 0;
}

const std::shared_ptr<const EntityList>& EntityRegistry::list() {
    if (!list_) {
        auto list = std::make_shared<EntityList>();
        list->reserve(entities_.size());
        for (const auto& [id, entity] : entities_) list->push_back(entity.description);
        list_ = std::move(list);
    }
    return list_;
}

const std::shared_ptr<const ShapePlaces>& EntityRegistry::places() {
    if (!places_) places_ = std::make_shared<const ShapePlaces>(places_in(*list()));
    return places_;
}

}  // namespace jostle::server
