// SPDX-License-Identifier: MIT
//
// Counts laps round the world's y axis, of one that is seen now and then.
#pragma once

#include <vector>

namespace jostle::bots {

struct Lap {
    double seconds = 0;
    double nearest = 1e9, furthest = 0;  // m from the axis on the way
};

class LapCounter {
public:
    // Where it is at a time, often enough that it turned by less than half a lap. Either way round.
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
