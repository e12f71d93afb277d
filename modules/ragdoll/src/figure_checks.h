// SPDX-License-Identifier: MIT
//
// Checks figure definitions. Errors name the bone.
#pragma once

#include "jostle/modules/ragdoll.h"

namespace jostle::modules {

physics::Status check_figure(const RagdollDef& def);
physics::Status check_muscle(const Muscle& muscle, const std::string& where);

}  // namespace jostle::modules
