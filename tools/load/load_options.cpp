// SPDX-License-Identifier: MIT
#include "tools/load/load_options.h"

#include <cmath>

namespace jostle::load {

// A sunflower: each next one turned by the golden angle.
std::optional<client::AreaOfInterest> LoadOptions::interest_of(int number) const {
    if (interest_radius == 0) return std::nullopt;
    constexpr double golden_angle = 2.39996322972865332;
    const double far = interest_radius * std::sqrt((number + 0.5) / clients),
                 turn = golden_angle * number;
    return client::AreaOfInterest{far * std::cos(turn), far * std::sin(turn), interest_radius};
}

}  // namespace jostle::load
