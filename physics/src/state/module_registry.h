// SPDX-License-Identifier: MIT
//
// Internal functions of the module registry (jostle/physics/module.h).
#pragma once

#include <string_view>

#include "jostle/physics/result.h"

namespace jostle::physics {

// Checks that the tag is valid.
Status check_module_tag(std::string_view tag);

}  // namespace jostle::physics
