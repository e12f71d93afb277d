// SPDX-License-Identifier: MIT
#include "tools/sim/inspect_plot.h"

#include <algorithm>
#include <cmath>

#include "jostle/analysis/log_axis.h"

namespace jostle::sim {
namespace {

constexpr double width = 960, height = 560, left = 90, right = 640, top = 70, bottom = 500;
constexpr double least_residual = 1e-16, most_residual = 1e6;  // values outside are clamped
// Distinguishable with most forms of color blindness (Okabe and Ito).
constexpr const char* colors[] = {"#0072b2", "#d55e00", "#009e73"};

}  // namespace

std::string plot_residuals(const InspectedGroup& group, const std::string& title) {
    plots::Svg svg(width, height);
    svg.text({left, 28}, title, {.size = 16, .bold = true});
    svg.text({left, 48},
             std::to_string(group.problem.count) + " rows, rank " +
                 std::to_string(group.analysis.rank) + ", condition number " +
                 plots::short_number(group.analysis.condition),
             {.color = "#666"});
    std::vector<double> residuals, iterations = {1};
    for (const linear_systems::Solution& solution : group.solutions)
        for (const double residual : solution.residuals) {
            residuals.push_back(std::clamp(residual, least_residual, most_residual));
            iterations.push_back(static_cast<double>(solution.iterations()));
        }
    const plots::LogAxis x = plots::log_axis_over(iterations, left, right),
                         y = plots::log_axis_over(residuals, bottom, top);
    plots::draw_x_axis(svg, x, top, bottom, "iteration");
    plots::draw_y_axis(svg, y, left, right, "residual, relative to b");
    std::size_t drawn = 0;
    double label = top;
    for (const linear_systems::Solution& solution : group.solutions) {
        if (solution.residuals.empty()) continue;
        std::vector<plots::SvgPoint> points;
        for (std::size_t k = 0; k < solution.residuals.size(); k++)
            points.push_back(
                {x.at(static_cast<double>(k + 1)),
                 y.at(std::clamp(solution.residuals[k], least_residual, most_residual))});
        const char* color = colors[drawn++ % std::size(colors)];
        svg.polyline(points, color);
        svg.marker({right + 20, label + 6}, 0, color);
        svg.text({right + 32, label + 10}, std::string(name_of(solution.method)) +
                                               (solution.converged ? "" : ", not converged"));
        label += 22;
    }
    return svg.str();
}

}  // namespace jostle::sim
