// SPDX-License-Identifier: MIT
//
// An experiment of the accuracy benchmark: a scene, its duration, its error measures and
// tolerances. experiment_list.h lists them.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bench/accuracy/accuracy_engine.h"

namespace jostle::bench::accuracy {

struct Errors {
    double primary = 0, secondary = 0;
};

// Samples the engine after each step, t seconds after the start.
class Meter {
public:
    virtual ~Meter() = default;
    virtual void sample(double t, const Engine& engine) = 0;
    virtual Errors errors() const = 0;
};

// One run of an experiment.
struct ExperimentRun {
    Scene scene;
    double seconds = 1;
    std::unique_ptr<Meter> meter;
    double damping_ends = 0;  // s: Scene::damping becomes 0 at this time. 0: never
    // Length of step k in s, if steps differ from those of the rate. Empty: all last dt.
    std::function<double(long k, double dt)> step_length = {};
    // Moves driven bodies before the step from t to t + dt. Empty: no driven bodies.
    std::function<void(double t, double dt, Engine& engine)> drive = {};
};

struct Experiment {
    std::string name;      // such as j3-r100
    std::string about;     // the scene
    std::string measures;  // the two error measures
    // Errors for which the least CPU time is determined, coarse to fine.
    std::vector<double> tolerances;
    // Number of starts, each a fraction of a step later than the previous one; their errors are
    // averaged.
    int phases = 1;
    double max_hz = 1920;  // higher rates take too long
    // Without a known solution: the primary error is the RMS distance, over all bodies at the end,
    // from the same engine's run in the same mode at this rate. 0: the error of the meter is used.
    double finest_hz = 0;
    // `shift`: delay of the start, s, less than a step.
    std::function<ExperimentRun(double shift)> start;
    std::string family = {};  // of which this is a member (row_family.h); empty: a single scene
    // Errors that Jostle must not exceed at limit_from_hz and finer. 0: no limit.
    double limit = 0, second_limit = 0;
    double limit_from_hz = 60;
    // The short benchmark measures rates up to this one.
    double short_max_hz = 240;

    // Errors below it are not compared between rates (faults.h).
    double floor() const { return 0.1 * tolerances.back(); }
};

}  // namespace jostle::bench::accuracy
