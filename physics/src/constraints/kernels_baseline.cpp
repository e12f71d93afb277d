// SPDX-License-Identifier: MIT
// The default instruction set of the compilation target.
#define JOSTLE_ISA baseline
#include "physics/src/constraints/kernel_table.h"
