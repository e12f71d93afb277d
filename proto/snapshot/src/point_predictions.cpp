// SPDX-License-Identifier: MIT
#include "jostle/snapshot/point_predictions.h"

#include <limits>
#include <utility>

#include "jostle/snapshot/predict.h"

namespace jostle::snapshot {
namespace {

constexpr std::uint32_t spacing_max = 255;  // in numbers of states
constexpr unsigned scale_max = 15;

std::uint32_t index_before(const PointState& state, std::uint32_t point) {
    return state.previous.empty() ? point : state.previous[point];
}

// The degrees that an encoder may choose.
std::vector<unsigned> degrees_for(PointForm form, std::uint32_t number,
                                  const PointBaselines& baselines) {
    if (!baselines.baseline) return {no_point_degree};
    std::vector<unsigned> degrees;
    for (unsigned d = 0; d <= point_degree_limit(number, baselines); d++) degrees.push_back(d);
    if (form != PointForm::loose) degrees.push_back(no_point_degree);
    return degrees;
}

// The mean magnitude of the residuals.
double mean_residual(const PointLayout& layout, const PointOrder& order, const PointState& state,
                     const PointPredictions& predictions) {
    const std::size_t components = components_of(layout.form);
    double sum = 0, count = 0;
    const auto add = [&](std::size_t at, std::int64_t offset) {
        const std::int64_t error = state.values[at] - predictions.values[at] - offset / 16;
        sum += static_cast<double>(error < 0 ? -error : error);
        count++;
    };
    for (std::size_t point = 0;
         layout.form == PointForm::loose && point < predictions.depths.size(); point++)
        for (std::size_t c = 0; predictions.depths[point] > 0 && c < components; c++)
            add(point * components + c, 0);
    for (std::size_t level = 0; level < point_levels; level++)
        for (const PointPredictor& point : order.level(level))
            for (std::size_t c = 0; c < components; c++) {
                std::int64_t offset = 0;
                for (std::uint32_t k = 0; k < point.sources; k++) {
                    const std::size_t source = point.from[k] * components + c;
                    offset += point.weight[k] * (state.values[source] - predictions.values[source]);
                }
                add(point.point * components + c, offset);
            }
    return count == 0 ? 0 : sum / count;
}

unsigned scale_of(double mean) {
    unsigned scale = 0;
    while (scale < scale_max && 16 * mean > static_cast<double>(2u << scale)) scale++;
    return scale;
}

}  // namespace

unsigned point_degree_limit(std::uint32_t number, const PointBaselines& b) {
    const auto is_near = [](std::uint32_t a, std::uint32_t b) {
        return a > b && a - b <= spacing_max;
    };
    if (!b.baseline || !b.baseline2 || !is_near(number, b.baseline->number) ||
        !is_near(b.baseline->number, b.baseline2->number))
        return 0;
    return b.baseline3 && is_near(b.baseline2->number, b.baseline3->number) ? 2 : 1;
}

PointPredictions predict_points(std::size_t components, std::uint32_t number, std::size_t count,
                                const std::vector<std::uint32_t>& previous, const PointBaselines& b,
                                unsigned degree) {
    PointPredictions made{.values = std::vector<std::int64_t>(count * components),
                          .depths = std::vector<std::uint8_t>(count)};
    if (!b.baseline || degree == no_point_degree) return made;
    const bool is_linear = b.baseline2 && degree >= 1, is_quadratic = b.baseline3 && degree == 2;
    const std::int64_t dt1 = number - b.baseline->number,
                       dt2 = is_linear ? b.baseline->number - b.baseline2->number : 1,
                       dt3 = is_quadratic ? b.baseline2->number - b.baseline3->number : 1;
    for (std::uint32_t point = 0; point < count; point++) {
        const std::uint32_t one = previous.empty() ? point : previous[point];
        if (one == no_point) continue;
        const std::uint32_t two = b.baseline2 ? index_before(*b.baseline, one) : no_point,
                            three = is_quadratic && two != no_point
                                        ? index_before(*b.baseline2, two)
                                        : no_point;
        made.depths[point] = two == no_point ? 1 : 2;
        for (std::size_t c = 0; c < components; c++) {
            const std::int64_t p1 = b.baseline->values[one * components + c];
            std::int64_t& to = made.values[point * components + c];
            to = p1;
            if (!is_linear || two == no_point) continue;
            const std::int64_t p2 = b.baseline2->values[two * components + c], d = p1 - p2;
            to += scaled(d, dt1, dt2);
            if (three == no_point) continue;
            const std::int64_t p3 = b.baseline3->values[three * components + c];
            to += d - scaled(p2 - p3, dt2, dt3);
        }
    }
    return made;
}

PointPlan plan_points(const PointLayout& layout, const PointOrder& order, const PointState& state,
                      const PointBaselines& baselines) {
    const std::size_t components = components_of(layout.form);
    PointPlan best;
    double least = std::numeric_limits<double>::infinity();
    for (const unsigned degree : degrees_for(layout.form, state.number, baselines)) {
        PointPredictions made =
            predict_points(components, state.number, state.values.size() / components,
                           state.previous, baselines, degree);
        const double error = mean_residual(layout, order, state, made);
        if (error >= least) continue;
        best = {.predictions = std::move(made), .degree = degree, .scale = scale_of(error)};
        least = error;
    }
    return best;
}

}  // namespace jostle::snapshot
