// SPDX-License-Identifier: MIT
//
// What errors are put together from.
#pragma once

#include <cstdio>
#include <string>

#include "jostle/physics/result.h"

namespace jostle::physics {

inline std::string text(double x) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.9g", x);
    return buffer;
}

}  // namespace jostle::physics
