// SPDX-License-Identifier: MIT
#include "tools/sim/tolerance_check.h"

#include <algorithm>
#include <cmath>

#include "jostle/base/format_text.h"

namespace jostle::sim {

ToleranceCheck::ToleranceCheck(double tolerance, double hz)
    : tolerance_(tolerance),
      steps_per_second_(std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(hz)))) {}

void ToleranceCheck::add(const std::vector<physics::IslandSubsteps>& islands) {
    steps_++;
    for (const physics::IslandSubsteps& island : islands) {
        if (island.error == 0) continue;
        measured_ = true;
        windows_[island.body].entries.push_back({steps_, island.error});
    }
    for (auto& [body, window] : windows_) {
        while (!window.entries.empty() && window.entries.front().step + steps_per_second_ <= steps_)
            window.entries.pop_front();
        if (steps_ >= steps_per_second_) window.worst = std::max(window.worst, mean(window));
    }
}

double ToleranceCheck::mean(const Window& window) const {
    double sum = 0;
    for (const auto& entry : window.entries) sum += entry.error;
    return sum / static_cast<double>(std::min(std::max<std::size_t>(steps_, 1), steps_per_second_));
}

ToleranceVerdict ToleranceCheck::verdict() const {
    ToleranceVerdict verdict{.tolerance = tolerance_, .measured = measured_};
    for (const auto& [body, window] : windows_) {
        const double worst = std::max(window.worst, mean(window));
        verdict.worst = std::max(verdict.worst, worst);
        verdict.islands_over += worst > tolerance_;
    }
    return verdict;
}

std::string to_text(const ToleranceVerdict& verdict) {
    const std::string head = format_text("error tolerance %g m: ", verdict.tolerance);
    if (!verdict.measured) return head + "not measured: no island has contacts or joints\n";
    if (verdict.within()) return head + "kept\n";
    return head + format_text("not kept: %d", verdict.islands_over) +
           (verdict.islands_over == 1 ? " island" : " islands") +
           format_text(", worst %.2g m\n", verdict.worst);
}

}  // namespace jostle::sim
