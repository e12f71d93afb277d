// SPDX-License-Identifier: MIT
#include "bench/speed/scene_parameters.h"

#include <cmath>
#include <cstdint>
#include <cstdio>

namespace jostle::bench {
namespace {

constexpr ParameterKind parameter_table[] = {
    {"--count", "N",
     "Number of bodies, links, figures, trees or stacks\n[default: that of the scene; see below]",
     "count", true},
    {"--vertices", "N",
     "Vertices of each hull; 64 or more are prisms\n[default: that of the scene; see below]",
     "vertices", true},
    {"--wheels", "N", "Wheels of each vehicle\n[default: that of the scene; see below]", "wheels",
     true},
    {"--cell", "METRES", "Cell size of the mesh\n[default: that of the scene; see below]", "cell_m",
     false},
    {"--drum-speed", "DEGREES",
     "Speed of the drum, degrees per second\n[default: that of the scene; see below]",
     "drum_speed_deg_per_s", false},
};
static_assert(std::size(parameter_table) == parameter_count);

// Numbers as in --help: without an exponent up to 999999.
std::string plain_number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

const ParameterKind& info_of(const ParameterRange& range) {
    return parameter_table[static_cast<std::size_t>(range.parameter)];
}

}  // namespace

std::span<const ParameterKind> parameter_kinds() {
    return parameter_table;
}

ParameterValues values_of(std::span<const ParameterRange> ranges, const ParameterValues& chosen) {
    ParameterValues values;
    for (const ParameterRange& range : ranges) {
        const auto k = static_cast<std::size_t>(range.parameter);
        values[k] = chosen[k].value_or(range.standard);
    }
    return values;
}

std::string range_text(const ParameterRange& range) {
    return plain_number(range.least) + " to " + plain_number(range.most) +
           (range.is_even ? ", even" : "");
}

bool accepts(const ParameterRange& range, double value) {
    if (!(value >= range.least && value <= range.most)) return false;
    if (range.is_even) return std::fmod(value, 2) == 0;
    return !info_of(range).is_whole || std::floor(value) == value;
}

std::string parameter_text(const ParameterValues& values) {
    std::string text;
    for (std::size_t k = 0; k < parameter_count; k++)
        if (values[k])
            text += (text.empty() ? "" : ", ") + std::string(parameter_table[k].option + 2) + " " +
                    plain_number(*values[k]);
    return text;
}

void write_parameters(nlohmann::ordered_json& json, const ParameterValues& values) {
    for (std::size_t k = 0; k < parameter_count; k++) {
        nlohmann::ordered_json& field = json[parameter_table[k].column];
        if (!values[k])
            field = nullptr;
        else if (parameter_table[k].is_whole)
            field = static_cast<std::int64_t>(*values[k]);
        else
            field = *values[k];
    }
}

ParameterValues read_parameters(const nlohmann::ordered_json& json) {
    ParameterValues values;
    for (std::size_t k = 0; k < parameter_count; k++) {
        const auto found = json.find(parameter_table[k].column);
        if (found != json.end() && !found->is_null()) values[k] = found->get<double>();
    }
    return values;
}

}  // namespace jostle::bench
