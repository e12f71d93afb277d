// SPDX-License-Identifier: MIT
#include "jostle/physics/arithmetic.h"

namespace jostle::physics {

Arithmetic arithmetic() {
#if defined(JOSTLE_UNFUSED)
    return Arithmetic::portable;
#else
    return Arithmetic::fused;
#endif
}

const char* arithmetic_name(Arithmetic arithmetic) {
    return arithmetic == Arithmetic::fused ? "fused" : "portable";
}

}  // namespace jostle::physics
