// SPDX-License-Identifier: MIT
//
// Where the results of one client's inputs wait until its connection takes them. The world's
// thread puts, the client's network thread takes. Bounded by what the client has in flight: each
// accepted input yields one result.
#pragma once

#include <mutex>
#include <utility>
#include <vector>

#include "server/world/command.h"

namespace jostle::server {

class ResultQueue {
public:
    void put(InputResult result) {
        const std::lock_guard lock(mutex_);
        results_.push_back(std::move(result));
    }
    std::vector<InputResult> take() {
        const std::lock_guard lock(mutex_);
        return std::exchange(results_, {});
    }

private:
    std::mutex mutex_;
    std::vector<InputResult> results_;
};

}  // namespace jostle::server
