// SPDX-License-Identifier: MIT
//
// What all plots of jostle-bench share: a color and a mark for each series, a legend.
#pragma once

#include <string>
#include <vector>

#include "jostle/analysis/svg.h"

namespace jostle::bench {

// What a plot calls one engine at one number of threads.
std::string series_name(const std::string& engine, int threads);

// Adds the name when it is new.
std::size_t series_index(std::vector<std::string>& series, const std::string& name);

// A series looks the same in every plot, whichever others there are.
struct SeriesStyle {
    const char* color;
    int marker;  // of Svg::mark
};
SeriesStyle series_style(const std::vector<std::string>& series, std::size_t index);

void draw_legend(plots::Svg& svg, const std::vector<std::string>& series,
                 plots::SvgPoint right_end);

}  // namespace jostle::bench
