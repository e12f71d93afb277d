// SPDX-License-Identifier: MIT
//
// The plots of jostle-bench speed, as the text of SVG files.
#pragma once

#include <string>
#include <vector>

#include "bench/speed/growth.h"
#include "bench/speed/speed_row.h"

namespace jostle::bench {

// Top: one bar per scene and engine, milliseconds per step, labelled with the error. Bottom: the
// same rows as marks, time against error, labelled with the scene's letter. Failed rows are
// omitted. The note (machine, compiler) is drawn below the title.
std::string plot_speed(const std::vector<SpeedRow>& rows, const std::string& note);

// Milliseconds per step and bytes per body against the number of bodies.
std::string plot_growth(const std::vector<GrowthRow>& rows, const std::string& note);

}  // namespace jostle::bench
