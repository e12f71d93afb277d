// SPDX-License-Identifier: MIT
//
// Decides by timed trials whether several threads speed up a step. For steps shorter than 2 ms,
// moving records between the caches of two cores can take longer than the saved work: a cache line
// takes 0.05 to 0.35 us, depending on the caches that the cores share. The trials run at intervals,
// and the faster mode is used. They depend on the clock, which is permitted because the assignment
// of work to threads does not change the result of a step (thread_pool.h).
//
// Used by the thread that steps a world.
#pragma once

#include <array>
#include <cstddef>

#include "physics/src/foundation/tuning.h"

namespace jostle::physics {

class ThreadingTrial {
public:
    // Returns whether several threads take part in the next step. `last_ms`: duration of the last
    // step.
    bool shares(double last_ms);

private:
    static constexpr int sample_count = 5;  // steps that are compared, before a trial and in it
    static constexpr int trial_steps = sample_count + 1;

    bool last_are_long() const;
    double median() const;

    bool shared_ = false;  // current mode
    bool trying_ = false;
    int pause_ = tuning::first_trial_pause, left_ = tuning::first_trial_pause;
    int lost_ = 0;                             // steps of the trial that were not faster
    double baseline_ms_ = 0;                   // median duration before the trial
    std::array<double, sample_count> last_{};  // durations of the last steps, ms; ring buffer
    std::size_t next_ = 0;
};

}  // namespace jostle::physics
