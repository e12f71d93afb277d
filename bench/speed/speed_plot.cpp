// SPDX-License-Identifier: MIT
#include "bench/speed/speed_plot.h"

#include <algorithm>
#include <functional>

#include "bench/speed/series_style.h"
#include "jostle/analysis/log_axis.h"

namespace jostle::bench {
namespace {

constexpr double width = 1100, left = 80, right = 1080, first_top = 90;
constexpr double bars_bottom = 430, marks_top = 510, marks_bottom = 840, speed_height = 900;
constexpr double growth_bottom = 430, growth_height = 490, growth_gap = 110;
constexpr double error_floor_mm = 1e-3;  // smaller errors are drawn at this value

void draw_title(plots::Svg& svg, const std::string& title, const std::string& note) {
    svg.text({left, 28}, title, {.size = 17, .bold = true});
    svg.text({left, 48}, note, {.color = "#666"});
}

double error_mm(const SpeedRow& row) {
    return std::max(1e3 * row.error_m().value_or(0), error_floor_mm);
}

// The scenes and series in order of first occurrence.
struct Groups {
    std::vector<std::string> scenes, series;
};

Groups groups_of(const std::vector<SpeedRow>& rows) {
    Groups groups;
    for (const SpeedRow& row : rows) {
        series_index(groups.scenes, row.scene + " " + row.name);
        series_index(groups.series, series_name(row.engine, row.threads));
    }
    return groups;
}

void draw_bar(plots::Svg& svg, const SpeedRow& row, plots::SvgPoint top, double bar_width,
              const char* color) {
    svg.rectangle(top, bar_width, bars_bottom - top.y, color);
    const bool checked = row.error_m().has_value();
    std::string label = plots::short_number(row.ms_mean) + " ms";
    if (checked) label += ", " + plots::short_number(error_mm(row)) + " mm";
    svg.text({top.x + 0.5 * bar_width + 3.5, top.y - 4}, label, {.size = 10, .vertical = true});
}

void draw_bars(plots::Svg& svg, const std::vector<SpeedRow>& rows, Groups& groups) {
    std::vector<double> times;
    // The factor 0.9 keeps bars visible whose value is a power of ten.
    for (const SpeedRow& row : rows) times.insert(times.end(), {0.9 * row.ms_mean, row.ms_mean});
    // Space for a label above the highest bar.
    const plots::LogAxis y = plots::log_axis_over(times, bars_bottom, first_top + 85);
    plots::draw_y_axis(svg, y, left, right, "ms per step (mean)");
    const double group_width = (right - left) / static_cast<double>(groups.scenes.size());
    const double slot =
        std::min(0.8 * group_width / static_cast<double>(groups.series.size()), 40.0);
    for (const SpeedRow& row : rows) {
        const std::size_t group = series_index(groups.scenes, row.scene + " " + row.name);
        const std::size_t k = series_index(groups.series, series_name(row.engine, row.threads));
        const double middle = left + (static_cast<double>(group) + 0.5) * group_width;
        const double x =
            middle +
            (static_cast<double>(k) - 0.5 * static_cast<double>(groups.series.size())) * slot;
        draw_bar(svg, row, {x + 1, y.at(row.ms_mean)}, slot - 2,
                 series_style(groups.series, k).color);
    }
    for (std::size_t k = 0; k < groups.scenes.size(); k++)
        svg.text({left + (static_cast<double>(k) + 0.5) * group_width, bars_bottom + 18},
                 groups.scenes[k], {.size = 11, .anchor = plots::TextAnchor::middle});
    svg.line({left, bars_bottom}, {right, bars_bottom}, "#222");
}

void draw_marks(plots::Svg& svg, const std::vector<SpeedRow>& rows, Groups& groups) {
    std::vector<double> times, errors;
    for (const SpeedRow& row : rows) {
        if (!row.error_m()) continue;
        times.push_back(row.ms_mean);
        errors.push_back(error_mm(row));
    }
    const plots::LogAxis x = plots::log_axis_over(times, left, right);
    const plots::LogAxis y = plots::log_axis_over(errors, marks_bottom, marks_top);
    plots::draw_x_axis(svg, x, marks_top, marks_bottom, "ms per step (mean)");
    plots::draw_y_axis(svg, y, left, right, "error at the end, mm");
    svg.text({left, marks_top - 12},
             "Error: the larger of deepest overlap and joint drift at the end (0.001 mm or less is "
             "drawn at 0.001). Down and left is better; letters are scenes.",
             {.size = 11, .color = "#666"});
    for (const SpeedRow& row : rows) {
        if (!row.error_m()) continue;
        const std::size_t k = series_index(groups.series, series_name(row.engine, row.threads));
        const plots::SvgPoint at{x.at(row.ms_mean), y.at(error_mm(row))};
        const SeriesStyle style = series_style(groups.series, k);
        svg.marker(at, style.marker, style.color);
        svg.text({at.x + 7, at.y - 4}, row.scene, {.size = 11, .color = style.color});
    }
}

using GrowthMetric = std::function<double(const GrowthRow&)>;

void draw_curves(plots::Svg& svg, const std::vector<GrowthRow>& rows, double from, double to,
                 const std::string& title, const GrowthMetric& figure) {
    std::vector<double> counts, figures;
    for (const GrowthRow& row : rows) {
        counts.push_back(row.bodies);
        figures.push_back(figure(row));
    }
    const plots::LogAxis x = plots::log_axis_over(counts, from, to);
    const plots::LogAxis y = plots::log_axis_over(figures, growth_bottom, first_top);
    plots::draw_x_axis(svg, x, first_top, growth_bottom, "bodies");
    plots::draw_y_axis(svg, y, from, to, title);
    std::vector<std::string> series;
    std::vector<std::vector<plots::SvgPoint>> curves;
    for (const GrowthRow& row : rows) {
        const std::size_t k = series_index(series, series_name(row.engine, row.threads));
        curves.resize(series.size());
        curves[k].push_back({x.at(row.bodies), y.at(figure(row))});
        const SeriesStyle style = series_style(series, k);
        svg.marker(curves[k].back(), style.marker, style.color);
    }
    for (std::size_t k = 0; k < curves.size(); k++)
        svg.polyline(curves[k], series_style(series, k).color);
}

template <class Row>
std::vector<Row> without_failed(std::vector<Row> rows) {
    std::erase_if(rows, [](const Row& row) { return row.failed.has_value(); });
    return rows;
}

}  // namespace

std::string plot_speed(const std::vector<SpeedRow>& all_rows, const std::string& note) {
    const std::vector<SpeedRow> rows = without_failed(all_rows);
    Groups groups = groups_of(rows);
    plots::Svg svg(width, speed_height);
    draw_title(svg, "Time and error of a step by scene", note);
    draw_legend(svg, groups.series, {right, 72});
    if (!rows.empty()) {
        draw_bars(svg, rows, groups);
        draw_marks(svg, rows, groups);
    }
    return svg.str();
}

std::string plot_growth(const std::vector<GrowthRow>& all_rows, const std::string& note) {
    std::vector<GrowthRow> rows = without_failed(all_rows);
    std::stable_sort(rows.begin(), rows.end(),
                     [](const GrowthRow& a, const GrowthRow& b) { return a.bodies < b.bodies; });
    std::vector<std::string> series;
    for (const GrowthRow& row : rows) series_index(series, series_name(row.engine, row.threads));
    plots::Svg svg(width, growth_height);
    draw_title(svg, "Piles of increasing size", note);
    draw_legend(svg, series, {right, 72});
    if (rows.empty()) return svg.str();
    const double half = 0.5 * (right - left - growth_gap);
    draw_curves(svg, rows, left, left + half, "ms per step (mean)",
                [](const GrowthRow& row) { return row.ms_mean; });
    draw_curves(svg, rows, right - half, right, "bytes per body",
                [](const GrowthRow& row) { return row.bytes_per_body; });
    return svg.str();
}

}  // namespace jostle::bench
