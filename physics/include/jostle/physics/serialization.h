// SPDX-License-Identifier: MIT
//
// A world as bytes. One field list (src/persist/field_list.h) says what is saved, hashed and
// compared, so none of the three can forget a field that another has. A loaded world goes on with
// the same bits as the one that was saved, in every build of the same arithmetic (arithmetic.h).
// All calls are const calls of the world (world.h).
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

std::vector<std::byte> save(const World& world);  // of a kept moment: RestorePoint::save()

// Foreign bytes are checked in full: mark, version, length, checksum, each field, and whether the
// fields agree. An error (corrupt_data) says what was wrong and in which field. The world has one
// thread until World::set_threads().
Result<World> load(std::span<const std::byte> bytes);

// 64 bits over everything that the next step depends on.
std::uint64_t state_hash(const World& world);

// The first field in which two worlds differ, with both values: "bodies.awake[3].center.y: 0.5
// against 0.49". Nothing when they are equal.
std::optional<std::string> first_difference(const World& a, const World& b);

}  // namespace jostle::physics
