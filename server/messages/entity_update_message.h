// SPDX-License-Identifier: MIT
//
// Encodes the difference of two entity lists: the large geometries that the bodies refer to, then
// entity updates of bounded size.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "server/messages/geometry_table.h"
#include "server/world/frame.h"

namespace jostle::server {

struct EntityUpdateMessages {
    // each once; referenced by `entity_updates`
    std::vector<std::shared_ptr<const LargeGeometry>> geometry;
    std::vector<SharedBytes> entity_updates;  // removed entities first
    std::vector<EntityId> removed;            // ids of removed entities
};

// An EntityUpdate that only lists removed entities.
std::string encode_removed(std::span<const EntityId> entities);
// How an update lists added entities: each with all of its properties, or packed, with the
// properties that equal entities share once.
enum class EntityForm { complete, packed };
// The update from one entity list to another. Both must be in ascending order of id; an entity
// description never changes.
EntityUpdateMessages entity_update_messages(const EntityList& from, const EntityList& to,
                                            GeometryTable& geometry, EntityForm form);

}  // namespace jostle::server
