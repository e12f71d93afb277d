// SPDX-License-Identifier: MIT
//
// Counts laps around the world's y axis from sampled positions.
#pragma once

#include <vector>

namespace jostle::bots {

struct Lap {
    double seconds = 0;
    double nearest = 1e9, furthest = 0;  // m from the axis
};

class LapCounter {
public:
    // Adds a position at a time. Successive positions must be less than half a lap apart. Laps
    // count in both directions.
    void add_position(double seconds, double x, double z);
    void begin() { *this = {}; }
    const std::vector<Lap>& laps() const { return laps_; }

private:
    std::vector<Lap> laps_;
    Lap lap_;
    bool seen_ = false;
    double began_ = 0, turned_ = 0;  // s; rad
    double x_ = 0, z_ = 0;
};

}  // namespace jostle::bots
