// SPDX-License-Identifier: MIT
#include "jostle/analysis/work_error.h"

#include <time.h>

#include <algorithm>
#include <numeric>

namespace jostle::analysis {

std::optional<double> observed_order(double error, double finer_error, double refinement) {
    if (!(error > 0) || !(finer_error > 0) || !(refinement > 1)) return {};
    return std::log(error / finer_error) / std::log(refinement);
}

std::vector<std::size_t> pareto_set(std::span<const WorkError> runs) {
    std::vector<std::size_t> order(runs.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        if (runs[a].work != runs[b].work) return runs[a].work < runs[b].work;
        return runs[a].error < runs[b].error;
    });
    std::vector<std::size_t> front;
    for (const std::size_t k : order)
        if (front.empty() || runs[k].error < runs[front.back()].error) front.push_back(k);
    return front;
}

std::optional<std::size_t> least_work(std::span<const WorkError> runs, double tolerance) {
    std::optional<std::size_t> best;
    for (std::size_t k = 0; k < runs.size(); k++)
        if (runs[k].error <= tolerance && (!best || runs[k].work < runs[*best].work)) best = k;
    return best;
}

double thread_seconds() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace jostle::analysis
