// SPDX-License-Identifier: MIT
//
// A world as bytes. What is saved, hashed and compared is one field list
// (src/persist/field_list.h), so none of the three can forget a field that another has. A loaded
// world continues with the same bits as the one that was saved.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "jostle/physics/result.h"

namespace jostle::physics {

class World;

std::vector<std::byte> save(const World& world);

// Foreign bytes are checked in full: an error names the field and the offset.
Result<World> load(std::span<const std::byte> bytes);

// 64 bits over everything that the next step depends on.
std::uint64_t state_hash(const World& world);

// The first field in which two worlds differ, with both values: "bodies[3].pose.position.y: 0.5
// against 0.49"; nothing when they are equal.
std::optional<std::string> first_difference(const World& a, const World& b);

}  // namespace jostle::physics
