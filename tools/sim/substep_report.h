// SPDX-License-Identifier: MIT
//
// Which islands took how many sub-steps, and how exact that is.
#pragma once

#include <string>
#include <vector>

#include "jostle/physics/physics.h"

namespace jostle::sim {

// A line for each number of sub-steps, then the islands that are furthest off; a line that
// says so when there are none.
std::string to_text(const std::vector<physics::IslandSubsteps>& island_substeps);
std::string to_json(const std::vector<physics::IslandSubsteps>& island_substeps);

}  // namespace jostle::sim
