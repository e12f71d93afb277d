// SPDX-License-Identifier: MIT
//
// Work-error analysis: observed order of convergence, Pareto-optimal runs, and the cheapest run
// within a tolerance; and the CPU time of a thread, the usual measure of work. Used by jostle-bench
// and jostle-sim.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace jostle::analysis {

/// Work and error of one run. The caller defines the unit of work and the error measure.
struct WorkError {
    double work = 0, error = 0;
};

/// log(error / finer_error) / log(refinement): 2 if the error decreases to a quarter at half the
/// step. Returns nothing if an error is not positive or the refinement is not above 1.
std::optional<double> observed_order(double error, double finer_error, double refinement);

/// Returns the indices of the Pareto-optimal runs (no other run has less work and a smaller error),
/// sorted by work.
std::vector<std::size_t> pareto_set(std::span<const WorkError> runs);

/// Returns the index of the cheapest run whose error is at most the tolerance; of equal ones the
/// first.
std::optional<std::size_t> least_work(std::span<const WorkError> runs, double tolerance);

/// CPU time of this thread in seconds, which other load on the machine affects less than wall time.
/// It is a system call: measure intervals of milliseconds, not of microseconds.
double thread_seconds();

/// Root mean square.
struct Rms {
    double sum = 0;
    long count = 0;

    void add(double square) {
        sum += square;
        count++;
    }
    double value() const { return count == 0 ? 0 : std::sqrt(sum / static_cast<double>(count)); }
};

}  // namespace jostle::analysis
