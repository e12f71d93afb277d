// SPDX-License-Identifier: MIT
//
// Packs the ids of entities and the numbers of their prototypes (EntityUpdate.packed). WIRE.md,
// "Entity lists", specifies the bytes. An entity that follows its predecessor and has the prototype
// that came next before costs two bits. Any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "jostle/base/result.h"

namespace jostle::snapshot {

struct ListedEntity {
    std::uint32_t id = 0;
    std::uint32_t prototype = 0;  ///< index in EntityUpdate.prototypes

    bool operator==(const ListedEntity&) const = default;
};

inline constexpr std::size_t prototypes_max = 65536;

/// The entities must be in ascending order of id, and `prototypes`, the number of prototypes, at
/// most prototypes_max and above each of theirs.
std::vector<std::byte> encode_entity_list(std::span<const ListedEntity> entities,
                                          std::size_t prototypes);

/// Decodes untrusted bytes; every read is bounded. Returns corrupt_data with the cause and the
/// position. `max_entities` bounds the allocated memory.
Result<std::vector<ListedEntity>> decode_entity_list(std::span<const std::byte> packed,
                                                     std::size_t prototypes,
                                                     std::size_t max_entities);

}  // namespace jostle::snapshot
