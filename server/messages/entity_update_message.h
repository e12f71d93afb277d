// SPDX-License-Identifier: MIT
//
// Who came and who went, as messages: the large shapes that the bodies name, then rosters of
// bounded size.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "server/messages/geometry_table.h"
#include "server/world/frame.h"

namespace jostle::server {

struct EntityUpdateMessages {
    std::vector<std::shared_ptr<const LargeGeometry>> geometry;  // each once; named by `rosters`
    std::vector<SharedBytes> entity_updates;                     // what is gone first
    std::vector<EntityId> removed;                               // likewise
};

// From one entity list to another. Both are in rising order of id, and an entity never changes.
// A EntityUpdate that only tells who is gone.
std::string encode_removed(std::span<const EntityId> entities);

EntityUpdateMessages entity_update_messages(const EntityList& from, const EntityList& to,
                                            GeometryTable& geometry);

}  // namespace jostle::server
