// SPDX-License-Identifier: MIT
// One float at a time.
#define JOSTLE_SCALAR
#define JOSTLE_ISA scalar
#include "physics/src/constraints/kernel_table.h"
