// SPDX-License-Identifier: MIT
//
// An experiment of the accuracy benchmark: a scene, its duration, its error measures and
// tolerances. Each family of experiments has its own file; all_experiments() lists them.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
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
};

// In the order of the specification: free bodies, joints, contacts.
std::span<const Experiment> all_experiments();
const Experiment* find_experiment(std::string_view name);  // null: none

// The families, one file each.
std::vector<Experiment> free_experiments();
std::vector<Experiment> top_experiments();       // spinning and precessing bodies on joints
std::vector<Experiment> pendulum_experiments();  // and chains
std::vector<Experiment> machine_experiments();   // motors, limits, sliders, hanging bridges
std::vector<Experiment> friction_experiments();
std::vector<Experiment> impact_experiments();
std::vector<Experiment> stack_experiments();
std::vector<Experiment> pile_experiments();
std::vector<Experiment> chaos_experiments();  // chaotic scenes

}  // namespace jostle::bench::accuracy
