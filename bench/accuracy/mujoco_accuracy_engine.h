// SPDX-License-Identifier: MIT
//
// MuJoCo adapter of the accuracy benchmark: connected bodies become a kinematic tree, joints that
// close a loop become equality constraints.
#pragma once

#include <memory>

#include "bench/accuracy/accuracy_engine.h"

namespace jostle::bench::accuracy {

std::unique_ptr<Engine> make_mujoco_accuracy_engine();

}  // namespace jostle::bench::accuracy
