// SPDX-License-Identifier: MIT
//
// Which instructions the inner loops use. The library takes the best that the processor has; a
// program may ask for another to measure it or to prove that the bits are the same. Process-wide;
// may be changed between steps of any world.
#pragma once

#include <span>

#include "jostle/physics/result.h"

namespace jostle::physics {

enum class InstructionSet {
    scalar,    // one float at a time: for proofs, and for x86-64 processors without AVX2 and FMA
               // (older than x86-64-v3), on which it is the only one and many times slower
    baseline,  // what the target's compiler assumes: NEON on aarch64. Not on x86-64
    avx2,      // with FMA
    avx512,    // AVX-512: contacts sixteen at a time, all else on 256-bit registers
};

const char* instruction_set_name(InstructionSet set);  // "scalar", "baseline", "avx2", "avx512"

// Those that this build has and this processor can run, from slow to fast.
std::span<const InstructionSet> available_instruction_sets();

InstructionSet instruction_set();  // in use

// An error names the sets that are available.
Status use_instruction_set(InstructionSet set);

}  // namespace jostle::physics
