// SPDX-License-Identifier: MIT
//
// Checks of ropes. Errors name the field.
#pragma once

#include "jostle/modules/rope_def.h"
#include "jostle/physics/result.h"

namespace jostle::modules::rope_detail {

inline constexpr double coordinate_max = 1e6;  // m

physics::Status check(const RopeDef& def);
// For a rope with this number of links. Whether the body exists is checked by the caller.
physics::Status check(const RopeAttachment& attachment, std::size_t links);

}  // namespace jostle::modules::rope_detail
