// SPDX-License-Identifier: MIT
#pragma once

namespace jostle::convergence {

// Processor time of this thread in seconds: what else the machine does then matters less. Reading
// it is a system call, so put it around milliseconds, not around microseconds.
double thread_seconds();

}  // namespace jostle::convergence
