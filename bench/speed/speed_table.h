// SPDX-License-Identifier: MIT
//
// The tables of jostle-bench speed, as text: a heading, then a line for each row as it is measured.
#pragma once

#include <string>

#include "speed/growth.h"
#include "speed/speed_row.h"

namespace jostle::bench {

std::string speed_heading();
std::string speed_line(const SpeedRow& row);

std::string growth_heading();
std::string growth_line(const GrowthRow& row);

}  // namespace jostle::bench
