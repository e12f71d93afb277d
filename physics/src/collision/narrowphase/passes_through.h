// SPDX-License-Identifier: MIT
//
// Whether two moving, rotating shapes overlap at any time of an interval. Triggers use it for
// bodies that pass through within a step.
#pragma once

#include "physics/src/collision/narrowphase/time_of_impact.h"

namespace jostle::physics {

// Supports all kinds. `from` and `until`: fractions of the step at which both sweeps are valid.
// Overlaps of less than 20 um may be missed.
bool passes_through(const SweptShape& a, const SweptShape& b, double from, double until);

}  // namespace jostle::physics
