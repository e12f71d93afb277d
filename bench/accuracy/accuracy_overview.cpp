// SPDX-License-Identifier: MIT
#include "bench/accuracy/accuracy_overview.h"

#include <algorithm>
#include <cstdio>

#include "bench/accuracy/accuracy_engine_kinds.h"
#include "bench/speed/series_style.h"
#include "jostle/analysis/log_axis.h"

namespace jostle::bench::accuracy {
namespace {

constexpr int columns = 4;
constexpr double panel_width = 300, panel_height = 220, top_margin = 85;
constexpr double inner_left = 48, inner_right = 230, inner_top = 30, inner_bottom = 180;
constexpr double smallest_error = 1e-16;  // smaller errors are drawn at this value
constexpr const char* quiet = "#666";

plots::SvgPoint at(const plots::LogAxis& x, const plots::LogAxis& y, const Row& row) {
    return {x.at(row.cpu_us_per_second), y.at(std::max(row.error, smallest_error))};
}

std::vector<Row> of_engine(const std::vector<Row>& rows, const std::string& engine) {
    std::vector<Row> found;
    for (const Row& row : rows)
        if (row.engine == engine) found.push_back(row);
    return found;
}

// Draws the limits of the axes and lines at decades.
void draw_frame(plots::Svg& svg, const plots::LogAxis& x, const plots::LogAxis& y,
                plots::SvgPoint corner) {
    const double left = corner.x + inner_left, right = corner.x + inner_right;
    const double top = corner.y + inner_top, bottom = corner.y + inner_bottom;
    const auto decade = [](int power) { return "1e" + std::to_string(power); };
    const auto line_at = [](const plots::LogAxis& axis, int power) {
        return axis.from + (axis.to - axis.from) * (power - axis.low) / (axis.high - axis.low);
    };
    for (int power = x.low; power <= x.high; power++)
        svg.line({line_at(x, power), top}, {line_at(x, power), bottom}, "#ddd");
    const int stride = (y.high - y.low + 5) / 6;
    for (int power = y.low; power <= y.high; power += stride) {
        svg.line({left, line_at(y, power)}, {right, line_at(y, power)}, "#ddd");
        svg.text({left - 4, line_at(y, power) + 3}, decade(power),
                 {.size = 9, .anchor = plots::TextAnchor::end, .color = quiet});
    }
    svg.text({left, bottom + 12}, decade(x.low), {.size = 9, .color = quiet});
    svg.text({right, bottom + 12}, decade(x.high),
             {.size = 9, .anchor = plots::TextAnchor::end, .color = quiet});
}

// Draws, right of the panel, the engine with the least work for each tolerance.
void draw_least_work(plots::Svg& svg, const Experiment& experiment, const std::vector<Row>& rows,
                     const plots::LogAxis& y, std::vector<std::string>& engines,
                     plots::SvgPoint corner) {
    const double right = corner.x + inner_right;
    for (const double tolerance : experiment.tolerances) {
        const Row* best = nullptr;
        for (const Row& row : rows)
            if (row.error <= tolerance &&
                (!best || row.cpu_us_per_second < best->cpu_us_per_second))
                best = &row;
        const double height = y.at(tolerance);
        char words[64];
        if (best)
            std::snprintf(words, sizeof words, "%.3g", best->cpu_us_per_second);
        else
            std::snprintf(words, sizeof words, "nobody");
        const char* color =
            best ? series_style(engines, series_index(engines, best->engine)).color : quiet;
        svg.line({corner.x + inner_left, height}, {right + 4, height}, color, 0.7);
        svg.text({right + 7, height + 3}, words, {.size = 9, .color = color});
    }
}

void draw_panel(plots::Svg& svg, const Experiment& experiment, const std::vector<Row>& rows,
                std::vector<std::string>& engines, plots::SvgPoint corner) {
    std::vector<double> times, errors = experiment.tolerances;
    for (const Row& row : rows) {
        times.push_back(row.cpu_us_per_second);
        errors.push_back(std::max(row.error, smallest_error));
    }
    const plots::LogAxis x =
        plots::log_axis_over(times, corner.x + inner_left, corner.x + inner_right);
    const plots::LogAxis y =
        plots::log_axis_over(errors, corner.y + inner_bottom, corner.y + inner_top);
    svg.text({corner.x + inner_left, corner.y + 14}, experiment.name, {.bold = true});
    svg.text({corner.x + inner_left, corner.y + 25},
             experiment.measures.substr(0, experiment.measures.find(';')),
             {.size = 9, .color = quiet});
    draw_frame(svg, x, y, corner);
    draw_least_work(svg, experiment, rows, y, engines, corner);
    for (const Row& row : pareto_set(rows, experiment.name)) svg.ring(at(x, y, row), "#222");
    for (const std::string& engine : std::vector<std::string>(engines)) {
        const SeriesStyle style = series_style(engines, series_index(engines, engine));
        std::vector<plots::SvgPoint> points;
        for (const Row& row : pareto_set(of_engine(rows, engine), experiment.name))
            points.push_back(at(x, y, row));
        if (points.empty()) continue;
        svg.polyline(points, style.color);
        for (const plots::SvgPoint point : points) svg.marker(point, style.marker, style.color);
    }
}

}  // namespace

std::string accuracy_overview(const std::vector<Row>& all) {
    std::vector<const Experiment*> shown;
    std::vector<std::string> engines;
    for (const EngineKind& kind : engine_kinds())
        if (std::any_of(all.begin(), all.end(),
                        [&](const Row& r) { return r.engine == kind.name; }))
            series_index(engines, kind.name);
    for (const Experiment& experiment : all_experiments())
        if (std::any_of(all.begin(), all.end(),
                        [&](const Row& r) { return r.scene == experiment.name && r.usable(); }))
            shown.push_back(&experiment);
    const int lines = (static_cast<int>(shown.size()) + columns - 1) / columns;
    plots::Svg svg(columns * panel_width, top_margin + std::max(lines, 1) * panel_height);
    svg.text({20, 24}, "Processor time (us per simulated second, right) against error (up)",
             {.size = 16, .bold = true});
    svg.text(
        {20, 44},
        "Lines: Pareto set of each engine. Rings: overall Pareto set. Right: least time for an "
        "error, in the colour of the engine.",
        {.color = quiet});
    draw_legend(svg, engines, {20 + 150 * static_cast<double>(engines.size()), 68});
    for (std::size_t k = 0; k < shown.size(); k++) {
        std::vector<Row> rows;
        for (const Row& row : all)
            if (row.scene == shown[k]->name && row.usable()) rows.push_back(row);
        draw_panel(svg, *shown[k], rows, engines,
                   {panel_width * static_cast<double>(k % columns),
                    top_margin + panel_height * static_cast<double>(k / columns)});
    }
    return svg.str();
}

}  // namespace jostle::bench::accuracy
