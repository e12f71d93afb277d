// SPDX-License-Identifier: MIT
//
// State of a controlled entity, such as a car or a character, as 32-bit words that another world
// can apply: the motion of its body, then the fields of its module
// (Module::visit_controlled_entity). Clients use it to predict an entity of the server, including
// suspension travel and the selected gear.
//
// Numbers are rounded to single precision. Bodies are identified by names that both worlds know.
// The words are:
// - position x y z (m), rotation x y z w, velocity of the centre of mass x y z (m/s), angular
//   velocity x y z (rad/s);
// - the module's fields in visiting order. A flag, an integer of up to 32 bits and an array length
//   take one word. A 64-bit integer takes two, the low word first. A float or double is one
//   single-precision float. A body is its name, or 0. A shape is the name of its body and its index
//   among the shapes of that body. Joints are not encoded.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "jostle/physics/module.h"
#include "jostle/physics/world.h"

namespace jostle::modules {

/// Maximum number of words of an encoded entity. encode_controlled_entity() fails above it.
inline constexpr std::size_t controlled_entity_words_max = 16 * 1024;

/// Returns the name of a body, 0 if it has none.
using BodyNameLookup = std::function<std::uint32_t(physics::BodyId)>;
/// Returns the body with a name; a null id if this world has no such body.
using BodyLookup = std::function<physics::BodyId(std::uint32_t)>;

/// Motion of the body of a controlled entity.
struct ControlledEntityMotion {
    physics::Transform pose;        ///< of the body's origin
    physics::Vec3 linear, angular;  ///< m/s, of the centre of mass; rad/s
};

/// Encodes the state of the entity that `body` represents. Call between steps. Returns nullopt if
/// the body does not exist, if the module does not publish this entity, or if it needs more than
/// controlled_entity_words_max words.
std::optional<std::vector<std::uint32_t>> encode_controlled_entity(physics::World& world,
                                                                   physics::Module& module,
                                                                   physics::BodyId body,
                                                                   const BodyNameLookup& name_of);
/// Decodes the motion at the start of encoded words. The words may come from an untrusted source.
/// Returns nullopt if there are fewer than 13 words or if a number is not finite or out of range:
/// positions to 1e7 m, velocities to 1e4 m/s and rad/s, a rotation of unit length within about 5 %.
std::optional<ControlledEntityMotion> decode_controlled_motion(
    std::span<const std::uint32_t> words);
/// Applies encoded words to `body` and its module. Call between steps. The words may come from an
/// untrusted source. Returns false if the module rejects the words; the module and the body are
/// then unchanged.
bool apply_controlled_entity(physics::World& world, physics::Module& module, physics::BodyId body,
                             std::span<const std::uint32_t> words, const BodyLookup& body_of);

}  // namespace jostle::modules
