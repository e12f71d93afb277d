// SPDX-License-Identifier: MIT
//
// Which entities a world has: an id that is never reused for each body, and what clients are told
// of it. Also which entity a body is, for as long as an event may name the body. Owned by
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
    // Describes a body of the world as it is now.
    EntityId add(const physics::World& world, physics::BodyId body, ClientId owner,
                 std::optional<std::uint32_t> color, std::string name);
    // As write() told, in a registry in which there is nothing yet. corrupt_data: of a body that
    // the world does not have.
    Status restore(const physics::World& world, const SavedHostState& host_state);
    void write(SavedHostState& host_state) const;
    // Ids that another one gave are not given again.
    void skip_ids_of(const EntityRegistry& other) { next_id_ = std::max(next_id_, other.next_id_); }
    // One that is there. Its body can still be looked up until the step after the next has begun.
    void remove(EntityId id);
    // The world stepped: its events name bodies that were there before, and no older ones.
    void on_step();

    // Null when there is none.
    const Entity* find(EntityId id) const;
    // Of a body that lives, or that was removed since the step before the last.
    EntityId entity_of(physics::BodyId body) const;
    // Of a body that lives; 0 for any other id, whatever it holds.
    EntityId find_living(physics::BodyId body) const;
    const std::vector<EntityId>& by_body() const { return entity_of_body_; }  // by index; 0: none
    const std::map<EntityId, Entity>& all() const { return entities_; }       // in rising order
    std::size_t size() const { return entities_.size(); }

    // The same pointers until an entity comes or goes.
    const std::shared_ptr<const EntityList>& list();
    const std::shared_ptr<const ShapeOwners>& shape_owners();

private:
    // Of a body of the world.
    static std::shared_ptr<EntityDescription> describe(const physics::World& world,
                                                       physics::BodyId body);
    void put(EntityId id, Entity entity);

    EntityId next_id_ = 1;
    std::map<EntityId, Entity> entities_;
    std::vector<EntityId> entity_of_body_;           // by index
    std::vector<std::uint32_t> generation_of_body_;  // likewise: of the body that the entity is
    // Bodies that were removed since the last step, and those that its events may still name.
    std::map<physics::BodyId, EntityId> removed_, removed_before_step_;
    std::shared_ptr<const EntityList> list_;           // null: changed since it was asked for
    std::shared_ptr<const ShapeOwners> shape_owners_;  // of that list; null: not asked for yet
};

}  // namespace jostle::server
