// SPDX-License-Identifier: MIT
#pragma once

namespace jostle::convergence {

/// CPU time of this thread in seconds, which other load on the machine affects less than wall time.
/// It is a system call: measure intervals of milliseconds, not of microseconds.
double thread_seconds();

}  // namespace jostle::convergence
