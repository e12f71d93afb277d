// SPDX-License-Identifier: MIT
//
// Effect of the world's force fields on one body. Reads the world only; thread-safe during a step.
#pragma once

#include "jostle/physics/result.h"
#include "physics/src/state/world_state.h"

namespace jostle::physics {

struct FieldPush {
    Vec3 force, torque;  // N, N m about the centre of mass, world
};

// Returns the mean over a sub-step of h seconds that starts at `time`, for a dynamic body in the
// state `now`. Locks are not applied.
FieldPush field_push(const WorldState& world, const BodyWarm& now, const BodyCold& cold,
                     double time, double h);

// Returns the acceleration of a body at its current position, m/s^2.
double field_acceleration(const WorldState& world, const BodyWarm& now, const BodyCold& cold);

// Returns whether a time-dependent field acts on the body, which must then stay awake.
bool is_affected_by_gusts(const FieldStore& fields, const ShapeStore& shapes, const BodyWarm& now,
                          const BodyCold& cold);

// Returns whether any field overlaps a sphere.
bool reaches(const FieldStore& fields, Vec3 center, double radius);
// Returns whether a field acts on the body at its position.
bool acts_on(const ShapeStore& shapes, const FieldDef& field, const BodyWarm& now,
             const BodyCold& cold);

// Checks the values of a field. The error names the one that is out of range.
Status check_field(const FieldDef& field, bool planar);

}  // namespace jostle::physics
