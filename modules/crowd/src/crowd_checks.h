// SPDX-License-Identifier: MIT
//
// Ranges of the descriptions of a crowd. Each function returns invalid_argument and names the
// field.
#pragma once

#include "modules/crowd/src/crowd_data.h"

namespace jostle::modules::crowd_detail {

physics::Status check(const CrowdSettings& settings);
physics::Status check(const AgentDef& def);
physics::Status check(const FlockDef& flock);
physics::Status check(const RouteGrid& grid);
physics::Status check(const Wall& wall);
physics::Status check(const GoalDef& goal);
// `kind`: of the agent; `goals`: number of goals.
physics::Status check(const Destination& destination, AgentKind kind, std::size_t goals);

}  // namespace jostle::modules::crowd_detail
