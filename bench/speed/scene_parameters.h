// SPDX-License-Identifier: MIT
//
// Parameters of measured scenes, such as the number of wheels: the options of jostle-bench speed
// that set them, the columns that record them, and the range that each scene accepts.
#pragma once

#include <array>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>

namespace jostle::bench {

enum class Parameter { count, vertices, wheels, cell, drum_speed };
inline constexpr std::size_t parameter_count = 5;

// By Parameter. Empty: not chosen, or the scene has no such parameter.
using ParameterValues = std::array<std::optional<double>, parameter_count>;

struct ParameterKind {
    const char* option;
    const char* type_name;  // of its value, in --help
    const char* help;
    const char* column;  // in result files
    bool is_whole;       // its values are whole numbers
};
// By Parameter.
std::span<const ParameterKind> parameter_kinds();

// The values of a parameter that a scene accepts. A maximum is a size that still runs in minutes.
struct ParameterRange {
    Parameter parameter;
    double standard;  // the default
    double least, most;
    bool is_even = false;
};

// The defaults, replaced by those of the chosen values that the scene has.
ParameterValues values_of(std::span<const ParameterRange> ranges, const ParameterValues& chosen);

// "1 to 20000", "2 to 32, even"
std::string range_text(const ParameterRange& range);
// Whether the range contains the value. Not a number is in no range.
bool accepts(const ParameterRange& range, double value);
// "count 1000, cell 0.5"; empty for a scene without parameters.
std::string parameter_text(const ParameterValues& values);

// One column for each parameter; null if the scene does not have it.
void write_parameters(nlohmann::ordered_json& json, const ParameterValues& values);
// Columns may be missing in files of earlier versions.
ParameterValues read_parameters(const nlohmann::ordered_json& json);

}  // namespace jostle::bench
