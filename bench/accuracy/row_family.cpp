// SPDX-License-Identifier: MIT
#include "bench/accuracy/row_family.h"

#include <cmath>
#include <utility>

#include "jostle/base/check.h"
#include "jostle/base/format_text.h"

namespace jostle::bench::accuracy {
namespace {

constexpr std::uint64_t seed_of_every_run = 1;

// SplitMix64 (Steele, Lea, Flood: "Fast splittable pseudorandom number generators", 2014).
class Draws {
public:
    explicit Draws(std::uint64_t seed) : state_(seed) {}

    double next() {  // 0 to 1
        state_ += 0x9e3779b97f4a7c15u;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
    }

private:
    std::uint64_t state_;
};

std::string_view name_without_unit(const Parameter& parameter) {
    return std::string_view(parameter.name).substr(0, parameter.name.find(','));
}

double value_at(const Parameter& parameter, double share) {
    const double low = parameter.low, high = parameter.high;
    switch (parameter.scale) {
        case Parameter::Scale::logarithmic:
            return low * std::pow(high / low, share);
        case Parameter::Scale::whole:
            return std::floor(low + share * (high - low + 1));
        case Parameter::Scale::linear:
            break;
    }
    return low + share * (high - low);
}

// Successive members take successive choices of each parameter, so that few members cover all of
// them, and combinations as in a Latin square.
std::vector<double> draw(const RowFamily& family, std::uint64_t seed, std::uint64_t index) {
    Draws draws(seed * 0x2545f4914f6cdd1du + index * 0xd6e8feb86659fd93u);
    Draws first_choices(seed);
    std::uint64_t combinations = 1;
    std::vector<double> values;
    for (const Parameter& parameter : family.parameters) {
        const double share = draws.next(), first = first_choices.next();
        const std::uint64_t count = parameter.choices.size();
        if (count == 0) {
            values.push_back(value_at(parameter, share));
            continue;
        }
        const auto offset = static_cast<std::uint64_t>(first * static_cast<double>(count));
        const std::uint64_t shift = combinations > 1 ? index / combinations : 0;
        values.push_back(static_cast<double>((index + shift + offset) % count));
        combinations *= count;
    }
    return values;
}

Experiment member(const RowFamily& family, std::string name, std::vector<double> given) {
    ASSERT(given.size() == family.parameters.size());
    const Values values(family.parameters, std::move(given));
    return {.name = std::move(name),
            .about = family.about + ": " + values.text(),
            .measures = family.measures,
            .tolerances = family.tolerances,
            .phases = family.phases,
            .max_hz = family.max_hz,
            .start = [start = family.start, values](double shift) { return start(values, shift); },
            .family = family.name,
            .limit = family.limit,
            .second_limit = family.second_limit,
            .limit_from_hz = family.limit_from_hz,
            .short_max_hz = family.short_max_hz};
}

std::vector<RowFamily> families_in_order() {
    std::vector<RowFamily> all;
    for (auto& families : {sliding_families(), floor_families(), linkage_families(),
                           tower_families(), travel_families()})
        all.insert(all.end(), families.begin(), families.end());
    return all;
}

}  // namespace

std::size_t Values::index_of(std::string_view name) const {
    std::size_t k = 0;
    while (k < parameters_.size() && name_without_unit(parameters_[k]) != name) k++;
    ASSERT(k < parameters_.size());
    return k;
}

double Values::operator[](std::string_view name) const {
    return values_[index_of(name)];
}

int Values::whole(std::string_view name) const {
    return static_cast<int>(std::lround((*this)[name]));
}

const std::string& Values::choice(std::string_view name) const {
    const std::size_t k = index_of(name);
    return parameters_[k].choices[static_cast<std::size_t>(std::lround(values_[k]))];
}

std::string Values::text() const {
    std::string text;
    for (std::size_t k = 0; k < parameters_.size(); k++) {
        const std::string name(name_without_unit(parameters_[k]));
        const std::string unit = parameters_[k].name.substr(
            std::min(parameters_[k].name.size(), name.size() + 1));  // with its space
        text += text.empty() ? "" : ", ";
        if (parameters_[k].choices.empty())
            text += name + format_text(" %.4g", values_[k]) + unit;
        else
            text += name + " " + choice(name);
    }
    return text;
}

std::span<const RowFamily> all_families() {
    static const std::vector<RowFamily> all = families_in_order();
    return all;
}

const RowFamily* find_family(std::string_view name) {
    for (const RowFamily& family : all_families())
        if (family.name == name) return &family;
    return nullptr;
}

std::vector<Experiment> members_of(const RowFamily& family) {
    std::vector<std::vector<double>> values = family.examples;
    for (int k = 0; k < family.drawn; k++)
        values.push_back(draw(family, seed_of_every_run, static_cast<std::uint64_t>(k)));
    std::vector<Experiment> members;
    for (std::size_t k = 0; k < values.size(); k++)
        members.push_back(member(family, family.name + "-" + std::to_string(k + 1), values[k]));
    return members;
}

std::vector<Experiment> drawn_members(const RowFamily& family, int count, std::uint64_t seed) {
    std::vector<Experiment> members;
    for (int k = 0; k < count; k++)
        members.push_back(
            member(family, family.name + "-s" + std::to_string(seed) + "-" + std::to_string(k + 1),
                   draw(family, seed, static_cast<std::uint64_t>(k))));
    return members;
}

}  // namespace jostle::bench::accuracy
