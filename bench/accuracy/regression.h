// SPDX-License-Identifier: MIT
//
// The short accuracy benchmark, for tests: Jostle only, in its default mode, on all scenes that
// take seconds. Its errors are bit-identical on every machine, so they are compared with a file: an
// error that grows by more than a third is a regression.
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

// Runs the scenes and compares them with the file, or rewrites it. Exit status: 0 no regression, 1
// regressions, or the file cannot be read or written. Without a file it only prints the rows.
int run_regression(const std::vector<const Experiment*>& experiments, const std::string& file,
                   bool update);

}  // namespace jostle::bench::accuracy
