// SPDX-License-Identifier: MIT
//
// What is left after each iteration, as a picture.
#pragma once

#include <string>

#include "tools/sim/inspect.h"

namespace jostle::sim {

// SVG text: a curve for each method that iterates.
std::string plot_residuals(const InspectedGroup& group, const std::string& title);

}  // namespace jostle::sim
