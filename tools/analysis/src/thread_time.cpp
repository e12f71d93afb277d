// SPDX-License-Identifier: MIT
#include "jostle/analysis/thread_time.h"

#include <time.h>

namespace jostle::convergence {

double thread_seconds() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace jostle::convergence
