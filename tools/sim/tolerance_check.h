// SPDX-License-Identifier: MIT
//
// Whether the islands of a world stayed within its error tolerance over a run.
#pragma once

#include <deque>
#include <map>
#include <string>
#include <vector>

#include "jostle/physics/physics.h"

namespace jostle::sim {

struct ToleranceVerdict {
    double tolerance = 0;  // m
    bool measured = false;
    int islands_over = 0;  // islands that exceeded the tolerance in any second
    double worst = 0;      // m: largest error of an island after any second

    bool within() const { return islands_over == 0; }
};

// The estimated error of an island is its error after one second of steps like the last measured
// one. So its error after a second of different steps is the mean of the estimates over that
// second, or over the whole run if it is shorter. An island is identified by its first body.
class ToleranceCheck {
public:
    ToleranceCheck(double tolerance, double hz);

    void add(const std::vector<physics::IslandSubsteps>& islands);  // after each step
    ToleranceVerdict verdict() const;

private:
    struct Window {
        struct Entry {
            std::size_t step;
            double error;
        };
        std::deque<Entry> entries;  // of the last second, in order
        double worst = 0;           // largest mean over a full second
    };
    double mean(const Window& window) const;

    double tolerance_;
    std::size_t steps_per_second_, steps_ = 0;
    bool measured_ = false;
    std::map<physics::BodyId, Window> windows_;
};

std::string to_text(const ToleranceVerdict& verdict);

}  // namespace jostle::sim
