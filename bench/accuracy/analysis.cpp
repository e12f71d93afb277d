// SPDX-License-Identifier: MIT
#include "bench/accuracy/analysis.h"
#include "bench/accuracy/experiment_list.h"

#include <algorithm>
#include <cmath>

#include "jostle/analysis/work_error.h"

namespace jostle::bench::accuracy {
namespace {

using analysis::WorkError;

constexpr double missing = 0.01;

std::vector<Row> by_rate(const std::vector<Row>& rows, const std::string& scene,
                         const std::string& engine, const std::string& mode) {
    std::vector<Row> chosen;
    for (const Row& row : rows)
        if (row.scene == scene && row.engine == engine && row.mode == mode) chosen.push_back(row);
    std::sort(chosen.begin(), chosen.end(),
              [](const Row& a, const Row& b) { return a.rate_hz < b.rate_hz; });
    return chosen;
}

std::vector<WorkError> work_errors(const std::vector<Row>& rows) {
    std::vector<WorkError> all;
    for (const Row& row : rows) all.push_back({row.cpu_us_per_second, row.error});
    return all;
}

// The cheapest row of several engines: of `us` or of all others.
std::optional<Row> cheapest(const std::vector<Row>& rows, const std::string& scene,
                            double tolerance, const std::string& us, bool ours) {
    std::vector<Row> candidates;
    for (const Row& row : rows)
        if (row.scene == scene && (row.engine == us) == ours && row.usable())
            candidates.push_back(row);
    const auto best = analysis::least_work(work_errors(candidates), tolerance);
    if (!best) return {};
    return candidates[*best];
}

bool has_peer(const std::vector<Row>& rows, const std::string& scene, const std::string& us) {
    return std::any_of(rows.begin(), rows.end(), [&](const Row& row) {
        return row.scene == scene && row.engine != us && row.unsupported.empty();
    });
}

}  // namespace

std::vector<Order> observed_orders(const std::vector<Row>& rows, const std::string& scene,
                                   const std::string& engine, const std::string& mode) {
    const std::vector<Row> chosen = by_rate(rows, scene, engine, mode);
    std::vector<Order> orders;
    for (std::size_t k = 1; k < chosen.size(); k++) {
        const Row &slow = chosen[k - 1], &fast = chosen[k];
        if (!slow.usable() || !fast.usable()) continue;
        const auto order =
            analysis::observed_order(slow.error, fast.error, fast.rate_hz / slow.rate_hz);
        if (order) orders.push_back({slow.rate_hz, fast.rate_hz, *order});
    }
    return orders;
}

std::optional<Row> least_work(const std::vector<Row>& rows, const std::string& scene,
                              const std::string& engine, double tolerance) {
    return cheapest(rows, scene, tolerance, engine, true);
}

std::vector<Row> pareto_set(const std::vector<Row>& rows, const std::string& scene) {
    std::vector<Row> candidates;
    for (const Row& row : rows)
        if (row.scene == scene && row.usable()) candidates.push_back(row);
    std::vector<Row> front;
    for (const std::size_t k : analysis::pareto_set(work_errors(candidates)))
        front.push_back(candidates[k]);
    return front;
}

Score score_of(const std::vector<Row>& rows, const std::string& us, Scope scope) {
    Score score;
    double logs = 0, both_logs = 0;
    for (const Experiment& experiment : all_experiments()) {
        if (experiment.family.empty() != (scope == Scope::fixed)) continue;
        if (!has_peer(rows, experiment.name, us)) continue;
        for (const double tolerance : experiment.tolerances) {
            Comparison found{.scene = experiment.name,
                             .tolerance = tolerance,
                             .ours = cheapest(rows, experiment.name, tolerance, us, true),
                             .best_peer = cheapest(rows, experiment.name, tolerance, us, false)};
            if (!found.ours && !found.best_peer) continue;
            found.ratio = !found.ours ? missing
                          : !found.best_peer
                              ? 1 / missing
                              : found.best_peer->cpu_us_per_second / found.ours->cpu_us_per_second;
            logs += std::log(found.ratio);
            if (found.ours && found.best_peer) {
                both_logs += std::log(found.ratio);
                score.both_count++;
            }
            score.comparisons.push_back(std::move(found));
        }
    }
    if (score.both_count > 0) score.both_mean = std::exp(both_logs / score.both_count);
    if (!score.comparisons.empty())
        score.mean = std::exp(logs / static_cast<double>(score.comparisons.size()));
    return score;
}

}  // namespace jostle::bench::accuracy
