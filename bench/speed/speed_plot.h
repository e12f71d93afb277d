// SPDX-License-Identifier: MIT
//
// The plots of jostle-bench speed, as the text of SVG files.
#pragma once

#include <string>
#include <vector>

#include "bench/speed/growth.h"
#include "bench/speed/speed_row.h"

namespace jostle::bench {

// Above: a bar per scene and engine, milliseconds a step, with the error over it. Below: the same
// rows as marks, time against error, named by the scene's letter. Failed rows are left out. The
// note (machine, compiler) stands under the title.
std::string plot_speed(const std::vector<SpeedRow>& rows, const std::string& note);

// Milliseconds a step and bytes a body over the number of bodies.
std::string plot_growth(const std::vector<GrowthRow>& rows, const std::string& note);

}  // namespace jostle::bench
