// SPDX-License-Identifier: MIT
//
// Formats the result of jostle-sim --inspect: tables, or JSON.
#pragma once

#include <string>

#include "tools/sim/inspect.h"

namespace jostle::sim {

std::string to_text(const Inspection& found);
std::string to_json(const Inspection& found);

}  // namespace jostle::sim
