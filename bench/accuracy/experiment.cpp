// SPDX-License-Identifier: MIT
#include "bench/accuracy/experiment.h"

namespace jostle::bench::accuracy {
namespace {

// The order of the specification: F, J, C.
std::vector<Experiment> in_order() {
    std::vector<Experiment> all;
    for (const auto& family : {free_experiments(), top_experiments(), pendulum_experiments(),
                               machine_experiments(), friction_experiments(), impact_experiments(),
                               stack_experiments(), pile_experiments(), chaos_experiments()})
        all.insert(all.end(), family.begin(), family.end());
    return all;
}

}  // namespace

std::span<const Experiment> all_experiments() {
    static const std::vector<Experiment> all = in_order();
    return all;
}

const Experiment* find_experiment(std::string_view name) {
    for (const Experiment& experiment : all_experiments())
        if (experiment.name == name) return &experiment;
    return nullptr;
}

}  // namespace jostle::bench::accuracy
