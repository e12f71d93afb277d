// SPDX-License-Identifier: MIT
//
// Winches: pay rope out at an end or reel it in.
#pragma once

#include "modules/rope/src/rope_data.h"

namespace jostle::modules::rope_detail {

// Before a step: adds and removes links next to winches, so that those are between half and three
// halves of the usual length. `links_free`: links that may be added. Stops a winch at the last link
// and at the next attachment.
void keep_link_lengths(Rope& rope, std::size_t links_free);
// In a sub-step of h seconds: changes the rest lengths of the links at winches, by at most half of
// the usual length in a step of dt seconds.
void run_winches(Rope& rope, double h, double dt);

}  // namespace jostle::modules::rope_detail
