// SPDX-License-Identifier: MIT
//
// The motion of any body within the step: a TOI body moves on its remaining path, any other body as
// the step computed. Part of solve_continuous. Reads the state only.
#pragma once

#include <cstdint>

#include "physics/src/stages/continuous/parabola.h"
#include "physics/src/stages/continuous/toi_state.h"

namespace jostle::physics {

// Velocity at a fraction of the step, which must not precede the body's sweep.
Speed speed_of(const ToiState& state, std::uint32_t body, double fraction);
// The remaining path. If the motion of an awake body is not known, it is extrapolated backwards
// from the velocity.
Sweep sweep_of(const ToiState& state, std::uint32_t body);
// Bounds of the same motion.
BodyDisplacement remaining_motion_of(const ToiState& state, std::uint32_t body);
// The velocity change that bends the path of a body.
Fall fall_of(const ToiState& state, std::uint32_t body);

// A shape on the path of its body.
SweptShape swept_shape(const WorldState& world, std::uint32_t shape, const Sweep& sweep);
// Contains the remaining path of a TOI body, with a margin.
Aabb swept_aabb_of(const WorldState& world, const ToiBody& t);

}  // namespace jostle::physics
