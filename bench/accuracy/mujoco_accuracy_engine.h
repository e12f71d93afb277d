// SPDX-License-Identifier: MIT
//
// MuJoCo as a peer of the laboratory: what hangs together becomes a tree of bodies, what closes a
// loop an equality.
#pragma once

#include <memory>

#include "bench/accuracy/accuracy_engine.h"

namespace jostle::bench::accuracy {

std::unique_ptr<Engine> make_mujoco_accuracy_engine();

}  // namespace jostle::bench::accuracy
