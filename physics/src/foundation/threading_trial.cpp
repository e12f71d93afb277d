// SPDX-License-Identifier: MIT
#include "physics/src/foundation/threading_trial.h"

#include <algorithm>
#include <atomic>

#include "jostle/physics/thread_trials.h"

namespace jostle::physics {
namespace {

std::atomic<bool> trials_in_use = true;

}  // namespace

void use_thread_trials(bool on) {
    trials_in_use.store(on, std::memory_order_relaxed);
}

bool ThreadingTrial::shares(double last_ms) {
    if (!trials_in_use.load(std::memory_order_relaxed)) return true;
    last_[next_] = last_ms;
    next_ = (next_ + 1) % last_.size();
    if ((trying_ || !shared_) && last_are_long()) {
        shared_ = true;
        trying_ = false;
        pause_ = left_ = tuning::first_trial_pause;
        return true;
    }
    left_--;
    if (!trying_) {
        if (left_ > 0) return shared_;
        baseline_ms_ = median();
        trying_ = baseline_ms_ <= tuning::long_step_ms;
        left_ = trying_ ? trial_steps : pause_;
        lost_ = 0;
        return shared_ != trying_;
    }
    // The first step of a trial is ignored: its records are still in other caches.
    if (left_ < trial_steps - 1 && last_ms >= tuning::trial_gain * baseline_ms_) lost_++;
    const bool decided = lost_ > sample_count / 2;
    if (left_ > 0 && !decided) return !shared_;
    trying_ = false;
    if (!decided) shared_ = !shared_;
    pause_ =
        decided ? std::min(8 * pause_, tuning::longest_trial_pause) : tuning::first_trial_pause;
    left_ = pause_;
    return shared_;
}

// Requires all of the last three steps, because a single one may have been disturbed.
bool ThreadingTrial::last_are_long() const {
    const auto ago = [&](std::size_t steps) {
        return last_[(next_ + last_.size() - steps) % last_.size()];
    };
    return std::min({ago(1), ago(2), ago(3)}) > tuning::long_step_ms;
}

double ThreadingTrial::median() const {
    auto sorted = last_;
    std::sort(sorted.begin(), sorted.end());
    return sorted[sorted.size() / 2];
}

}  // namespace jostle::physics
