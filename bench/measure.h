// SPDX-License-Identifier: MIT
//
// What every subcommand of jostle-bench needs to take a time and to say where it was taken.
#pragma once

#include <string>
#include <vector>

namespace jostle::bench {

// Processor time of this thread in seconds: what else the machine does then matters less. Reading
// it is a system call, so put it around milliseconds, not around microseconds.
double cpu_seconds();

// Time as it passes, in seconds: for work on several threads.
double wall_seconds();

// Processor time of this thread where one thread does the work, else time as it passes.
struct StepClock {
    int threads = 1;

    const char* name() const { return threads == 1 ? "cpu" : "wall"; }
    double seconds() const { return threads == 1 ? cpu_seconds() : wall_seconds(); }
};

// What this process holds in memory now, and the most that it ever held. Bytes; 0 when the system
// does not tell.
double memory_bytes();
double peak_memory_bytes();

// Of several repetitions. The median is the figure; the other two say how much to trust it.
struct Spread {
    double median = 0, low = 0, high = 0;
};
Spread spread_of(std::vector<double> values);

// Of one value or more.
double mean(const std::vector<double>& values);
double percentile_99(std::vector<double> values);

// The processor's model and the compiler: enough to read a result by, nothing that names a machine.
std::string cpu_model();
std::string compiler();

// Replaces the line on the terminal; nothing when the output goes elsewhere. Empty: clears it.
void show_progress(const std::string& text);

}  // namespace jostle::bench
