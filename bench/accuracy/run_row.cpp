// SPDX-License-Identifier: MIT
#include "bench/accuracy/run_row.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <istream>
#include <stdexcept>
#include <utility>

#include "bench/accuracy/accuracy_bodies.h"
#include "bench/accuracy/accuracy_engine_kinds.h"
#include "bench/measure.h"
#include "bench/processes/program.h"
#include "bench/result_file.h"

namespace jostle::bench::accuracy {
namespace {

constexpr double furthest = 1e5;        // m
constexpr double short_run_max = 0.05;  // s of CPU time: shorter runs are repeated
constexpr double long_run = 0.4;        // s: longer runs are timed once
constexpr int repetitions = 3;
constexpr double longest = 20;  // s of CPU time: limit for one start

// The lengths of all steps in s.
std::vector<double> steps_of(const ExperimentRun& start, double rate_hz) {
    const double dt = 1 / rate_hz;
    if (!start.step_length)
        return std::vector<double>(static_cast<std::size_t>(std::llround(start.seconds * rate_hz)),
                                   dt);
    std::vector<double> steps;
    for (double t = 0; t < start.seconds - 1e-9; t += steps.back())
        steps.push_back(start.step_length(static_cast<long>(steps.size()), dt));
    return steps;
}

// Number of steps until damping ends; more than all steps if it never does.
long damped_steps(const ExperimentRun& start, double rate_hz) {
    return start.damping_ends > 0 ? std::llround(start.damping_ends * rate_hz) : -1;
}

std::string failure(const Scene& scene, const Engine& engine) {
    for (std::size_t k = 0; k < scene.bodies.size(); k++) {
        const double distance = length(engine.state(static_cast<int>(k)).position);
        if (!(distance < furthest)) return "a body is lost";
    }
    return engine.failure();
}

// Steps without sampling: CPU seconds, or nothing if the engine rejects the scene.
double time_steps(const ExperimentRun& start, const EngineKind& kind, const std::string& mode,
                  double rate_hz) {
    const auto engine = kind.make();
    if (!engine->build(start.scene, mode)) return 0;
    const std::vector<double> steps = steps_of(start, rate_hz);
    const long damped = damped_steps(start, rate_hz);
    const double before = cpu_seconds();
    double t = 0;
    for (std::size_t k = 0; k < steps.size(); t += steps[k++]) {
        if (static_cast<long>(k) == damped) engine->set_damping(0);
        if (start.drive) start.drive(t, steps[k], *engine);
        engine->step(steps[k]);
    }
    return cpu_seconds() - before;
}

double least_time(const ExperimentRun& start, const EngineKind& kind, const std::string& mode,
                  double rate_hz) {
    double least = time_steps(start, kind, mode, rate_hz);
    const int more = least < short_run_max ? repetitions : least < long_run ? 1 : 0;
    for (int k = 0; k < more; k++) least = std::min(least, time_steps(start, kind, mode, rate_hz));
    return least;
}

// The same run at the finest rate: RMS distance of the bodies at the end.
double distance_from_finest(const Experiment& experiment, const EngineKind& kind,
                            const std::string& mode, double rate_hz, std::string& failure) {
    const auto first_run = run_once(experiment.start(0), kind, mode, rate_hz);
    const auto finest = run_once(experiment.start(0), kind, mode, experiment.finest_hz);
    if (!first_run || !finest || !first_run->failed.empty() || !finest->failed.empty()) {
        failure = "the finest run failed";
        return 0;
    }
    double sum = 0;
    for (std::size_t k = 0; k < first_run->last.size(); k++)
        sum += length_squared(first_run->last[k] - finest->last[k]);
    return std::sqrt(sum / static_cast<double>(first_run->last.size()));
}

}  // namespace

Result<Outcome> run_once(ExperimentRun start, const EngineKind& kind, const std::string& mode,
                         double rate_hz) {
    if (kind.make != make_jostle_engine)
        if (const std::string feature = feature_of_jostle_only(start.scene); !feature.empty())
            return Error{.message = feature + " are not implemented for the peers"};
    const auto engine = kind.make();
    if (auto status = engine->build(start.scene, mode); !status) return status.error();
    const std::vector<double> steps = steps_of(start, rate_hz);
    const long damped = damped_steps(start, rate_hz);
    const double began = cpu_seconds();
    double elapsed = 0;  // of varying steps
    for (std::size_t k = 0; k < steps.size(); k++) {
        if (static_cast<long>(k) == damped) engine->set_damping(0);
        if (start.drive) start.drive(elapsed, steps[k], *engine);
        engine->step(steps[k]);
        elapsed += steps[k];
        if (auto reason = failure(start.scene, *engine); !reason.empty())
            return Outcome{.failed = reason};
        start.meter->sample(start.step_length ? elapsed : static_cast<double>(k + 1) / rate_hz,
                            *engine);
        if (cpu_seconds() - began > longest) return Outcome{.failed = takes_too_long};
    }
    Outcome outcome{.errors = start.meter->errors()};
    if (!std::isfinite(outcome.errors.primary) || !std::isfinite(outcome.errors.secondary))
        outcome.failed = "the error is not finite";
    for (std::size_t k = 0; k < start.scene.bodies.size(); k++)
        outcome.last.push_back(engine->state(static_cast<int>(k)).position);
    return outcome;
}

Row run_row(const Experiment& experiment, const EngineKind& kind, const std::string& mode,
            double rate_hz, Timing timing) {
    Row row{.scene = experiment.name, .engine = kind.name, .mode = mode, .rate_hz = rate_hz};
    double primary = 0, second = 0;
    for (int phase = 0; phase < experiment.phases; phase++) {
        const double shift = phase / rate_hz / experiment.phases;
        auto outcome = run_once(experiment.start(shift), kind, mode, rate_hz);
        if (!outcome)
            row.unsupported = outcome.error().message;
        else
            row.failed = outcome->failed;
        if (!row.usable()) return row;
        primary += outcome->errors.primary * outcome->errors.primary;
        second += outcome->errors.secondary * outcome->errors.secondary;
    }
    row.error = std::sqrt(primary / experiment.phases);
    row.second_error = std::sqrt(second / experiment.phases);
    if (experiment.finest_hz > 0) {
        row.error = distance_from_finest(experiment, kind, mode, rate_hz, row.failed);
        if (!row.usable()) return row;
    }
    if (timing == Timing::none) return row;
    const ExperimentRun start = experiment.start(0);
    row.cpu_us_per_second = 1e6 * least_time(start, kind, mode, rate_hz) / start.seconds;
    return row;
}

// A step of a direct solver may take minutes; the system then terminates the process.
Row run_row_in_child(const Experiment& experiment, const EngineKind& kind, const std::string& mode,
                     double rate_hz, Timing timing) {
    const ChildResult answer = run_in_child([&] {
        const auto most = static_cast<rlim_t>(longest * (experiment.phases + 3));
        const rlimit limit{most, most + 1};
        setrlimit(RLIMIT_CPU, &limit);
        return to_json(run_row(experiment, kind, mode, rate_hz, timing)).dump();
    });
    if (answer.failure.empty()) return row_from(nlohmann::ordered_json::parse(answer.text));
    const bool late = answer.failure.find("signal " + std::to_string(SIGXCPU)) != std::string::npos;
    return {.scene = experiment.name,
            .engine = kind.name,
            .mode = mode,
            .rate_hz = rate_hz,
            .failed = late ? takes_too_long : answer.failure};
}

nlohmann::ordered_json to_json(const Row& row) {
    nlohmann::ordered_json json = {
        {"scene", row.scene}, {"engine", row.engine}, {"mode", row.mode}, {"rate_hz", row.rate_hz}};
    if (!row.unsupported.empty()) json["lacks"] = row.unsupported;
    if (!row.failed.empty()) json["blown"] = row.failed;
    if (!row.usable()) return json;
    json["error"] = rounded(row.error);
    json["second_error"] = rounded(row.second_error);
    json["cpu_us_per_second"] = rounded(row.cpu_us_per_second);
    return json;
}

Row row_from(const nlohmann::ordered_json& json) {
    return {.scene = json.at("scene"),
            .engine = json.value("engine", ""),
            .mode = json.value("mode", ""),
            .rate_hz = json.at("rate_hz"),
            .error = json.value("error", 0.0),
            .second_error = json.value("second_error", 0.0),
            .cpu_us_per_second = json.value("cpu_us_per_second", 0.0),
            .failed = json.value("blown", ""),
            .unsupported = json.value("lacks", "")};
}

std::string csv_heading() {
    return "scene,engine,mode,rate_hz,error,second_error,cpu_us_per_second";
}

std::string csv_line(const Row& row) {
    char text[256];
    const std::string head = row.scene + "," + row.engine + "," + row.mode;
    if (!row.usable())
        std::snprintf(text, sizeof text, "%s,%g,blown,,", head.c_str(), row.rate_hz);
    else
        std::snprintf(text, sizeof text, "%s,%g,%.4g,%.4g,%.4g", head.c_str(), row.rate_hz,
                      row.error, row.second_error, row.cpu_us_per_second);
    return text;
}

std::vector<Row> rows_from_csv(std::istream& in) {
    std::vector<Row> rows;
    std::string line;
    std::getline(in, line);
    if (line != csv_heading()) throw std::runtime_error("the first line must be " + csv_heading());
    while (std::getline(in, line)) {
        char scene[32], engine[32], mode[32], first[32];
        Row row;
        const int read =
            std::sscanf(line.c_str(), "%31[^,],%31[^,],%31[^,],%lf,%31[^,],%lf,%lf", scene, engine,
                        mode, &row.rate_hz, first, &row.second_error, &row.cpu_us_per_second);
        if (read < 5) throw std::runtime_error("invalid row: " + line);
        row.scene = scene, row.engine = engine, row.mode = mode;
        if (std::string(first) == "blown")
            row.failed = first;
        else
            row.error = std::stod(first);
        rows.push_back(std::move(row));
    }
    return rows;
}

}  // namespace jostle::bench::accuracy
