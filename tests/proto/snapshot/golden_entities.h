// SPDX-License-Identifier: MIT
//
// The golden entity lists (WIRE.md, "Golden frames"): proto/golden/entities.jent.
#pragma once

#include <cstdint>
#include <vector>

#include "jostle/snapshot/entity_list.h"

namespace jostle::snapshot {

struct GoldenEntities {
    std::size_t prototypes = 1;
    std::vector<ListedEntity> entities;
};

// Equal boxes; a pattern of three that ends; prototypes in any order with gaps between ids; none.
inline std::vector<GoldenEntities> golden_entity_lists() {
    std::vector<GoldenEntities> lists(4);
    for (std::uint32_t id = 1; id <= 200; id++) lists[0].entities.push_back({id, 0});
    lists[1].prototypes = 15;
    for (std::uint32_t id = 5; id <= 300; id++)
        lists[1].entities.push_back({id, id < 250 ? id % 3 : id % 15});
    lists[2].prototypes = 1000;
    std::uint32_t random = 1, id = 1;
    for (int k = 0; k < 100; k++) {
        random = random * 1664525u + 1013904223u;
        id += 1 + (random >> 8) % (k % 10 == 0 ? 5'000'000 : 4);
        lists[2].entities.push_back({id, (random >> 12) % 1000});
    }
    lists[2].entities.push_back({0xffffffffu, 999});
    return lists;
}

inline std::vector<std::byte> golden_entity_file() {
    std::vector<std::byte> file;
    const auto put = [&](std::uint32_t value) {
        for (int k = 0; k < 4; k++) file.push_back(static_cast<std::byte>(value >> (8 * k)));
    };
    for (const char c : {'J', 'E', 'N', 'T'}) file.push_back(static_cast<std::byte>(c));
    const std::vector<GoldenEntities> lists = golden_entity_lists();
    put(1);
    put(static_cast<std::uint32_t>(lists.size()));
    for (const GoldenEntities& list : lists) {
        const std::vector<std::byte> packed = encode_entity_list(list.entities, list.prototypes);
        put(static_cast<std::uint32_t>(list.prototypes));
        put(static_cast<std::uint32_t>(list.entities.size()));
        put(static_cast<std::uint32_t>(packed.size()));
        for (const ListedEntity& entity : list.entities) put(entity.id), put(entity.prototype);
        file.insert(file.end(), packed.begin(), packed.end());
    }
    return file;
}

}  // namespace jostle::snapshot
