// SPDX-License-Identifier: MIT
//
// What an impact between steps stops leaves those that joints tie to it to go on: their ends part
// by all that it has not gone. Those are taken back to it, each as little as its mass allows (the
// nearest place, in the metric of the masses, at which the joints hold), before anybody sees them
// apart.
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
