// SPDX-License-Identifier: MIT
#pragma once

#include "jostle/modules/cloth_def.h"
#include "jostle/physics/result.h"

namespace jostle::modules::cloth_detail {

// Greatest coordinate of a cloth, m.
inline constexpr double coordinate_max = 1e6;
// Greatest component of a wind, m/s.
inline constexpr double speed_max = 1e4;

// Errors: invalid_argument, naming the field.
physics::Status check(const ClothDef& def);
physics::Status check(const ClothAttachment& attachment, std::size_t vertices);

}  // namespace jostle::modules::cloth_detail
