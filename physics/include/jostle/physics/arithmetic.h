// SPDX-License-Identifier: MIT
//
// The floating-point arithmetic of this build. It is the only configure-time choice (JOSTLE_FUSED)
// that changes results.
#pragma once

namespace jostle::physics {

/// The floating-point arithmetic of a build.
///
/// All builds with the same arithmetic produce the same bits from the same state and inputs. Builds
/// with different arithmetic produce different bits. Both read each other's saved worlds. Compare
/// this value before comparing state hashes of two programs.
enum class Arithmetic {
    /// The solver rounds each multiply-add once, and denormal floats are flushed to zero. The
    /// default. Fast on processors with AVX2 and FMA and on 64-bit ARM.
    fused,
    /// Every operation is rounded separately, and denormal floats are preserved. Runs on any
    /// processor and on WebAssembly.
    portable,
};

/// Returns the arithmetic of this build.
Arithmetic arithmetic();

/// Returns "fused" or "portable". The string has static storage duration.
const char* arithmetic_name(Arithmetic arithmetic);

}  // namespace jostle::physics
