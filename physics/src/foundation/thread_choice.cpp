// SPDX-License-Identifier: MIT
#include "physics/src/foundation/thread_choice.h"

#include <atomic>

#include "jostle/base/check.h"
#include "jostle/physics/profile.h"
#include "physics/src/foundation/tuning.h"

namespace jostle::physics {
namespace {

std::atomic<bool> short_steps_are_shared = false;

}  // namespace

void share_short_steps(bool on) {
    short_steps_are_shared.store(on, std::memory_order_relaxed);
}

bool ThreadChoice::shares_step(std::int64_t last_work) {
    ASSERT(last_work >= 0);
    if (short_steps_are_shared.load(std::memory_order_relaxed)) return true;
    shared_ = last_work >= (shared_ ? tuning::still_shared_work : tuning::shared_work);
    return shared_;
}

}  // namespace jostle::physics
