// SPDX-License-Identifier: MIT
//
// The clients of a load run, independent of their kind. They start to connect on construction.
#pragma once

#include <cstdint>

#include "tools/load/load_metrics.h"

namespace jostle::load {

class ClientPool {
public:
    struct Progress {
        int joined = 0;  // joined and still connected
        std::uint64_t snapshots = 0, inputs = 0;
    };

    virtual ~ClientPool() = default;
    virtual Progress progress() const = 0;
    // Resets the metrics; the measurement starts now.
    virtual void measure() = 0;
    // Disconnects all clients and returns their metrics; call it once.
    virtual LoadMetrics end() = 0;
};

}  // namespace jostle::load
