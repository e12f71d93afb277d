// SPDX-License-Identifier: MIT
//
// The golden hashes: what the state of each test scene hashes to as it runs, one line each, "scene
// step hash". Every build type, compiler and machine must give these.
#pragma once

#include <cstdio>
#include <string>

#include "support/test_scenes.h"

namespace jostle::test {

inline std::string golden_lines(int threads = 1) {
    std::string text;
    for (const TestScene& scene : test_scenes()) {
        physics::World world = scene.make(threads);
        for (int step = 0; step <= 400; step++) {
            if (step % 100 == 0) {
                char line[64];
                std::snprintf(line, sizeof line, "%s %d %016llx\n", scene.name.c_str(), step,
                              static_cast<unsigned long long>(physics::state_hash(world)));
                text += line;
            }
            disturb(world, step);
            must(world.step(1.0 / 60));
        }
    }
    return text;
}

}  // namespace jostle::test
