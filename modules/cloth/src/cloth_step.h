// SPDX-License-Identifier: MIT
//
// The step of one cloth. Called by Cloths in this order: begin_step(), advance() per sub-step,
// end_step(). advance() of different cloths may run concurrently if no group contains both.
#pragma once

#include "jostle/physics/world.h"
#include "modules/cloth/src/cloth_data.h"

namespace jostle::modules::cloth_detail {

// A sub-step: of a group, or of the world for a cloth without bodies.
struct ClothSubstep {
    double h = 0;  // s
    physics::Vec3 gravity = {};
    physics::SubstepContext* group = nullptr;
};

void wake(Cloth& cloth);
// Collects the shapes around the cloth and wakes a disturbed one.
void begin_step(physics::World& world, Cloth& cloth, double dt);
// Then, if it is awake and its companions are known: ties and finds the bodies.
void find_bodies(physics::World& world, Cloth& cloth, double dt);
// Advances a leading cloth and its companions by the sub-step, in parts. `count` is the number of
// sub-steps of the step.
void advance(Cloth& cloth, const ClothSubstep& substep, int count);
// Gives bodies outside of a group their impulses and puts a resting cloth to sleep.
void end_step(physics::World& world, Cloth& cloth, double dt);

}  // namespace jostle::modules::cloth_detail
