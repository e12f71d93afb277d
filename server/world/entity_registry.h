// SPDX-License-Identifier: MIT
//
// The entities of a world: each body has an id that is never reused and the description that
// clients receive. Also maps bodies to entities for as long as an event may name the body. Owned by
// HostedWorld; one thread.
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "jostle/physics/world.h"
#include "server/world/command.h"
#include "server/world/frame.h"
#include "server/world/query_frame.h"
#include "server/world/saved_host_state.h"

namespace jostle::server {

struct Entity {
    physics::BodyId body;
    std::shared_ptr<const EntityDescription> description;  // never null
};

class EntityRegistry {
public:
    // Adds a body of the world; its description is a copy of its current state.
    EntityId add(const physics::World& world, physics::BodyId body, ClientId owner,
                 std::optional<std::uint32_t> color, std::string name);
    // Describes an existing entity again after its body changed.
    void update(const physics::World& world, EntityId id, std::optional<std::uint32_t> color,
                bool frozen);
    // Restores the state that write() stored, into an empty registry. corrupt_data: an entity's
    // body does not exist in the world.
    Status restore(const physics::World& world, const SavedHostState& host_state);
    void write(SavedHostState& host_state) const;
    // Never assigns ids that `other` has assigned.
    // Clients of `other` notice each entity that differs in an edit.
    void skip_ids_of(const EntityRegistry& other);
    EntityId next_id() const { return next_id_; }
    // No entity may have this id.
    void set_next_id(EntityId id) { next_id_ = id; }
    // entity_of() finds a removed body until the step after the next one begins.
    void remove(EntityId id);
    // After each step of the world, whose events name only bodies that existed before it.
    void on_step();

    // Null: the entity does not exist.
    const Entity* find(EntityId id) const;
    // For a living body, or one that was removed since the step before the last.
    EntityId entity_of(physics::BodyId body) const;
    // For a living body; 0 for every other id.
    EntityId find_living(physics::BodyId body) const;
    const std::vector<EntityId>& by_body() const { return entity_of_body_; }  // by index; 0: none
    const std::map<EntityId, Entity>& all() const { return entities_; }       // ascending
    std::size_t size() const { return entities_.size(); }

    // Equal pointers until an entity is added, removed or updated.
    const std::shared_ptr<const EntityList>& list();
    const std::shared_ptr<const ShapeOwners>& shape_owners();

private:
    static std::shared_ptr<EntityDescription> describe(const physics::World& world,
                                                       physics::BodyId body);
    void put(EntityId id, Entity entity);

    EntityId next_id_ = 1;
    std::uint32_t revisions_ = 0;  // number of updates
    std::map<EntityId, Entity> entities_;
    std::vector<EntityId> entity_of_body_;           // by index of the body; 0: none
    std::vector<std::uint32_t> generation_of_body_;  // likewise: of the entity's body
    // Bodies that were removed since the last step, and those that its events may still name.
    std::map<physics::BodyId, EntityId> removed_, removed_before_step_;
    std::shared_ptr<const EntityList> list_;           // null: changed since the last list()
    std::shared_ptr<const ShapeOwners> shape_owners_;  // of that list; null: not computed yet
};

}  // namespace jostle::server
