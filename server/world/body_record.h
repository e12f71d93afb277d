// SPDX-License-Identifier: MIT
//
// Bodies and joints as bytes from which they can be created again, for the undo log. The bytes are
// a saved world that contains nothing else, so that every property keeps its bits.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "jostle/base/result.h"
#include "jostle/physics/world.h"

namespace jostle::server {

// A larger body, such as a terrain, cannot be recorded.
inline constexpr std::size_t record_bytes_max = 65536;

// The body with its current pose and velocity. Empty: it cannot be recorded.
std::string record_body(const physics::World& world, physics::BodyId body);
// corrupt_data: the bytes are no record of a body.
Result<physics::BodyAndShapes> body_of_record(std::string_view bytes);

// Everything except the two bodies. Empty: the joint cannot be recorded.
std::string record_joint(const physics::JointDef& joint);
// corrupt_data: the bytes are no record of a joint.
Result<physics::JointDef> joint_of_record(std::string_view bytes);

// The definition of a body with its shapes; the body exists.
physics::BodyAndShapes definition_of(const physics::World& world, physics::BodyId body);

}  // namespace jostle::server
