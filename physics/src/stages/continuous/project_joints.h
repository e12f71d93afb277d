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

// `placed`: sorted bodies that impacts have placed. They stay where they are if the others can
// close the joints; bodies that cannot be pushed never move. Writes: poses of bodies jointed to
// them. Moves a body by at most half of its inner radius, so that it cannot pass through another.
// The solver corrects the remaining error.
void project_joints(StepContext& step, std::span<const std::uint32_t> placed);

}  // namespace jostle::physics
