// SPDX-License-Identifier: MIT
//
// Checks of what callers hand in. Each answers with an Error that names the argument, its value and
// its range.
#pragma once

#include <span>
#include <string>

#include "jostle/physics/defs.h"
#include "jostle/physics/ids.h"
#include "jostle/physics/result.h"
#include "physics/src/geometry/def_checks.h"
#include "physics/src/state/world_state.h"

namespace jostle::physics {

Status check_world(const WorldDef& def);
Status check_joint_solver(const char* name, JointSolver solver);
Status check_body(const BodyDef& def);
// What a planar world asks of poses, velocities and shapes besides: all of it in the xy plane.
Status check_flat(const char* name, const Transform& pose);
Status check_flat_body(const BodyDef& def);
Status check_flat_shape(const ShapeDef& def);
Status check_shape(const ShapeDef& def, BodyType type);
Status check_body_type(BodyType type);
// In this world, which may be planar. Of several shapes the error says which: "shapes[2]: ...".
Status check_body_in(const WorldState& world, const BodyDef& def);
Status check_shape_in(const WorldState& world, const ShapeDef& def, BodyType type);
Status check_shapes_in(const WorldState& world, std::span<const ShapeDef> defs, BodyType type);

// What a shape was made from.
ShapeDef def_of(const ShapeRecord& shape);

Status check_id(const WorldState& world, BodyId id);
Status check_id(const WorldState& world, ShapeId id);
Status check_id(const WorldState& world, JointId id);
Status check_id(const WorldState& world, FieldId id);
// That no step is under way; `action` says what would be done in one.
Status check_not_stepping(const WorldState& world, const char* action);

// The geometry as it is stored: a plane's normal has unit length.
Geometry stored(const Geometry& geometry);

}  // namespace jostle::physics
