// SPDX-License-Identifier: MIT
//
// The short form of the laboratory, for tests: Jostle alone, in its default mode, on all scenes
// that take seconds. Its errors have the same digits on every machine, so they are held against a
// file of before: worse by more than a third is a fault.
#pragma once

#include <string>
#include <vector>

#include "bench/accuracy/run_row.h"

namespace jostle::bench::accuracy {

// Whether the scene is cheap enough to belong to it.
bool in_regression_set(const Experiment& experiment);

// Errors alone: no time is taken. In a process each, as all rows.
std::vector<Row> regression_rows(const std::vector<const Experiment*>& experiments);

// What a figure may be worse by before it is a fault, and below which it is rounding.
inline constexpr double regression_ratio = 4.0 / 3;
inline constexpr double rounding = 1e-9;

struct RegressionChange {
    std::string scene;
    double rate_hz = 0;
    std::string words;   // "error 0.01 -> 0.02 (2.0 times)"
    bool fault = false;  // worse, or not comparable; else better by more than a third
};
// Rows of scenes that `after` has none of are not missed when `all` is false.
std::vector<RegressionChange> changes_between(const std::vector<Row>& before,
                                              const std::vector<Row>& after, bool all);

// Runs the scenes and holds them against the file, or writes it anew. Exit status: 0 no fault, 1
// faults, or the file cannot be read or written. Without a file it prints alone.
int run_regression(const std::vector<const Experiment*>& experiments, const std::string& file,
                   bool update);

}  // namespace jostle::bench::accuracy
