// SPDX-License-Identifier: MIT
//
// Number formatting for error messages.
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
