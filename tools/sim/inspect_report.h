// SPDX-License-Identifier: MIT
//
// What jostle-sim --inspect says: tables for people, JSON for programs.
#pragma once

#include <string>

#include "tools/sim/inspect.h"

namespace jostle::sim {

std::string to_text(const Inspection& found);
std::string to_json(const Inspection& found);

}  // namespace jostle::sim
