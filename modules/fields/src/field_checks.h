// SPDX-License-Identifier: MIT
//
// Range checks for fields from callers and saved state. An error names the number.
#pragma once

#include <string>

#include "jostle/modules/explosion.h"
#include "jostle/modules/volume_field.h"
#include "jostle/physics/result.h"

namespace jostle::modules::fields_detail {

physics::Status check(const VolumeField& field);
physics::Status check(const Explosion& explosion);
physics::Status check(const Charge& charge);

}  // namespace jostle::modules::fields_detail
