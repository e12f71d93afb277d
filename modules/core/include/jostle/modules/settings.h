// SPDX-License-Identifier: MIT
//
// What a scene says of a module, read setting by setting, each in its range; and saved fields,
// which are foreign as well.
//
//     SettingsReader settings(given);
//     settings.number("height", height_, 0.3, 3);   // m
//     settings.body("craft", craft_);
//     if (Status read = settings.finish(); !read.ok()) return read;
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "jostle/physics/module.h"

namespace jostle::modules {

class SettingsReader {
public:
    explicit SettingsReader(const physics::ModuleSettings& settings) : settings_(settings) {}

    // Absent: `to` keeps its value. Of several of a name the last counts.
    void number(std::string_view name, double& to, double low, double high);
    void flag(std::string_view name, bool& to);  // 0 or 1
    void body(std::string_view name, physics::BodyId& to);
    // As long as the settings are. What they mean is for the caller to check.
    void bytes(std::string_view name, std::span<const std::byte>& to);
    // A setting that nobody asked for is an error, too, which lists what there is. After all
    // others.
    physics::Status finish();

private:
    void fail(std::string message);

    const physics::ModuleSettings& settings_;
    std::vector<std::string> numbers_, bodies_, bytes_;  // that were asked for
    std::string fault_;                                  // the first; empty: none
};

// A number of a module's state: saves it, and ends a load when it is not from low to high.
void bounded(physics::StateVisitor& v, std::string_view name, double& value, double low,
             double high);

// ... each component within `most`.
void bounded(physics::StateVisitor& v, std::string_view name, physics::Vec3& value, double most);

}  // namespace jostle::modules
