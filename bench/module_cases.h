// SPDX-License-Identifier: MIT
//
// The worlds of jostle-bench modules.
#pragma once

#include <memory>
#include <span>

namespace jostle::bench {

class ModuleScene {
public:
    virtual ~ModuleScene() = default;
    // What whoever drives the objects does, and one step of the world. k: from 0.
    virtual void step(int k) = 0;
};

struct ModuleCase {
    const char* name;
    int objects;  // unless asked for otherwise
    std::unique_ptr<ModuleScene> (*make)(int objects);
};

std::span<const ModuleCase> module_cases();

}  // namespace jostle::bench
