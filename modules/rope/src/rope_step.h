// SPDX-License-Identifier: MIT
//
// One rope in a step of the world.
#pragma once

#include <span>

#include "jostle/physics/force_fields.h"
#include "jostle/physics/world.h"
#include "modules/rope/src/rope_data.h"

namespace jostle::modules::rope_detail {

// Where a sub-step of a rope gets its time and its bodies from.
struct RopeSubstep {
    double h = 0;                                    // s
    physics::Vec3 gravity;                           // m/s^2
    double time = 0;                                 // s, of the world at the start of the sub-step
    std::span<const physics::FieldDef> fields = {};  // of the world
    physics::SubstepContext* group = nullptr;        // null: no dynamic bodies move with the rope
};

double greatest_speed(const Strand& strand);  // m/s
physics::Aabb bounds_of(const Rope& rope, double margin);
// How far from its nodes the rope may touch something in the step, m.
double reach_of(const Rope& rope, double dt, physics::Vec3 gravity);

// Before a step: finds the shapes near the rope, and wakes it if something near it moves or if the
// world has force fields.
void begin_step(physics::World& world, Rope& rope, double dt, bool in_fields);
// Then, if it is awake and its companions are known: ties and finds its bodies. Resting ropes do
// not wake bodies.
void find_bodies(physics::World& world, Rope& rope, double dt);
// Advances a leading rope with its companions and gives their bodies the impulses. Divides the
// sub-step so that each takes at least RopeDef::substeps per step; `count` is the number of
// sub-steps of the step.
void advance(Rope& rope, const RopeSubstep& substep, int count);
// After a step: gives the impulses to bodies that are in no group of the rope, and puts the rope to
// sleep. Ropes do not sleep in worlds with force fields.
void end_step(physics::World& world, Rope& rope, double dt, bool in_fields);
// Wakes a rope that something changes.
void wake(Rope& rope);

}  // namespace jostle::modules::rope_detail
