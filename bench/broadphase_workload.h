// SPDX-License-Identifier: MIT
//
// The workload of jostle-bench broadphase: the initial boxes, and the fat boxes that change in each
// step. It is recorded before the measurement, so that only the broad phase is timed and all kinds
// do the same work.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "jostle/physics/aabb.h"

namespace jostle::bench {

enum class Arrangement {
    pile,   // a cube filled to 60 %, sides of 0.8 to 1.2 m
    flat,   // one layer along x and z, 2 m apart, sides of 0.8 to 1.2 m
    sizes,  // a cube filled to 60 %, sides of 0.1 to 10 m (as many of 0.1 to 1 m as of 1 to 10 m)
};

enum class Moving { all, few, none };  // few: one in 100, at least one

struct Move {
    std::uint32_t body;
    physics::Aabb fat;
};

struct BoxRay {
    physics::Vec3 origin, motion;
};

struct Workload {
    std::vector<physics::Aabb> fat;        // initial boxes, by body
    std::vector<std::vector<Move>> steps;  // fat boxes that bodies left, by step
    std::vector<physics::Aabb> tight;      // at the end, by body: the targets of the rays
    std::vector<BoxRay> rays;  // from 1 m above the bodies into their volume, at most 100 m long
    std::size_t moves = 0;     // in all steps
};

// Deterministic: equal arguments give the same workload on every machine.
Workload generate_workload(Arrangement arrangement, Moving moving, std::uint32_t bodies);

}  // namespace jostle::bench
