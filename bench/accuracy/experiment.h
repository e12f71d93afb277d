// SPDX-License-Identifier: MIT
//
// An experiment of the laboratory: a scene, how long it runs, what is measured and which errors are
// asked for. Families of experiments are in files of their own; all_experiments() is their list.
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

// Looks at the engine at the end of each step, t seconds after the start.
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
    double damping_ends = 0;  // s: Scene::damping is 0 from then on. 0: stays
};

struct Experiment {
    std::string name;      // j3-r100
    std::string about;     // the scene
    std::string measures;  // the two errors
    // The errors for which the least CPU time is asked, coarse to fine.
    std::vector<double> tolerances;
    // Starts, each a part of a step later than the one before; their errors are averaged.
    int phases = 1;
    double max_hz = 1920;  // beyond that it takes too long
    // No truth is known: the primary error is the RMS distance, over all bodies at the end, from
    // the same engine's run in the same mode at this rate. 0: the meter's error counts.
    double finest_hz = 0;
    // `shift`: seconds by which the start is late, less than a step.
    std::function<ExperimentRun(double shift)> start;
};

// In the order of the specification: free bodies, joints, contacts.
std::span<const Experiment> all_experiments();
const Experiment* find_experiment(std::string_view name);  // null: none

// The families, a file each.
std::vector<Experiment> free_experiments();
std::vector<Experiment> top_experiments();       // spinning and precessing bodies on joints
std::vector<Experiment> pendulum_experiments();  // and chains
std::vector<Experiment> machine_experiments();   // motors, limits, sliders, hanging bridges
std::vector<Experiment> friction_experiments();
std::vector<Experiment> impact_experiments();
std::vector<Experiment> stack_experiments();
std::vector<Experiment> pile_experiments();
std::vector<Experiment> chaos_experiments();  // what neighbouring starts leave each other in

}  // namespace jostle::bench::accuracy
