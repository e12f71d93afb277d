// SPDX-License-Identifier: MIT
#include "jostle/client/added_entities.h"

#include <span>

#include "jostle/snapshot/entity_list.h"
#include "jostle/snapshot/frame_codec.h"

namespace jostle::client {

Result<std::vector<v1::Entity>> added_entities(const v1::EntityUpdate& update) {
    std::vector<v1::Entity> entities(update.added().begin(), update.added().end());
    if (update.packed().empty()) return entities;
    const auto listed = snapshot::decode_entity_list(
        std::as_bytes(std::span(update.packed())),
        static_cast<std::size_t>(update.prototypes_size()), snapshot::default_entities_max);
    if (!listed.ok()) return Error{listed.error().code, "entity update: " + listed.error().message};
    std::vector<std::size_t> sizes;
    for (const v1::Entity& prototype : update.prototypes())
        sizes.push_back(sizeof(v1::Entity) + prototype.ByteSizeLong());
    std::size_t bytes = 0;
    entities.reserve(entities.size() + listed->size());
    for (const snapshot::ListedEntity& entity : *listed) {
        bytes += sizes[entity.prototype];
        if (bytes > added_entities_bytes_max)
            return Error{ErrorCode::corrupt_data, "entity update: more than " +
                                                      std::to_string(added_entities_bytes_max) +
                                                      " bytes of entities"};
        entities.push_back(update.prototypes(static_cast<int>(entity.prototype)));
        entities.back().set_id(entity.id);
    }
    return entities;
}

}  // namespace jostle::client
