// SPDX-License-Identifier: MIT
//
// All experiments of the accuracy benchmark.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "bench/accuracy/experiment.h"

namespace jostle::bench::accuracy {

// In the order of the specification: free bodies, joints, contacts; then the members of families.
std::span<const Experiment> all_experiments();
// Experiments that exist in this run only, such as drawn members of families.
const Experiment* add_experiment(Experiment experiment);
const Experiment* find_experiment(std::string_view name);  // null: none

// Scenes with one set of parameters, one file per subject.
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
