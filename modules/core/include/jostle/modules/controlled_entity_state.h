// SPDX-License-Identifier: MIT
//
// A driven thing, as words of 32 bits that mean the same in another world: how its body moves, then
// what its module knows of it (Module::visit_controlled_entity). Numbers are rounded to single
// floats; ids are told by the names that both worlds have for bodies. So a client goes on with a
// car of the server, with springs pressed in and the gear that is in.
//
// Words: position x y z (m), rotation x y z w, velocity of the centre of mass x y z (m/s), spin x y
// z (rad/s); then fields in the order of the visit. A flag, a whole number of up to 32 bits and a
// length take a word, one of 64 bits two, the low one first; a float or double is a single float; a
// body is its name, or 0; a shape the name of its body and its place among the shapes there; a
// joint is not told.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "jostle/physics/module.h"
#include "jostle/physics/world.h"

namespace jostle::modules {

inline constexpr std::size_t controlled_entity_words_max = 16 * 1024;

using BodyNameLookup = std::function<std::uint32_t(physics::BodyId)>;  // 0: it has none
using BodyLookup = std::function<physics::BodyId(std::uint32_t)>;      // null: it is not here

struct ControlledEntityMotion {
    physics::Transform pose;
    physics::Vec3 linear, angular;  // m/s of the centre of mass, rad/s
};

// After a step. Nothing: the module does not tell of it, or it is too long.
std::optional<std::vector<std::uint32_t>> encode_controlled_entity(physics::World& world,
                                                                   physics::Module& module,
                                                                   physics::BodyId body,
                                                                   const BodyNameLookup& name_of);
// The beginning of such words, which are foreign. Nothing: they are too few, or no numbers.
std::optional<ControlledEntityMotion> decode_controlled_motion(
    std::span<const std::uint32_t> words);
// Between steps: body and module become what was told. False: the words make no sense to the
// module; then it is as it was.
bool apply_controlled_entity(physics::World& world, physics::Module& module, physics::BodyId body,
                             std::span<const std::uint32_t> words, const BodyLookup& body_of);

}  // namespace jostle::modules
