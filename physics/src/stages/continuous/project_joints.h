// SPDX-License-Identifier: MIT
//
// An impact within a step stops a body while the bodies jointed to it continue, so their joint ends
// separate by the distance that the body did not move. This projection moves those bodies back,
// each as little as its mass allows (the nearest configuration in the mass metric in which the
// joints hold), before the separation becomes visible.
#pragma once

#include <cstdint>
#include <span>

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// `placed`: bodies that impacts have placed, which stay where they are as long as the others can
// close the joints; what cannot be pushed stays in any case. Writes: poses of bodies that joints
// tie to them. A body goes back by no more than half of its thinnest shape's inner radius: so
// nothing passes through anything; what is left is the solver's.
void project_joints(StepContext& step, std::span<const std::uint32_t> transformed_shape);

}  // namespace jostle::physics
