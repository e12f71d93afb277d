// SPDX-License-Identifier: MIT
//
// Selection of the instruction set that the inner loops use. By default the library uses the
// fastest available one. A program can select another to measure it or to verify that the results
// are identical.
#pragma once

#include <span>

#include "jostle/physics/result.h"

namespace jostle::physics {

/// Instruction sets of the inner loops. All produce the same bits. Process-wide: change it only
/// while no world is stepping.
enum class InstructionSet {
    /// One float at a time, for verification. On x86-64 processors without AVX2 and FMA it is the
    /// only one and many times slower, unless the build is portable (arithmetic.h).
    scalar,
    /// The instruction set that the compiler assumes for its target: NEON on aarch64; SSE2 on
    /// x86-64, in portable builds only.
    baseline,
    avx2,    ///< eight lanes, with FMA unless the build is portable
    avx512,  ///< contacts with sixteen lanes, everything else with eight lanes as avx2
};

/// Returns "scalar", "baseline", "avx2" or "avx512". The string has static storage duration.
const char* instruction_set_name(InstructionSet set);

/// Returns the instruction sets that this build contains and this processor supports, slowest
/// first.
std::span<const InstructionSet> available_instruction_sets();

/// Returns the instruction set in use.
InstructionSet instruction_set();

/// Selects an instruction set. Errors: failed_precondition if it is not available; the message
/// lists the available ones.
Status use_instruction_set(InstructionSet set);

}  // namespace jostle::physics
