// SPDX-License-Identifier: MIT
//
// The Engine adapter for Jostle.
#pragma once

#include <memory>

#include "bench/speed/engine.h"

namespace jostle::bench {

std::unique_ptr<Engine> make_jostle_engine();

}  // namespace jostle::bench
