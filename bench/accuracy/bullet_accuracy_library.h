// SPDX-License-Identifier: MIT
//
// Bullet as a peer of the laboratory. Its library is opened when the first engine is made.
#pragma once

#include <memory>

#include "bench/accuracy/accuracy_engine.h"

// What the library exports.
extern "C" jostle::bench::accuracy::Engine* make_bullet_accuracy_engine();

namespace jostle::bench::accuracy {

std::unique_ptr<Engine> open_bullet_engine();

}  // namespace jostle::bench::accuracy
