// SPDX-License-Identifier: MIT
//
// The whole public face of the solver library.
#pragma once

#include "jostle/physics/aabb.h"
#include "jostle/physics/compound.h"
#include "jostle/physics/defs.h"
#include "jostle/physics/events.h"
#include "jostle/physics/geometry.h"
#include "jostle/physics/height_field.h"
#include "jostle/physics/hull.h"
#include "jostle/physics/ids.h"
#include "jostle/physics/instruction_set.h"
#include "jostle/physics/joint_defs.h"
#include "jostle/physics/limits.h"
#include "jostle/physics/mat3.h"
#include "jostle/physics/mesh.h"
#include "jostle/physics/profile.h"
#include "jostle/physics/quat.h"
#include "jostle/physics/queries.h"
#include "jostle/physics/restore_point.h"
#include "jostle/physics/result.h"
#include "jostle/physics/scalar.h"
#include "jostle/physics/snapshot.h"
#include "jostle/physics/thread_trials.h"
#include "jostle/physics/transform.h"
#include "jostle/physics/vec3.h"
#include "jostle/physics/world.h"
