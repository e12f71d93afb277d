// SPDX-License-Identifier: MIT
//
// Recorded ticks as a trace to look at: a row of ticks, and below it what each spent its time on,
// stage by stage. A pure function.
#pragma once

#include <span>
#include <string>

#include "server/world/tick_profiler.h"

namespace jostle::server {

// JSON in Chrome's format; time 0 is the first tick's beginning.
std::string tick_trace(const std::string& world, std::span<const TickProfile> ticks);

}  // namespace jostle::server
