// SPDX-License-Identifier: MIT
//
// The short accuracy benchmark, for tests: Jostle only, on all scenes that take seconds, in its
// default mode and with iterative joints. Its errors are bit-identical on every machine, so they
// are compared with a file: an error that grows by more than a third is a regression. The rules of
// faults.h hold as well.
#pragma once

#include <string>
#include <vector>

#include "bench/accuracy/run_row.h"

namespace jostle::bench::accuracy {

// Whether the scene is fast enough for the short benchmark.
bool in_regression_set(const Experiment& experiment);

// Errors only, without times. Each row runs in its own process.
std::vector<Row> regression_rows(const std::vector<const Experiment*>& experiments);

// Ratio above which a value is a regression, and the value below which differences are rounding.
inline constexpr double regression_ratio = 4.0 / 3;
inline constexpr double rounding = 1e-9;

struct RegressionChange {
    std::string scene;
    double rate_hz = 0;
    std::string words;   // such as "error 0.01 -> 0.02 (2.0 times)"
    bool fault = false;  // worse or not comparable; false: better by more than a third
};
// If `all` is false, scenes without rows in `after` are ignored.
std::vector<RegressionChange> changes_between(const std::vector<Row>& before,
                                              const std::vector<Row>& after, bool all);

// Runs the scenes, compares them with the file and checks the rules, or rewrites both files.
struct RegressionFiles {
    std::string rows;          // empty: the rows are printed
    std::string known_faults;  // empty: none are known
    bool update = false;
};
// Exit status: 0 no regression and no fault, 1 otherwise, or a file cannot be read or written.
int run_regression(const std::vector<const Experiment*>& experiments, const RegressionFiles& files);

}  // namespace jostle::bench::accuracy
