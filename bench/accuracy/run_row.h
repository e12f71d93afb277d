// SPDX-License-Identifier: MIT
//
// One row of the laboratory: an experiment in one engine, one mode, at one rate.
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
    std::string failed;       // why the run is worth nothing: NaN, further than 1e5 m, a complaint
    std::string unsupported;  // what the scene has and the engine does not: the row is left out

    bool usable() const { return failed.empty() && unsupported.empty(); }
};

inline constexpr const char* takes_too_long = "takes too long";  // of blown rows

// Whether processor time is taken, which needs runs of its own.
enum class Timing { taken, none };

// All starts, and the time of the first.
Row run_row(const Experiment& experiment, const EngineKind& kind, const std::string& mode,
            double rate_hz, Timing timing = Timing::taken);
// In a process of its own: an engine that crashes leaves a row that says so.
Row run_row_in_child(const Experiment& experiment, const EngineKind& kind, const std::string& mode,
                     double rate_hz, Timing timing = Timing::taken);

// One start, without taking its time.
struct Outcome {
    Errors errors;
    std::string failed;      // why; empty: it is not
    std::vector<Vec3> last;  // where the bodies are at the end
};
Result<Outcome> run_once(ExperimentRun start, const EngineKind& kind, const std::string& mode,
                         double rate_hz);

nlohmann::ordered_json to_json(const Row& row);
Row row_from(const nlohmann::ordered_json& json);
std::string csv_heading();
std::string csv_line(const Row& row);
std::vector<Row> rows_from_csv(std::istream& in);  // throws std::runtime_error: the line

}  // namespace jostle::bench::accuracy
