// SPDX-License-Identifier: MIT
//
// Where the outcomes of one client's inputs wait until its connection takes them. The world's
// thread puts, the client's network thread takes. Bounded by what the client has in flight: each
// accepted input yields one outcome.
#pragma once

#include <mutex>
#include <utility>
#include <vector>

#include "host/command.h"

namespace jostle::server {

class OutcomeMailbox {
public:
    void put(InputOutcome outcome) {
        const std::lock_guard lock(mutex_);
        outcomes_.push_back(std::move(outcome));
    }
    std::vector<InputOutcome> take() {
        const std::lock_guard lock(mutex_);
        return std::exchange(outcomes_, {});
    }

private:
    std::mutex mutex_;
    std::vector<InputOutcome> outcomes_;
};

}  // namespace jostle::server
