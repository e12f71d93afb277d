// SPDX-License-Identifier: MIT
//
// Bullet adapter of the accuracy benchmark. Its library is loaded with the first engine.
#pragma once

#include <memory>

#include "bench/accuracy/accuracy_engine.h"

// The function that the library exports.
extern "C" jostle::bench::accuracy::Engine* make_bullet_accuracy_engine();

namespace jostle::bench::accuracy {

std::unique_ptr<Engine> open_bullet_engine();

}  // namespace jostle::bench::accuracy
