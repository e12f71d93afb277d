// SPDX-License-Identifier: MIT
#include "jostle/modules/settings.h"

#include <algorithm>
#include <cstdio>

#include "jostle/base/nearest_name.h"

namespace jostle::modules {
namespace {

using physics::Error;
using physics::ErrorCode;
using physics::Status;

// Prints a number in its shortest form: 0.3, not 0.300000.
std::string text(double number) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.10g", number);
    return digits;
}

std::string range(double low, double high) {
    return text(low) + " to " + text(high);
}

bool has(const std::vector<std::string>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::string list(const std::vector<std::string>& names) {
    std::string all;
    for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
    return all.empty() ? "none" : all;
}

// `kind`: "", "body " or "file ".
std::string unknown(const std::string& kind, const std::string& name,
                    const std::vector<std::string>& names) {
    return "unknown " + kind + "setting " + name + "; must be one of: " + list(names) +
           did_you_mean(name, names);
}

}  // namespace

void SettingsReader::fail(std::string message) {
    if (fault_.empty()) fault_ = std::move(message);
}

void SettingsReader::number(std::string_view name, double& to, double low, double high) {
    numbers_.emplace_back(name);
    for (const auto& [given, value] : settings_.numbers) {
        if (given != name) continue;
        if (value >= low && value <= high)
            to = value;
        else
            fail(given + " is " + text(value) + "; it must be from " + range(low, high));
    }
}

void SettingsReader::flag(std::string_view name, bool& to) {
    double value = to ? 1 : 0;
    number(name, value, 0, 1);
    if (value != 0 && value != 1)
        fail(std::string(name) + " is " + text(value) + "; it must be 0 or 1");
    to = value != 0;
}

void SettingsReader::body(std::string_view name, physics::BodyId& to) {
    bodies_.emplace_back(name);
    for (const auto& [given, body] : settings_.bodies)
        if (given == name) to = body;
}

void SettingsReader::bytes(std::string_view name, std::span<const std::byte>& to) {
    bytes_.emplace_back(name);
    for (const auto& [given, bytes] : settings_.bytes)
        if (given == name) to = bytes;
}

Status SettingsReader::finish() {
    for (const auto& [name, value] : settings_.numbers)
        if (!has(numbers_, name)) fail(unknown("", name, numbers_));
    for (const auto& [name, body] : settings_.bodies)
        if (!has(bodies_, name)) fail(unknown("body ", name, bodies_));
    for (const auto& [name, bytes] : settings_.bytes)
        if (!has(bytes_, name)) fail(unknown("file ", name, bytes_));
    if (fault_.empty()) return {};
    return Error{ErrorCode::invalid_argument, fault_};
}

void bounded(physics::StateVisitor& v, std::string_view name, double& value, double low,
             double high) {
    v.field(name, value);
    if (v.loading() && !(value >= low && value <= high))
        v.fail(name, "is out of range; it must be from " + range(low, high));
}

void bounded(physics::StateVisitor& v, std::string_view name, physics::Vec3& value, double most) {
    v.enter(name);
    bounded(v, "x", value.x, -most, most);
    bounded(v, "y", value.y, -most, most);
    bounded(v, "z", value.z, -most, most);
    v.leave();
}

}  // namespace jostle::modules
