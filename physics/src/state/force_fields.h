// SPDX-License-Identifier: MIT
//
// What the world's force fields do to one body. Reads the world; many threads at once.
#pragma once

#include "jostle/physics/result.h"
#include "physics/src/state/world_state.h"

namespace jostle::physics {

struct FieldPush {
    Vec3 force, torque;  // N, N m about the centre of mass; world
};

// The mean over a sub-step of h seconds that begins at `time`, of a dynamic body that is and moves
// as `now` says. Its locks are not looked at.
FieldPush field_push(const WorldState& world, const BodyWarm& now, const BodyCold& cold,
                     double time, double h);

// m/s^2: how much they accelerate a body where it is now.
double field_acceleration(const WorldState& world, const BodyWarm& now, const BodyCold& cold);

// Whether a field that changes with time acts on the body: it may not fall asleep.
bool is_affected_by_gusts(const WorldState& world, const BodyWarm& now, const BodyCold& cold);

// Whether a field reaches a ball there, whomever it acts on.
bool reaches(const FieldStore& fields, Vec3 center, double radius);
// Whether a field acts on the body where it is.
bool acts_on(const WorldState& world, const FieldDef& field, const BodyWarm& now,
             const BodyCold& cold);

// The error names the number that is out of range.
Status check_field(const FieldDef& field, bool planar);

}  // namespace jostle::physics
