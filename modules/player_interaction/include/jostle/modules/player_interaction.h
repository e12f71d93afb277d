// SPDX-License-Identifier: MIT
//
// What a player's hand may do to a dynamic body. The server's rule, and that of clients which
// foresee what their inputs do: both call this, so that they agree to the bit.
#pragma once

#include <optional>

#include "jostle/physics/world.h"

namespace jostle::modules {

// An impulse (N s) at a point of the world; nothing: the centre of mass. It is cut to what gives
// the body 20 m/s, and its point to 2 m from the centre: far outside it would be a lever of any
// length.
physics::Status apply_player_impulse(physics::World& world, const physics::BodyState& body,
                                     physics::Vec3 impulse, std::optional<physics::Vec3> point);

// However many pushes come, together they make nothing faster than 50 m/s and 60 rad/s; a body that
// is faster for other reasons is not slowed down.
physics::Status apply_limited_impulse(physics::World& world, const physics::BodyState& body,
                                      physics::Vec3 impulse, physics::Vec3 point,
                                      physics::Vec3 angular_impulse = {});

// Holds a body at a point of the world; its target is to be dragged about.
physics::JointDef make_grab_joint(const physics::BodyState& body, physics::Vec3 point);

}  // namespace jostle::modules
