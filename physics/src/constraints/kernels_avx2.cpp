// SPDX-License-Identifier: MIT
// Built with -mavx2 -mfma (physics/CMakeLists.txt).
#if defined(__x86_64__)
#define JOSTLE_ISA avx2
#include "physics/src/constraints/kernel_table.h"
#endif
