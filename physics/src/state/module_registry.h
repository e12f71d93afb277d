// SPDX-License-Identifier: MIT
//
// What the registry (jostle/physics/module.h) tells the library's own files besides.
#pragma once

#include <string_view>

#include "jostle/physics/result.h"

namespace jostle::physics {

// Whether it may name a module.
Status check_module_tag(std::string_view tag);

}  // namespace jostle::physics
