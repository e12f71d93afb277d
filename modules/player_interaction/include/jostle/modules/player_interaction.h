// SPDX-License-Identifier: MIT
//
// Limits on the forces that a player may apply to a dynamic body. The server and predicting clients
// both call these functions, so their results are bit-identical.
#pragma once

#include <optional>

#include "jostle/physics/world.h"

namespace jostle::modules {

/// Applies an impulse (N s) at a point of the world (m), or at the centre of mass if there is no
/// point. The impulse is limited to a velocity change of 20 m/s. The distance of the point from the
/// centre of mass is limited to 2 m, because a distant point would act as an arbitrarily long
/// lever. Returns the errors of World::apply_impulse().
physics::Status apply_player_impulse(physics::World& world, const physics::BodyState& body,
                                     physics::Vec3 impulse, std::optional<physics::Vec3> point);

/// Applies an impulse (N s) at a point (m, world) and an angular impulse (N m s). No sequence of
/// these impulses makes a body faster than 50 m/s and 60 rad/s. A body that is already faster for
/// other reasons is not slowed down.
physics::Status apply_limited_impulse(physics::World& world, const physics::BodyState& body,
                                      physics::Vec3 impulse, physics::Vec3 point,
                                      physics::Vec3 angular_impulse = {});

/// Returns a joint that holds a body at a point of the world (m). Moving the target of the joint
/// drags the body.
physics::JointDef make_grab_joint(const physics::BodyState& body, physics::Vec3 point);

}  // namespace jostle::modules
