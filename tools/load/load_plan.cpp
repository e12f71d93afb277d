// SPDX-License-Identifier: MIT
#include "tools/load/load_plan.h"

#include <cmath>

namespace jostle::load {

// A sunflower: each next one turned by the golden angle.
std::optional<client::AreaOfInterest> LoadPlan::sight_of(int number) const {
    if (sight == 0) return std::nullopt;
    constexpr double golden_angle = 2.39996322972865332;
    const double far = sight * std::sqrt((number + 0.5) / clients), turn = golden_angle * number;
    return client::AreaOfInterest{far * std::cos(turn), far * std::sin(turn), sight};
}

}  // namespace jostle::load
