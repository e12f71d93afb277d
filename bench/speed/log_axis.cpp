// SPDX-License-Identifier: MIT
#include "speed/log_axis.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace jostle::bench {
namespace {

// Told apart by most color-blind readers as well (Okabe and Ito); marks differ besides.
constexpr const char* colors[] = {"#0072b2", "#56b4e9", "#e69f00", "#009e73", "#cc79a7", "#d55e00"};
// Those with a color of their own; the others take the colors that are left, in turn.
constexpr const char* known_series[] = {"jostle", "jostle, 2 threads", "bullet", "ode"};
constexpr std::size_t others_from = std::size(known_series);
constexpr std::size_t colors_for_others = std::size(colors) - others_from;

std::size_t known_index(const std::string& name) {
    const auto found = std::find(std::begin(known_series), std::end(known_series), name);
    return static_cast<std::size_t>(found - std::begin(known_series));
}

constexpr const char* grid_color = "#ddd";
constexpr double legend_step = 150, label_size = 11;

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

void draw_y_axis(Svg& svg, const LogAxis& y, double left, double right, const std::string& title) {
    for (int power = y.low; power <= y.high; power++) {
        const double value = std::pow(10, power), at = y.at(value);
        svg.line({left, at}, {right, at}, grid_color);
        svg.text({left - 6, at + 4}, short_number(value),
                 {.size = label_size, .anchor = TextAnchor::end});
    }
    svg.text({left - 52, 0.5 * (y.from + y.to)}, title,
             {.anchor = TextAnchor::middle, .upright = true});
}

std::string series_name(const std::string& engine, int threads) {
    return threads == 1 ? engine : engine + ", " + std::to_string(threads) + " threads";
}

std::size_t series_index(std::vector<std::string>& series, const std::string& name) {
    const auto found = std::find(series.begin(), series.end(), name);
    const auto index = static_cast<std::size_t>(found - series.begin());
    if (found == series.end()) series.push_back(name);
    return index;
}

SeriesStyle series_style(const std::vector<std::string>& series, std::size_t index) {
    std::size_t style = known_index(series[index]);
    if (style == others_from) {
        const auto others =
            std::count_if(series.begin(), series.begin() + static_cast<std::ptrdiff_t>(index),
                          [](const std::string& name) { return known_index(name) == others_from; });
        style = others_from + static_cast<std::size_t>(others) % colors_for_others;
    }
    return {colors[style], static_cast<int>(style)};
}

void draw_legend(Svg& svg, const std::vector<std::string>& series, SvgPoint right_end) {
    double x = right_end.x - legend_step * static_cast<double>(series.size());
    for (std::size_t k = 0; k < series.size(); k++, x += legend_step) {
        const SeriesStyle style = series_style(series, k);
        svg.mark({x + 6, right_end.y - 4}, style.mark, style.color);
        svg.text({x + 18, right_end.y}, series[k]);
    }
}

std::string short_number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, value >= 1000 ? "%.0f" : "%.2g", value);
    if (value >= 100 && value < 1000) std::snprintf(text, sizeof text, "%.0f", value);
    return text;
}

}  // namespace jostle::bench
