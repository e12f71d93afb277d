// SPDX-License-Identifier: MIT
//
// Formats the result of jostle-sim --converge: a table with a verdict, or JSON.
#pragma once

#include <string>

#include "tools/sim/converge.h"

namespace jostle::sim {

std::string to_text(const Convergence& found);
std::string to_json(const Convergence& found);

}  // namespace jostle::sim
