// SPDX-License-Identifier: MIT
//
// What jostle-sim --converge says of its runs: a table with a verdict for people, JSON for
// programs.
#pragma once

#include <string>

#include "tools/sim/converge.h"

namespace jostle::sim {

std::string to_text(const Convergence& found);
std::string to_json(const Convergence& found);

}  // namespace jostle::sim
