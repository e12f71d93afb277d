// SPDX-License-Identifier: MIT
#include "bench/speed/series_style.h"

#include <algorithm>

namespace jostle::bench {
namespace {

// Distinguishable for most color-blind readers (Okabe and Ito); the markers differ too.
constexpr const char* colors[] = {"#0072b2", "#56b4e9", "#e69f00", "#009e73", "#cc79a7", "#d55e00"};
// Series with a fixed color; the others take the remaining colors in turn.
constexpr const char* known_series[] = {"jostle", "jostle, 2 threads", "bullet", "ode"};
constexpr std::size_t others_from = std::size(known_series);
constexpr std::size_t colors_for_others = std::size(colors) - others_from;

std::size_t known_index(const std::string& name) {
    const auto found = std::find(std::begin(known_series), std::end(known_series), name);
    return static_cast<std::size_t>(found - std::begin(known_series));
}

constexpr double legend_step = 150;

}  // namespace

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

void draw_legend(plots::Svg& svg, const std::vector<std::string>& series,
                 plots::SvgPoint right_end) {
    double x = right_end.x - legend_step * static_cast<double>(series.size());
    for (std::size_t k = 0; k < series.size(); k++, x += legend_step) {
        const SeriesStyle style = series_style(series, k);
        svg.marker({x + 6, right_end.y - 4}, style.marker, style.color);
        svg.text({x + 18, right_end.y}, series[k]);
    }
}

}  // namespace jostle::bench
