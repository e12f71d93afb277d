// SPDX-License-Identifier: MIT
#include "bench/accuracy/accuracy_plot.h"

#include <algorithm>

#include "bench/accuracy/analysis.h"
#include "bench/speed/series_style.h"
#include "jostle/analysis/log_axis.h"

namespace jostle::bench::accuracy {
namespace {

constexpr double width = 900, height = 640, left = 90, right = 870, top = 90, bottom = 580;
constexpr double least_error = 1e-16;  // smaller errors are drawn at this value

struct Curve {
    std::string engine, mode;
    std::vector<plots::SvgPoint> points;
};

}  // namespace

std::string plot_accuracy(const Experiment& experiment, const std::vector<Row>& all_rows,
                          const std::string& note) {
    std::vector<Row> rows;
    for (const Row& row : all_rows)
        if (row.scene == experiment.name && row.usable()) rows.push_back(row);
    plots::Svg svg(width, height);
    svg.text({left, 28}, experiment.name + ": " + experiment.about, {.size = 16, .bold = true});
    svg.text({left, 48}, note, {.color = "#666"});
    if (rows.empty()) return svg.str();

    std::vector<double> times, errors;
    std::vector<std::string> engines;
    for (const Row& row : rows) {
        times.push_back(row.cpu_us_per_second);
        errors.push_back(std::max(row.error, least_error));
        series_index(engines, row.engine);
    }
    const plots::LogAxis x = plots::log_axis_over(times, left, right),
                         y = plots::log_axis_over(errors, bottom, top);
    plots::draw_x_axis(svg, x, top, bottom, "CPU time, us per simulated second");
    plots::draw_y_axis(svg, y, left, right,
                       "error: " + experiment.measures.substr(0, experiment.measures.find(';')));
    draw_legend(svg, engines, {right, 72});

    std::vector<Curve> curves;
    for (const Row& row : rows) {
        const plots::SvgPoint at{x.at(row.cpu_us_per_second),
                                 y.at(std::max(row.error, least_error))};
        if (curves.empty() || curves.back().engine != row.engine || curves.back().mode != row.mode)
            curves.push_back({row.engine, row.mode, {}});
        curves.back().points.push_back(at);
        const SeriesStyle style = series_style(engines, series_index(engines, row.engine));
        svg.marker(at, style.marker, style.color);
    }
    for (const Row& row : pareto_set(rows, experiment.name))
        svg.ring({x.at(row.cpu_us_per_second), y.at(std::max(row.error, least_error))}, "#222");
    for (const double tolerance : experiment.tolerances) {
        const Row* best = nullptr;
        for (const Row& row : rows)
            if (row.error <= tolerance &&
                (!best || row.cpu_us_per_second < best->cpu_us_per_second))
                best = &row;
        if (!best) continue;
        const double height = y.at(tolerance);
        const SeriesStyle style = series_style(engines, series_index(engines, best->engine));
        svg.line({left, height}, {right, height}, style.color, 0.7);
        svg.text({right, height - 4},
                 "least work for " + plots::short_number(tolerance) + ": " +
                     plots::short_number(best->cpu_us_per_second) + ", " + best->engine,
                 {.size = 10, .anchor = plots::TextAnchor::end, .color = style.color});
    }
    for (const Curve& curve : curves) {
        const SeriesStyle style = series_style(engines, series_index(engines, curve.engine));
        svg.polyline(curve.points, style.color);
        svg.text({curve.points.back().x + 7, curve.points.back().y - 4}, curve.mode,
                 {.size = 10, .color = style.color});
    }
    return svg.str();
}

}  // namespace jostle::bench::accuracy
