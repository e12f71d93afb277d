// SPDX-License-Identifier: MIT
//
// Serialization of worlds. One field list (src/serialization/field_list.h) defines the fields that
// are saved, hashed and compared, so all three cover the same fields. A loaded world continues with
// the same bits as the saved one in every build with the same arithmetic (arithmetic.h).
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

/// Saves a world as bytes. A const call of the world (world.h). To save an earlier state, use
/// RestorePoint::save().
std::vector<std::byte> save(const World& world);

/// Loads a world from untrusted bytes. The call checks magic, version, length, checksum, every
/// field, and the consistency of the fields. The world uses one thread until World::set_threads()
/// is called.
///
/// Errors: corrupt_data, naming the defect and the field.
Result<World> load(std::span<const std::byte> bytes);

/// Returns the format version of save() and save_module(). A module's state has no version of its
/// own: it can only be loaded by a build with the same format version.
std::uint32_t saved_format_version();

/// Returns true if the bytes begin like a saved world of a format version that load() does not
/// read. load() then fails although the bytes may be intact.
bool has_unsupported_version(std::span<const std::byte> bytes);

/// Returns a 64-bit hash over everything that the next step depends on. A const call of the world.
std::uint64_t state_hash(const World& world);

/// Returns the first field in which two worlds differ, with both values: "bodies.awake[3].center.y:
/// 0.5 against 0.49". Returns nullopt if the worlds are equal. A const call of both worlds.
std::optional<std::string> first_difference(const World& a, const World& b);

}  // namespace jostle::physics
