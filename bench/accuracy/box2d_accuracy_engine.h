// SPDX-License-Identifier: MIT
//
// Box2D adapter of the accuracy benchmark, for planar scenes. Its y axis is the z axis of the
// scene.
#pragma once

#include <memory>

#include "bench/accuracy/accuracy_engine.h"

namespace jostle::bench::accuracy {

std::unique_ptr<Engine> make_box2d_accuracy_engine();

}  // namespace jostle::bench::accuracy
