// SPDX-License-Identifier: MIT
//
// Style that all plots of jostle-bench share: a color and a marker per series, and a legend.
#pragma once

#include <string>
#include <vector>

#include "jostle/analysis/svg.h"

namespace jostle::bench {

// Name of an engine with a number of threads in plots.
std::string series_name(const std::string& engine, int threads);

// Returns the index of a name; appends it if it is new.
std::size_t series_index(std::vector<std::string>& series, const std::string& name);

// A series has the same style in every plot, independent of the other series.
struct SeriesStyle {
    const char* color;
    int marker;  // of Svg::marker
};
SeriesStyle series_style(const std::vector<std::string>& series, std::size_t index);

void draw_legend(plots::Svg& svg, const std::vector<std::string>& series,
                 plots::SvgPoint right_end);

}  // namespace jostle::bench
