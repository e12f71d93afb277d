// SPDX-License-Identifier: MIT
#include "bench/accuracy/experiment_list.h"

#include <deque>
#include <utility>

#include "bench/accuracy/row_family.h"

namespace jostle::bench::accuracy {
namespace {

// The order of the specification: F, J, C.
std::vector<Experiment> in_order() {
    std::vector<Experiment> all;
    for (const auto& family : {free_experiments(), top_experiments(), pendulum_experiments(),
                               machine_experiments(), friction_experiments(), impact_experiments(),
                               stack_experiments(), pile_experiments(), chaos_experiments()})
        all.insert(all.end(), family.begin(), family.end());
    for (const RowFamily& family : all_families())
        for (Experiment& member : members_of(family)) all.push_back(std::move(member));
    return all;
}

std::deque<Experiment>& added_experiments() {
    static std::deque<Experiment> added;
    return added;
}

}  // namespace

std::span<const Experiment> all_experiments() {
    static const std::vector<Experiment> all = in_order();
    return all;
}

const Experiment* add_experiment(Experiment experiment) {
    if (const Experiment* found = find_experiment(experiment.name)) return found;
    return &added_experiments().emplace_back(std::move(experiment));
}

const Experiment* find_experiment(std::string_view name) {
    for (const Experiment& experiment : all_experiments())
        if (experiment.name == name) return &experiment;
    for (const Experiment& experiment : added_experiments())
        if (experiment.name == name) return &experiment;
    return nullptr;
}

}  // namespace jostle::bench::accuracy
