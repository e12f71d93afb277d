// SPDX-License-Identifier: MIT
//
// The clients of a run, whatever they are made of. They begin to connect when it is made.
#pragma once

#include <cstdint>

#include "tools/load/load_metrics.h"

namespace jostle::load {

class ClientPool {
public:
    struct Progress {
        int joined = 0;  // and still there
        std::uint64_t snapshots = 0, inputs = 0;
    };

    virtual ~ClientPool() = default;
    virtual Progress progress() const = 0;
    // Figures count from now on.
    virtual void measure() = 0;
    // Ends all, in order, and tells what they saw; once.
    virtual LoadMetrics end() = 0;
};

}  // namespace jostle::load
