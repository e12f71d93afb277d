// SPDX-License-Identifier: MIT
//
// The work that jostle-bench broadphase gives to each broad phase: where boxes stand at the start
// and which fat boxes change in which step. It is recorded before any clock runs, so that the time
// measured is the broad phase's own, and so that all kinds do exactly the same.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "jostle/physics/aabb.h"

namespace jostle::bench {

enum class Arrangement {
    pile,   // a cube filled to 60 %, sides of 0.8 to 1.2 m
    flat,   // one layer along x and z, 2 m apart, sides of 0.8 to 1.2 m
    sizes,  // a cube filled to 60 %, sides of 0.1 to 10 m (as many of 0.1 to 1 as of 1 to 10)
};

enum class Moving { all, few, none };  // few: one in a hundred, at least one

struct Move {
    std::uint32_t body;
    physics::Aabb fat;
};

struct BoxRay {
    physics::Vec3 origin, motion;
};

struct Workload {
    std::vector<physics::Aabb> fat;        // at the start, by body
    std::vector<std::vector<Move>> steps;  // the fat boxes that bodies left, step by step
    std::vector<physics::Aabb> tight;      // at the end, by body: what rays look for
    std::vector<BoxRay> rays;  // from 1 m above into the middle of it, at most 100 m long
    std::size_t moves = 0;     // of all steps together
};

// The same for the same arguments, on every machine.
Workload generate_workload(Arrangement arrangement, Moving moving, std::uint32_t bodies);

}  // namespace jostle::bench
