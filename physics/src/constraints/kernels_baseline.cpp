// SPDX-License-Identifier: MIT
// What the compiler takes for granted on the target.
#define JOSTLE_ISA baseline
#include "physics/src/constraints/kernel_table.h"
