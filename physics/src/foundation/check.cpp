// SPDX-License-Identifier: MIT
#include "physics/src/foundation/check.h"

#include <cstdio>
#include <cstdlib>

namespace jostle::physics {

void assertion_failed(const char* expression, const char* file, int line) {
    std::fprintf(stderr, "%s:%d: assertion failed: %s\n", file, line, expression);
    std::abort();
}

}  // namespace jostle::physics
