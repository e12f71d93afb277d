// SPDX-License-Identifier: MIT
//
// ASSERT checks what must be true if we are right; it is off in release builds. Input from outside
// is never asserted: it is checked always and answered with an Error.
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
