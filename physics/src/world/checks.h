// SPDX-License-Identifier: MIT
//
// Argument checks. Each returns an Error that names the argument, its value and its range.
#pragma once

#include <span>
#include <string>

#include "jostle/physics/defs.h"
#include "jostle/physics/ids.h"
#include "jostle/physics/result.h"
#include "physics/src/geometry/geometry_checks.h"
#include "physics/src/state/listener_store.h"
#include "physics/src/state/world_stores.h"

namespace jostle::physics {

Status check_world(const WorldDef& def);
Status check_joint_solver(const char* name, JointSolver solver);
Status check_body(const BodyDef& def);
// Additional conditions of planar worlds: poses, velocities and shapes lie in the xy plane.
Status check_flat(const char* name, const Transform& pose);
Status check_flat_body(const BodyDef& def);
Status check_flat_shape(const ShapeDef& def);
Status check_shape(const ShapeDef& def, BodyType type);
Status check_body_type(BodyType type);
// Checks for a world, which may be planar. For several shapes the error contains the index:
// "shapes[2]: ...".
Status check_body_in(const WorldDef& world, const BodyDef& def);
Status check_shape_in(const WorldDef& world, const ShapeDef& def, BodyType type);
Status check_shapes_in(const WorldDef& world, std::span<const ShapeDef> defs, BodyType type);

// Returns the definition from which a shape was created.
ShapeDef def_of(const ShapeRecord& shape);

Status check_id(const BodyStore& bodies, BodyId id);
Status check_id(const ShapeStore& shapes, ShapeId id);
Status check_id(const JointStore& joints, JointId id);
Status check_id(const FieldStore& fields, FieldId id);
// Checks that no step is in progress. `action` describes the rejected call in the error message.
Status check_not_stepping(const ListenerStore& listeners, const char* action);

// Returns the geometry in stored form: the normal of a plane has unit length.
Geometry stored(const Geometry& geometry);

}  // namespace jostle::physics
