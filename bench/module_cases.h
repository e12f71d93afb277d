// SPDX-License-Identifier: MIT
//
// The worlds of jostle-bench modules.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>

namespace jostle::bench {

class ModuleScene {
public:
    virtual ~ModuleScene() = default;
    // Sets the controls of the objects and steps the world. k: index of the step, from 0.
    virtual void step(int k) = 0;
    // Returns the RMS distance of the objects from a closed form, m; nullopt if there is none.
    virtual std::optional<double> error() const { return std::nullopt; }
    // Other error figures of the run so far; empty if the case has none.
    virtual std::string errors() { return {}; }
};

struct ModuleCase {
    const char* name;
    int objects;  // default number of objects
    std::unique_ptr<ModuleScene> (*make)(int objects);
    int steps = 0;  // default number of timed steps; 0: that of the command
};

std::span<const ModuleCase> module_cases();

}  // namespace jostle::bench
