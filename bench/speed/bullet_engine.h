// SPDX-License-Identifier: MIT
//
// Bullet 3 behind the Engine interface. Only in builds that found its library.
#pragma once

#include <memory>

#include "bench/speed/engine.h"

namespace jostle::bench {

std::unique_ptr<Engine> make_bullet_engine();

}  // namespace jostle::bench
