// SPDX-License-Identifier: MIT
//
// Helpers that read and check untrusted values of a module: SettingsReader for the settings in a
// scene, bounded() for saved fields.
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

/// Reads the settings of a module one by one and checks the range of each. Call number(), flag(),
/// body() and bytes() for every setting that the module accepts, then finish(). The settings must
/// outlive the reader.
class SettingsReader {
public:
    explicit SettingsReader(const physics::ModuleSettings& settings) : settings_(settings) {}

    /// Reads a number from low to high into `to`. If the setting is absent, `to` is unchanged. If a
    /// name occurs several times, the last one applies.
    void number(std::string_view name, double& to, double low, double high);
    /// Reads a flag: 0 or 1.
    void flag(std::string_view name, bool& to);
    /// Reads a body. The caller checks that it is suitable.
    void body(std::string_view name, physics::BodyId& to);
    /// Reads the contents of a file. The bytes stay valid as long as the settings. The caller
    /// checks the contents.
    void bytes(std::string_view name, std::span<const std::byte>& to);
    /// Returns the first error. A setting that was not read is an error too; its message lists the
    /// accepted names. Call it last.
    physics::Status finish();

private:
    void fail(std::string message);

    const physics::ModuleSettings& settings_;
    std::vector<std::string> numbers_, bodies_, bytes_;  ///< names read so far
    std::string fault_;                                  ///< first error; empty if none
};

/// Visits a number of a module's state. Loading fails if the value is not from low to high.
void bounded(physics::StateVisitor& v, std::string_view name, double& value, double low,
             double high);

/// Visits a vector of a module's state. Loading fails if a component is not from -max to max.
void bounded(physics::StateVisitor& v, std::string_view name, physics::Vec3& value, double max);

}  // namespace jostle::modules
