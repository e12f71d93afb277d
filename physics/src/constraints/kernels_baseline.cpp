// SPDX-License-Identifier: MIT
// What the compiler takes for granted on the target.
#define JOSTLE_ISA baseline
#include "constraints/kernel_table.h"
