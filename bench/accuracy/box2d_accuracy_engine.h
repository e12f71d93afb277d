// SPDX-License-Identifier: MIT
//
// Box2D as a peer of the laboratory, for planar scenes: its y is the laboratory's z.
#pragma once

#include <memory>

#include "bench/accuracy/accuracy_engine.h"

namespace jostle::bench::accuracy {

std::unique_ptr<Engine> make_box2d_accuracy_engine();

}  // namespace jostle::bench::accuracy
