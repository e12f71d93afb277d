// SPDX-License-Identifier: MIT
//
// The ASSERT macro, which checks internal invariants. It is disabled in release builds
// (JOSTLE_ASSERT undefined). External input is never asserted: it is always checked, and invalid
// input yields an Error. Include this header in sources and private headers only: a public header
// must not define ASSERT for its users.
#pragma once

#include <cstdio>
#include <cstdlib>

namespace jostle {

/// Prints the failed expression with its position to stderr and aborts. Called by ASSERT.
[[noreturn]] inline void assertion_failed(const char* expression, const char* file, int line) {
    std::fprintf(stderr, "%s:%d: assertion failed: %s\n", file, line, expression);
    std::abort();
}

}  // namespace jostle

#ifdef JOSTLE_ASSERT
#define ASSERT(expression) \
    ((expression) ? void() : ::jostle::assertion_failed(#expression, __FILE__, __LINE__))
#else
#define ASSERT(expression) void(sizeof(!(expression)))
#endif
