// SPDX-License-Identifier: MIT
#include "tools/load/load_options.h"

#include <cmath>

namespace jostle::load {

// Sunflower distribution: successive points are rotated by the golden angle.
std::optional<client::AreaOfInterest> LoadOptions::interest_of(int number) const {
    if (interest_radius == 0) return std::nullopt;
    constexpr double golden_angle = 2.39996322972865332;
    const double distance = interest_radius * std::sqrt((number + 0.5) / clients),
                 angle = golden_angle * number;
    return client::AreaOfInterest{distance * std::cos(angle), distance * std::sin(angle),
                                  interest_radius};
}

}  // namespace jostle::load
