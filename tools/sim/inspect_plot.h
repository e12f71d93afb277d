// SPDX-License-Identifier: MIT
//
// Plot of the residual after each iteration.
#pragma once

#include <string>

#include "tools/sim/inspect.h"

namespace jostle::sim {

// SVG text with one curve per iterative method.
std::string plot_residuals(const InspectedGroup& group, const std::string& title);

}  // namespace jostle::sim
