// SPDX-License-Identifier: MIT
//
// The tables of jostle-bench speed as text: a heading, then one line per measured row.
#pragma once

#include <string>

#include "bench/speed/growth.h"
#include "bench/speed/server_row.h"
#include "bench/speed/speed_row.h"

namespace jostle::bench {

std::string speed_heading();
std::string speed_line(const SpeedRow& row);

std::string growth_heading();
std::string growth_line(const GrowthRow& row);
// The last lines of the table.
std::string growth_fit_line(const GrowthFit& fit);

std::string server_heading();
std::string server_line(const ServerRow& row);

}  // namespace jostle::bench
