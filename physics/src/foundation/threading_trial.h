// SPDX-License-Identifier: MIT
//
// Finds out whether a second thread is worth its trouble. Where a step takes less than two
// milliseconds, records that travel from one core's cache to another's and back may take longer
// than the work that is saved: a line takes 0.05 to 0.35 us, by whether the cores share a cache,
// which no constant can know. So it is tried, now and then, and what takes less time is kept. That
// goes by the clock, and may: which thread does what changes no bit of a step (thread_pool.h).
//
// Used by the thread that steps a world.
#pragma once

#include <array>
#include <cstddef>

#include "physics/src/foundation/tuning.h"

namespace jostle::physics {

class ThreadingTrial {
public:
    // Whether the threads share the next step. `last_ms`: what the last one took.
    bool shares(double last_ms);

private:
    static constexpr int sample_count = 5;  // last steps before a trial, and of one
    static constexpr int trial_steps = sample_count + 1;

    bool last_are_long() const;
    double median() const;

    bool shared_ = false;  // the way that is kept
    bool trying_ = false;
    int pause_ = tuning::first_trial_pause, left_ = tuning::first_trial_pause;
    int lost_ = 0;                             // steps of the trial that were no better
    double baseline_ms_ = 0;                   // a step took before the trial
    std::array<double, sample_count> last_{};  // ms, round and round
    std::size_t next_ = 0;
};

}  // namespace jostle::physics
