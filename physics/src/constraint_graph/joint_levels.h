// SPDX-License-Identifier: MIT
//
// The order in which joints are solved. A joint's level is above that of every joint before it that
// shares a body that they can push. Levels are solved one after the other, so each body has its
// joints in their order: a chain hears of its end within one pass, as if its joints were solved one
// by one. The joints of a level share no body; eight of a kind fill a block.
//
// Made anew each step, by task of the solver (stages/solver/solve_joints.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "physics/src/constraint_graph/joint_constraint_wide.h"
#include "physics/src/foundation/check.h"

namespace jostle::physics {

// Blocks of one kind that share no body: any order, any thread. Runs go one after the other.
struct JointRun {
    std::uint8_t kind = 0;   // index into JointKind, or driven_ball
    int begin = 0, end = 0;  // blocks
    int angular = -1;        // JointAngularWide of the first block; -1: the kind has none
    int row = -1;            // VelocityRowWide likewise
    int axes = -1;           // JointAxesWide likewise
    int gear = -1;           // JointGearWide likewise
};

struct LeveledJoint {
    std::uint32_t joint = 0;
    std::uint32_t kind = 0;                     // index into JointKind, or driven_ball
    std::int32_t a = 0, b = 0;                  // as JointConstraintWideMeta's
    std::int32_t carrier_a = 0, carrier_b = 0;  // of couples, likewise
    std::uint32_t run = 0;                      // level * joint kinds + kind
    std::int32_t block = 0, lane = 0;           // where it is
};

struct JointLevels {
    std::vector<LeveledJoint> joints;  // rising
    std::vector<JointRun> runs;        // in the order in which they are solved
    std::vector<JointConstraintWide> blocks;
    std::vector<JointAngularWide> angular;
    std::vector<VelocityRowWide> rows;
    std::vector<JointAxesWide> axes;
    std::vector<JointGearWide> gears;
    std::vector<JointConstraintWideMeta> metas;  // by block

    // Scratch.
    std::vector<std::uint64_t> marks;    // a bit per joint
    std::vector<std::uint32_t> reached;  // by hot index: level that the body's next joint may have
    std::vector<int> next_lanes;         // by run number: the next free lane
};

// `joints` are filled but for their runs: finds their levels and gives each a lane in a block.
// `bodies`: how many hot indices there are.
void assign_levels(JointLevels& levels, std::size_t bodies);

// Of a run or a block, by its first; null for kinds that have none.
inline JointAngularWide* angular_of(JointLevels& levels, int first) {
    ASSERT(first < static_cast<int>(levels.angular.size()));
    return first < 0 ? nullptr : &levels.angular[static_cast<std::size_t>(first)];
}

inline VelocityRowWide* row_of(JointLevels& levels, int first) {
    ASSERT(first < static_cast<int>(levels.rows.size()));
    return first < 0 ? nullptr : &levels.rows[static_cast<std::size_t>(first)];
}

inline JointAxesWide* axes_of(JointLevels& levels, int first) {
    ASSERT(first < static_cast<int>(levels.axes.size()));
    return first < 0 ? nullptr : &levels.axes[static_cast<std::size_t>(first)];
}

inline JointGearWide* gear_of(JointLevels& levels, int first) {
    ASSERT(first < static_cast<int>(levels.gears.size()));
    return first < 0 ? nullptr : &levels.gears[static_cast<std::size_t>(first)];
}

}  // namespace jostle::physics
