// SPDX-License-Identifier: MIT
//
// The order in which joints are solved. A joint's level is above the levels of all earlier joints
// that share a movable body with it. Levels are solved in sequence, so each body processes its
// joints in their order: within one pass an impulse travels through a whole chain, as if its joints
// were solved one by one. The joints of a level share no body; eight joints of a kind fill a block.
//
// Rebuilt in each step, per solver task (stages/solver/solve_joints.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "jostle/base/check.h"
#include "physics/src/constraint_graph/joint_constraint_wide.h"

namespace jostle::physics {

// Blocks of one kind that share no body, so they can run in any order and on any thread. Runs are
// executed in sequence.
struct JointRun {
    std::uint8_t kind = 0;   // see kernel_of()
    int begin = 0, end = 0;  // blocks
    int angular = -1;        // JointAngularWide of the first block; -1 if the kind has none
    int row = -1;            // VelocityRowWide of the first block; -1 if the kind has none
    int axes = -1;           // JointAxesWide of the first block; -1 if the kind has none
    int gear = -1;           // JointGearWide of the first block; -1 if the kind has none
};

struct LeveledJoint {
    std::uint32_t joint = 0;
    std::uint32_t kind = 0;                     // see kernel_of()
    std::int32_t a = 0, b = 0;                  // see JointConstraintWideMeta
    std::int32_t carrier_a = 0, carrier_b = 0;  // for geared pairs; see JointConstraintWideMeta
    std::uint32_t run = 0;                      // level * joint kinds + kind
    std::int32_t block = 0, lane = 0;           // its position
};

struct JointLevels {
    std::vector<LeveledJoint> joints;  // in ascending order
    std::vector<JointRun> runs;        // in solving order
    std::vector<JointConstraintWide> blocks;
    std::vector<JointAngularWide> angular;
    std::vector<VelocityRowWide> rows;
    std::vector<JointAxesWide> axes;
    std::vector<JointGearWide> gears;
    std::vector<JointConstraintWideMeta> metas;  // indexed by block

    // Scratch.
    std::vector<std::uint64_t> marks;    // one bit per joint
    std::vector<std::uint32_t> reached;  // by hot index: lowest level for the body's next joint
    std::vector<int> next_lanes;         // by run number: the next free lane
};

// Assigns a level and a lane in a block to each joint. All fields of `joints` except the runs must
// be set. `bodies`: number of hot indices.
void assign_levels(JointLevels& levels, std::size_t bodies);

// Data of a run or block, by the index of its first entry; null for kinds without such data.
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
