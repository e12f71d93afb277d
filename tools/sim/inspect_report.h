// SPDX-License-Identifier: MIT
//
// Formats the result of jostle-sim --inspect: tables, JSON or CSV.
#pragma once

#include <string>

#include "tools/sim/inspect.h"

namespace jostle::sim {

std::string to_text(const Inspection& found);
std::string to_json(const Inspection& found);

// The residual of the iterative methods after each iteration, one row each. Columns: scene, step
// (of the world), group (index), method, converged (1 or 0, of the method), iteration (from 1),
// residual (relative to b).
std::string residuals_csv(const Inspection& found);

}  // namespace jostle::sim
