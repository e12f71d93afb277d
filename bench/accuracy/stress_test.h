// SPDX-License-Identifier: MIT
//
// Stress tests of the accuracy benchmark: scenes in which engines fail, each with a measured value
// and a limit.
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
    std::optional<double> figure;  // passes if it is below the limit; none: the run failed
    std::string why;               // why it fails, if not because of the value
    std::string unsupported;       // unsupported feature: the test was not run
};

struct StressTest {
    std::string id;      // such as s6-tilt
    std::string about;   // the scene and the rate
    std::string figure;  // the measured value with its unit
    double limit = 1;
    std::function<Verdict(const EngineKind&, const std::string& mode)> run;
};

// In the order of the specification.
std::span<const StressTest> all_stress_tests();

// The families, one file each.
std::vector<StressTest> stack_stress_tests();
std::vector<StressTest> joint_stress_tests();
std::vector<StressTest> motion_stress_tests();
std::vector<StressTest> pile_stress_tests();
std::vector<StressTest> input_stress_tests();  // Jostle only

// One start at one rate. Passes if no body is lost, no body exceeds twice the speed bound (m/s; 0:
// no bound), and the value is below the limit.
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
