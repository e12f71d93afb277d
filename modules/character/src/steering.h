// SPDX-License-Identifier: MIT
//
// Handling of controls, shared by both kinds of characters.
#pragma once

#include "modules/character/src/character_data.h"

namespace jostle::modules::character_detail {

// Returns the controls of this step. A strolling character keeps walking.
CharacterControls current_controls(CharacterData& record, double dt);

// Returns the change of the horizontal velocity towards the desired one, at most acceleration * dt.
physics::Vec3 acceleration_step(physics::Vec3 velocity, physics::Vec3 desired, double acceleration,
                                double dt);

// Returns true if the character jumps in this step: only from the ground, once per press.
bool should_jump(CharacterData& record, bool jump);

// Turns towards the walking direction.
void turn_to_walk_direction(CharacterData& record, physics::Vec3 walk, double dt);

void turn_by(CharacterData& record, double angle);

// Crouches, or stands up if there is room. Updates the first shape of the body.
void update_crouch(physics::World& world, CharacterData& record, bool crouch);

// Gives the body the shape for the current height.
void update_shape(physics::World& world, const CharacterData& record);

// Velocity of a point of the ground over the coming step, m/s: rigid motion plus the surface
// velocity of the shape (conveyor belt).
physics::Vec3 ground_velocity_at(const physics::World& world, const physics::BodyState& ground,
                                 physics::ShapeId shape, physics::Vec3 point, double dt);

// Applies an impulse, N s, to the ground if it can move.
void apply_ground_impulse(physics::World& world, CharacterData& record, physics::Vec3 impulse);

// Pushes off the ground with a relative velocity, m/s. Dynamic ground receives the recoil. Returns
// the velocity change of the character in the world.
physics::Vec3 push_off(physics::World& world, CharacterData& record, physics::Vec3 change);

physics::Quat orientation(const CharacterData& record);

}  // namespace jostle::modules::character_detail
