// SPDX-License-Identifier: MIT
//
// Logarithmic axes: a panel with its grid and numbers.
#pragma once

#include <string>
#include <vector>

#include "jostle/analysis/svg.h"

namespace jostle::plots {

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

// Three digits at most: what fits over a bar.
std::string short_number(double value);

}  // namespace jostle::plots
