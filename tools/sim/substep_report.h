// SPDX-License-Identifier: MIT
//
// Sub-steps of the islands and their estimated errors.
#pragma once

#include <string>
#include <vector>

#include "jostle/physics/physics.h"

namespace jostle::sim {

// One line per number of sub-steps, then the islands with the largest errors. Reports if there are
// no islands.
std::string to_text(const std::vector<physics::IslandSubsteps>& island_substeps);
std::string to_json(const std::vector<physics::IslandSubsteps>& island_substeps);

}  // namespace jostle::sim
