// SPDX-License-Identifier: MIT
//
// What both kinds of characters do with what they are asked to do.
#pragma once

#include "modules/character/src/character_data.h"

namespace jostle::modules::character_detail {

// The controls of this step; who strolls walks on.
CharacterControls current_controls(CharacterData& record, double dt);

// A change of the horizontal velocity towards the wanted one, by at most acceleration * dt.
physics::Vec3 acceleration_step(physics::Vec3 velocity, physics::Vec3 desired, double acceleration,
                                double dt);

// Whether it jumps in this step: from the ground, once for each press.
bool should_jump(CharacterData& record, bool jump);

// Turns to where it walks.
void turn_to_walk_direction(CharacterData& record, physics::Vec3 walk, double dt);

void turn_by(CharacterData& record, double angle);

// Makes it crouch or, if there is room, stand; its body's first shape follows.
void update_crouch(physics::World& world, CharacterData& record, bool crouch);

// Gives its body the shape that it has as it stands or crouches.
void update_shape(physics::World& world, const CharacterData& record);

// The velocity of a point of the ground over the coming step, m/s: what its rigid motion and the
// belt on it make of the point.
physics::Vec3 ground_velocity_at(const physics::World& world, const physics::BodyState& ground,
                                 physics::ShapeId shape, physics::Vec3 point, double dt);

// N s to the ground, if that can move.
void apply_ground_impulse(physics::World& world, CharacterData& record, physics::Vec3 impulse);

// Sets off from the ground by a velocity over it, m/s: the ground, if it can move, gets the recoil.
// What of it is the character's own, as seen by the world; the ground has the rest.
physics::Vec3 push_off(physics::World& world, CharacterData& record, physics::Vec3 change);

physics::Quat orientation(const CharacterData& record);

}  // namespace jostle::modules::character_detail
