// SPDX-License-Identifier: MIT
//
// How this build rounds: the one choice at configure time (JOSTLE_FUSED) that results depend on.
// The same state and the same inputs give the same bits in all builds of one arithmetic, and others
// in those of the other. A saved world is read by both. Who compares hashes of two programs
// compares this first.
#pragma once

namespace jostle::physics {

enum class Arithmetic {
    fused,  // The solver's multiply-adds are rounded once, denormal floats are zero. The default;
            // needs AVX2 and FMA, or 64-bit ARM, to be fast
    portable,  // Every operation is rounded, denormal floats are kept: what any processor and
               // WebAssembly can do
};

Arithmetic arithmetic();  // of this build

const char* arithmetic_name(Arithmetic arithmetic);  // "fused", "portable"

}  // namespace jostle::physics
