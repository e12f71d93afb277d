// SPDX-License-Identifier: MIT
#include "jostle/analysis/log_axis.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace jostle::plots {
namespace {

constexpr const char* grid_color = "#ddd";
constexpr double label_size = 11;

}  // namespace

double LogAxis::at(double value) const {
    const double part = (std::log10(std::max(value, 1e-300)) - low) / (high - low);
    return from + (to - from) * std::clamp(part, 0.0, 1.0);
}

LogAxis log_axis_over(const std::vector<double>& values, double from, double to) {
    double least = 1e300, most = 0;
    for (const double value : values) {
        if (!(value > 0)) continue;
        least = std::min(least, value);
        most = std::max(most, value);
    }
    if (most == 0) return {-1, 1, from, to};
    const int low = static_cast<int>(std::floor(std::log10(least) + 1e-9));
    const int high = static_cast<int>(std::ceil(std::log10(most) - 1e-9));
    return {low, std::max(high, low + 1), from, to};
}

void draw_x_axis(Svg& svg, const LogAxis& x, double top, double bottom, const std::string& title) {
    for (int power = x.low; power <= x.high; power++) {
        const double value = std::pow(10, power), at = x.at(value);
        svg.line({at, top}, {at, bottom}, grid_color);
        svg.text({at, bottom + 15}, short_number(value),
                 {.size = label_size, .anchor = TextAnchor::middle});
    }
    svg.text({0.5 * (x.from + x.to), bottom + 34}, title, {.anchor = TextAnchor::middle});
}

void draw_y_axis(Svg& svg, const LogAxis& y, double left, double rhs, const std::string& title) {
    for (int power = y.low; power <= y.high; power++) {
        const double value = std::pow(10, power), at = y.at(value);
        svg.line({left, at}, {rhs, at}, grid_color);
        svg.text({left - 6, at + 4}, short_number(value),
                 {.size = label_size, .anchor = TextAnchor::end});
    }
    svg.text({left - 52, 0.5 * (y.from + y.to)}, title,
             {.anchor = TextAnchor::middle, .vertical = true});
}

std::string short_number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, value >= 1000 ? "%.0f" : "%.2g", value);
    if (value >= 100 && value < 1000) std::snprintf(text, sizeof text, "%.0f", value);
    return text;
}

}  // namespace jostle::plots
