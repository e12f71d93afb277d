// SPDX-License-Identifier: MIT
//
// The bodies of a cloth in a step: which they are, how they respond, and what they are pushed by.
#pragma once

#include "jostle/physics/world.h"
#include "modules/cloth/src/cloth_data.h"

namespace jostle::modules::cloth_detail {

// A body rests below this speed, m/s.
inline constexpr double rest_speed = 0.05;

bool is_attached_to(const Cloth& cloth, physics::BodyId body);
// Fills `bodies`, `attached_body` and `nearby_body`.
void find_bodies(const physics::World& world, Cloth& cloth);
bool is_moving(const physics::World& world, physics::BodyId body);
// Ties the bodies of attachments and recent contacts, so that one group contains them.
void tie_bodies(physics::World& world, Cloth& cloth);
// Notes a contact with a body. Returns whether it is new.
bool touch(Cloth& cloth, const CarriedBody& body);

// Reads the motion of the bodies of a group, and applies the impulses to them.
void read_group(Cloth& cloth, const physics::SubstepContext* group);
void write_group(Cloth& cloth, physics::SubstepContext* group);
// Moves the bodies of a cloth by a part of a sub-step.
void move_bodies(Cloth& cloth, double h);

// Whether impulses change its motion.
bool is_pushed(const CarriedBody& body);
// Motion of a point of a body in the next h seconds without further impulses, m.
physics::Vec3 travel_of(const CarriedBody& body, physics::Vec3 arm, double h);
// Applies an impulse at an arm from the centre.
void push(CarriedBody& body, physics::Vec3 impulse, physics::Vec3 arm);

}  // namespace jostle::modules::cloth_detail
