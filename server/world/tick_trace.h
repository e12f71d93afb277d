// SPDX-License-Identifier: MIT
//
// Converts recorded ticks to a trace with a row of ticks and a row of their stages. A pure
// function.
#pragma once

#include <span>
#include <string>

#include "server/world/tick_profiler.h"

namespace jostle::server {

// JSON in Chrome's trace format; time 0 is the start of the first tick.
std::string tick_trace(const std::string& world, std::span<const TickProfile> ticks);

}  // namespace jostle::server
