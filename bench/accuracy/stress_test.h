// SPDX-License-Identifier: MIT
//
// Stress tests of the laboratory: scenes in which engines fail, each with a figure and a limit.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bench/accuracy/experiment.h"

namespace jostle::bench::accuracy {

struct Verdict {
    bool pass = false;
    std::optional<double> figure;  // passes when it is below the limit; none: the run was lost
    std::string why;               // it fails, where the figure does not say it
    std::string unsupported;       // what the engine does not have: not run
};

struct StressTest {
    std::string id;      // s6-tilt
    std::string about;   // the scene and the rate
    std::string figure;  // what is measured, with its unit
    double limit = 1;
    std::function<Verdict(const EngineKind&, const std::string& mode)> run;
};

// In the order of the specification.
std::span<const StressTest> all_stress_tests();

// The families, a file each.
std::vector<StressTest> stack_stress_tests();
std::vector<StressTest> joint_stress_tests();
std::vector<StressTest> motion_stress_tests();
std::vector<StressTest> pile_stress_tests();
std::vector<StressTest> input_stress_tests();  // of Jostle alone

// A start at one rate: passes when no body is lost, no body is ever faster than twice the bound
// (m/s; 0: no bound), and the figure is below the limit.
enum class Figure { primary, second };
struct StressRun {
    std::function<ExperimentRun()> start;
    double rate_hz = 60, speed_bound = 0, limit = 1;
    Figure figure = Figure::primary;
};
Verdict run_stress(const StressRun& run, const EngineKind& kind, const std::string& mode);

nlohmann::ordered_json to_json(const StressTest& test, const EngineKind& kind,
                               const std::string& mode, const Verdict& verdict);

}  // namespace jostle::bench::accuracy
