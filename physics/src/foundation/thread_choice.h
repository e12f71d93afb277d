// SPDX-License-Identifier: MIT
//
// Decides from the work of the last step whether several threads take part in the next one. In a
// step with little work, moving records between the caches of two cores takes longer than the saved
// work: a cache line takes 0.05 to 0.35 us, depending on the caches that the cores share. The work
// is counted and not timed (StepProfile::work), so the threads that take part are the same in every
// run.
//
// Used by the thread that steps a world.
#pragma once

#include <cstdint>

namespace jostle::physics {

class ThreadChoice {
public:
    // Returns whether all threads take part in the next step. `last_work`: StepProfile::work of the
    // last step; 0 before the first.
    bool shares_step(std::int64_t last_work);

private:
    bool shared_ = false;
};

}  // namespace jostle::physics
