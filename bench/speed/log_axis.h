// SPDX-License-Identifier: MIT
//
// Logarithmic axes, and what all plots of jostle-bench speed share: a panel with its grid, a color
// and a mark for each series, a legend.
#pragma once

#include <string>
#include <vector>

#include "speed/svg.h"

namespace jostle::bench {

// From whole decade to whole decade, over pixels.
struct LogAxis {
    int low = 0, high = 1;  // powers of ten
    double from = 0, to = 1;

    double at(double value) const;  // values outside are drawn at the border
};

// Spans the positive ones of the values.
LogAxis log_axis_over(const std::vector<double>& values, double from, double to);

// Grid lines with their numbers, and the axis' title with its unit.
void draw_x_axis(Svg& svg, const LogAxis& x, double top, double bottom, const std::string& title);
void draw_y_axis(Svg& svg, const LogAxis& y, double left, double right, const std::string& title);

// What a plot calls one engine at one number of threads.
std::string series_name(const std::string& engine, int threads);

// Adds the name when it is new.
std::size_t series_index(std::vector<std::string>& series, const std::string& name);

// A series looks the same in every plot, whichever others there are.
struct SeriesStyle {
    const char* color;
    int mark;  // of Svg::mark
};
SeriesStyle series_style(const std::vector<std::string>& series, std::size_t index);

void draw_legend(Svg& svg, const std::vector<std::string>& series, SvgPoint right_end);

// Three digits at most: what fits over a bar.
std::string short_number(double value);

}  // namespace jostle::bench
