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

// Multiples of the golden ratio: the rates of any number of clients are evenly distributed.
double LoadOptions::read_rate_of(int number) const {
    if (read_rate == 0 || read_rate_max == 0) return read_rate;
    constexpr double golden_ratio = 1.61803398874989485;
    const double turns = golden_ratio * (number + 1);
    return read_rate + (read_rate_max - read_rate) * (turns - std::floor(turns));
}

}  // namespace jostle::load
