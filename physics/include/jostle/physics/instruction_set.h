// SPDX-License-Identifier: MIT
//
// Which instructions the inner loops use. The library takes the best that the processor has. A
// program may ask for another, to measure it or to prove that the bits are the same. Process-wide:
// change it while no world steps.
#pragma once

#include <span>

#include "jostle/physics/result.h"

namespace jostle::physics {

enum class InstructionSet {
    scalar,  // one float at a time: for proofs. The only one on x86-64 processors without AVX2
             // and FMA, where it is many times slower, unless the build is portable (arithmetic.h)
    baseline,  // what the compiler assumes of its target: NEON on aarch64, SSE2 on x86-64 in a
               // portable build and not in others
    avx2,      // with FMA, unless the build is portable
    avx512,    // contacts sixteen at a time, all else eight at a time, as with avx2
};

const char* instruction_set_name(InstructionSet set);  // "scalar", "baseline", "avx2", "avx512"

// Those that this build has and this processor can run, from slow to fast.
std::span<const InstructionSet> available_instruction_sets();

InstructionSet instruction_set();  // in use

// One that is not available is an error that names those that are.
Status use_instruction_set(InstructionSet set);

}  // namespace jostle::physics
