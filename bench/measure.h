// SPDX-License-Identifier: MIT
//
// Functions that the subcommands of jostle-bench share: time, memory, statistics and a description
// of the machine.
#pragma once

#include <string>
#include <vector>

namespace jostle::bench {

// CPU time of this thread in seconds, which is less affected by other load on the machine. Reading
// it is a system call, so the measured work should take milliseconds.
double cpu_seconds();

// Wall-clock time in seconds, for work on several threads.
double wall_seconds();

// CPU time of this thread if one thread does the work, else wall-clock time.
struct StepClock {
    int threads = 1;

    const char* name() const { return threads == 1 ? "cpu" : "wall"; }
    double seconds() const { return threads == 1 ? cpu_seconds() : wall_seconds(); }
};

// Current and peak resident memory of this process in bytes; 0 if the system does not report it.
double memory_bytes();
double peak_memory_bytes();

// Statistics of repetitions: the median is the result, the other two show its reliability.
struct Spread {
    double median = 0, low = 0, high = 0;
};
Spread spread_of(std::vector<double> values);

// The vector must not be empty.
double mean(const std::vector<double>& values);
double percentile_99(std::vector<double> values);

// Processor model and compiler: enough to interpret a result, without identifying a machine.
std::string cpu_model();
std::string compiler();

// Replaces the progress line on the terminal; does nothing if the output is redirected. An empty
// text clears the line.
void show_progress(const std::string& text);

}  // namespace jostle::bench
