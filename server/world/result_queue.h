// SPDX-License-Identifier: MIT
//
// The queue of input results for one client. The tick thread puts them, and the client's network
// thread takes them. The number of inputs in flight bounds its size, because each accepted input
// yields one result.
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
