// SPDX-License-Identifier: MIT
//
// The entities that an EntityUpdate adds, which a server lists one by one or packed (WIRE.md,
// "Entity lists").
#pragma once

#include <cstddef>
#include <vector>

#include "jostle/base/result.h"
#include "jostle/v1/play.pb.h"

namespace jostle::client {

/// Bytes of entities that a packed update may expand to.
inline constexpr std::size_t added_entities_bytes_max = 256u << 20;

/// Returns the added entities in the order of the update. Returns corrupt_data if the packed bytes
/// are malformed or the entities exceed the limit.
Result<std::vector<v1::Entity>> added_entities(const v1::EntityUpdate& update);

}  // namespace jostle::client
