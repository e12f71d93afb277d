// SPDX-License-Identifier: MIT
//
// Logarithmic axes of a plot, with grid and numbers.
#pragma once

#include <string>
#include <vector>

#include "jostle/analysis/svg.h"

namespace jostle::plots {

/// Maps whole decades to a range of pixels.
struct LogAxis {
    int low = 0, high = 1;  ///< powers of ten
    double from = 0, to = 1;

    /// pixel of a value; values outside the range are drawn at the border
    double at(double value) const;
};

/// Returns an axis that spans the positive values.
LogAxis log_axis_over(const std::vector<double>& values, double from, double to);

/// Draws the grid lines with their numbers, and the title of the axis with its unit.
void draw_x_axis(Svg& svg, const LogAxis& x, double top, double bottom, const std::string& title);
void draw_y_axis(Svg& svg, const LogAxis& y, double left, double right, const std::string& title);

/// Formats a number with at most three digits, for labels of bars.
std::string short_number(double value);

}  // namespace jostle::plots
