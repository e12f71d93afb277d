// SPDX-License-Identifier: MIT
//
// A family of experiments: scenes that differ in parameters such as the yaw or the mass ratio. The
// members with explicit values and some drawn ones are rows of every run; --draw runs any number of
// other members. All draws are reproducible from a seed.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bench/accuracy/experiment.h"

namespace jostle::bench::accuracy {

struct Parameter {
    std::string name;  // with its unit, such as "yaw, deg"
    double low = 0, high = 1;
    enum class Scale { linear, logarithmic, whole } scale = Scale::linear;
    std::vector<std::string> choices = {};  // the value is the index of a choice
};

// The values of all parameters of a family.
class Values {
public:
    Values(std::span<const Parameter> parameters, std::vector<double> values)
        : parameters_(parameters.begin(), parameters.end()), values_(std::move(values)) {}

    double operator[](std::string_view name) const;  // the name without the unit
    int whole(std::string_view name) const;
    const std::string& choice(std::string_view name) const;
    std::string text() const;  // such as "base box, yaw 45 deg"

private:
    std::size_t index_of(std::string_view name) const;

    std::vector<Parameter> parameters_;
    std::vector<double> values_;
};

struct RowFamily {
    std::string name;      // such as slide; members are slide-1, slide-2 and so on
    std::string about;     // the scene
    std::string measures;  // the two error measures
    std::vector<double> tolerances;
    std::vector<Parameter> parameters;
    std::vector<std::vector<double>> examples = {};  // members with explicit values
    int drawn = 4;                                   // further members of every run
    double limit = 0, second_limit = 0;              // as in Experiment
    double limit_from_hz = 60;
    int phases = 1;
    double max_hz = 1920, short_max_hz = 240;
    std::function<ExperimentRun(const Values&, double shift)> start;
};

// In the order of the issues that they cover: contacts, floors, joints, stacks, time, free bodies.
std::span<const RowFamily> all_families();
const RowFamily* find_family(std::string_view name);  // null: none

// The members of every run: the examples, then those drawn with seed 1.
std::vector<Experiment> members_of(const RowFamily& family);
// Other members, named after the family, the seed and a number: slide-s7-1. Member k of a seed does
// not depend on the count.
std::vector<Experiment> drawn_members(const RowFamily& family, int count, std::uint64_t seed);

// The families, one file per subject.
std::vector<RowFamily> sliding_families();  // sliding, rolling and bouncing bodies
std::vector<RowFamily> floor_families();    // floors of many pieces, presses
std::vector<RowFamily> linkage_families();  // joints
std::vector<RowFamily> tower_families();    // stacks
std::vector<RowFamily> travel_families();   // carousels, triggers, free fall

}  // namespace jostle::bench::accuracy
