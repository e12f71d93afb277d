// SPDX-License-Identifier: MIT
//
// Groups of bodies with contacts that joints with limits connect, as figures. When an impact would
// open their joints or push them through their limits within a sub-step, all joints of the group
// are solved together once more, after the contacts (hold_limits.h). Scratch data of that.
#pragma once

#include <cstdint>
#include <vector>

#include "physics/src/constraints/direct/direct_group.h"

namespace jostle::physics {

// The system of a group, cached for its pattern.
struct LimitedGroup {
    DirectGroup solver;
    std::vector<std::uint32_t> bodies;  // hot indices by number in the solver; 0: immovable
    bool usable = false;
    bool used = false;  // since it was last listed; otherwise it is released
};

// The groups of a task.
struct LimitedGroups {
    struct Pair {
        std::int32_t a, b;  // hot indices, as of JointConstraintWideMeta
        std::uint32_t at;   // index of the joint in JointLevels::joints
    };
    std::vector<Pair> pairs;  // by group
    struct Range {
        std::uint32_t first = 0, last = 0;  // of the pairs
        std::uint32_t key = 0;              // the lowest joint
        bool gathered = false;              // its LimitedGroup belongs to this step
    };
    std::vector<Range> groups;
    std::vector<std::int32_t> parent;  // by hot index, for finding the groups
};

}  // namespace jostle::physics
