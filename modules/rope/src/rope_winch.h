// SPDX-License-Identifier: MIT
//
// Winches: pay rope out at an end or reel it in.
#pragma once

#include "modules/rope/src/rope_data.h"

namespace jostle::modules::rope_detail {

// Moves the ends of a rope by dt seconds of its winches. `links_free`: links that may be added.
void run_winches(Rope& rope, double dt, std::size_t links_free);

}  // namespace jostle::modules::rope_detail
