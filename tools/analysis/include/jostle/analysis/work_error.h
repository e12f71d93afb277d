// SPDX-License-Identifier: MIT
//
// Work against error: how fast errors fall when steps get shorter, which runs no other beats, and
// which is the cheapest that is good enough. jostle-bench asks of its rows, jostle-sim of one
// scene.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace jostle::convergence {

// Of one run. The unit of work is the caller's, as is what an error is.
struct WorkError {
    double work = 0, error = 0;
};

// log(error / finer_error) / log(refinement): 2 when an error falls to a quarter at half the step.
// Nothing where an error is not positive, or the refinement not above 1.
std::optional<double> observed_order(double error, double finer_error, double refinement);

// Runs that no other beats in work and error at once, as places in `runs`, the cheapest first.
std::vector<std::size_t> pareto_set(std::span<const WorkError> runs);

// The cheapest run whose error is at most the tolerance; of equals the first.
std::optional<std::size_t> least_work(std::span<const WorkError> runs, double tolerance);

// Root of the mean of squares.
struct Rms {
    double sum = 0;
    long count = 0;

    void add(double square) {
        sum += square;
        count++;
    }
    double value() const { return count == 0 ? 0 : std::sqrt(sum / static_cast<double>(count)); }
};

}  // namespace jostle::convergence
