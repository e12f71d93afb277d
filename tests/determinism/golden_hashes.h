// SPDX-License-Identifier: MIT
//
// The golden hashes: state hashes of each test scene as it runs, one line each, "scene step hash".
// Every build type, compiler and machine must give these hashes, with any number of threads and any
// instruction set.
#pragma once

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "tests/support/test_scenes.h"

namespace jostle::test {

constexpr int golden_steps = 400;  // per scene
constexpr int golden_pace = 100;   // steps between hashes

// Hashes of the named scenes, or of all scenes if none is named.
inline std::vector<std::string> golden_lines(int threads = 1,
                                             const std::vector<std::string>& scenes = {},
                                             int steps = golden_steps) {
    std::vector<std::string> lines;
    for (const TestScene& scene : test_scenes()) {
        if (!scenes.empty() && std::find(scenes.begin(), scenes.end(), scene.name) == scenes.end())
            continue;
        physics::World world = scene.make(threads);
        for (int step = 0; step <= steps; step++) {
            if (step % golden_pace == 0) {
                char line[64];
                std::snprintf(line, sizeof line, "%s %d %016llx", scene.name.c_str(), step,
                              static_cast<unsigned long long>(physics::state_hash(world)));
                lines.push_back(line);
            }
            disturb(world, step);
            must(world.step(1.0 / 60));
        }
    }
    return lines;
}

// A combination of thread count and instruction set. All combinations give the same bits.
struct GoldenConfiguration {
    int threads;
    physics::InstructionSet set;
};

inline std::string to_string(const GoldenConfiguration& configuration) {
    return std::to_string(configuration.threads) +
           (configuration.threads == 1 ? " thread, " : " threads, ") +
           physics::instruction_set_name(configuration.set);
}

// The first configuration has one thread and the default instruction set of this machine. Each
// further one adds a thread and takes the next set. The slowest set, scalar code, is used once.
inline std::vector<GoldenConfiguration> golden_configurations(int count) {
    const auto sets = physics::available_instruction_sets();
    const std::size_t fast = sets.size() > 1 ? sets.size() - 1 : 1;
    std::vector<GoldenConfiguration> configurations;
    for (std::size_t k = 0; k < static_cast<std::size_t>(count); k++) {
        const bool slowest = k + 1 == sets.size();
        configurations.push_back({static_cast<int>(k % 8) + 1,
                                  slowest ? sets.front() : sets[sets.size() - 1 - k % fast]});
    }
    return configurations;
}

}  // namespace jostle::test
