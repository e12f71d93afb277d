// SPDX-License-Identifier: MIT
#include "clients/bot/lap_counter.h"

#include <algorithm>
#include <cmath>

namespace jostle::bots {

void LapCounter::add_position(double seconds, double x, double z) {
    if (!seen_) began_ = seconds;
    if (seen_) turned_ += std::atan2(x_ * z - z_ * x, x_ * x + z_ * z);
    seen_ = true;
    x_ = x, z_ = z;
    const double distance = std::hypot(x, z);
    lap_.nearest = std::min(lap_.nearest, distance);
    lap_.furthest = std::max(lap_.furthest, distance);
    constexpr double full_turn = 2 * 3.14159265358979;
    if (std::abs(turned_) < full_turn) return;
    lap_.seconds = seconds - began_;
    laps_.push_back(lap_);
    turned_ -= turned_ < 0 ? -full_turn : full_turn;
    began_ = seconds;
    lap_ = {};
}

}  // namespace jostle::bots
