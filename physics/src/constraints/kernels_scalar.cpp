// SPDX-License-Identifier: MIT
// One float at a time.
#define JOSTLE_SCALAR
#define JOSTLE_ISA scalar
#include "constraints/kernel_table.h"
