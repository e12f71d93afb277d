// SPDX-License-Identifier: MIT
// Built with AVX-512 VL on 256-bit registers: 32 registers, and masks (physics/CMakeLists.txt).
#if defined(__x86_64__)
#define JOSTLE_ISA avx512
#include "physics/src/constraints/kernel_table.h"
#endif
