// SPDX-License-Identifier: MIT
//
// ASSERT checks internal invariants; it is disabled in release builds. External input is never
// asserted: it is always checked, and invalid input yields an Error.
#pragma once

namespace jostle::physics {

[[noreturn]] void assertion_failed(const char* expression, const char* file, int line);

}  // namespace jostle::physics

#ifdef JOSTLE_ASSERT
#define ASSERT(expression) \
    ((expression) ? void() : ::jostle::physics::assertion_failed(#expression, __FILE__, __LINE__))
#else
#define ASSERT(expression) void(sizeof(!(expression)))
#endif
