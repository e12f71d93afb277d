// SPDX-License-Identifier: MIT
//
// One row of the accuracy benchmark: an experiment in one engine and mode at one rate.
#pragma once

#include <iosfwd>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/accuracy/experiment.h"

namespace jostle::bench::accuracy {

struct Row {
    std::string scene, engine, mode;
    double rate_hz = 0;
    double error = 0, second_error = 0;
    double cpu_us_per_second = 0;  // of the step calls, per simulated second
    std::string failed;  // why the run is invalid: NaN, further than 1e5 m, an error of the engine
    // feature of the scene that the engine does not support: the row is omitted
    std::string unsupported;

    bool usable() const { return failed.empty() && unsupported.empty(); }
};

inline constexpr const char* takes_too_long = "takes too long";  // of failed rows

// Whether CPU time is measured, which requires separate runs.
enum class Timing { taken, none };

// Runs all starts, and times the first one.
Row run_row(const Experiment& experiment, const EngineKind& kind, const std::string& mode,
            double rate_hz, Timing timing = Timing::taken);
// In its own process: an engine that crashes produces a failed row.
Row run_row_in_child(const Experiment& experiment, const EngineKind& kind, const std::string& mode,
                     double rate_hz, Timing timing = Timing::taken);

// The result of one start, without its time.
struct Outcome {
    Errors errors;
    std::string failed;      // why it failed; empty: it did not
    std::vector<Vec3> last;  // final positions
};
Result<Outcome> run_once(ExperimentRun start, const EngineKind& kind, const std::string& mode,
                         double rate_hz);

nlohmann::ordered_json to_json(const Row& row);
Row row_from(const nlohmann::ordered_json& json);
std::string csv_heading();
std::string csv_line(const Row& row);
std::vector<Row> rows_from_csv(std::istream& in);  // throws std::runtime_error with the line

}  // namespace jostle::bench::accuracy
