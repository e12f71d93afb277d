// SPDX-License-Identifier: MIT
//
// Groups of point-to-point joints whose point rows are solved simultaneously, by L D L^T of J M^-1
// J^T in float, eight groups with the same pattern in parallel. The other rows of these joints
// (limits, motors and axes) are solved iteratively like those of other joints, and so are contacts.
// The point rows are solved exactly before and after each iteration. The next solve corrects the
// rounding error of float. (D. Baraff, "Linear-time dynamics using Lagrange multipliers", 1996; for
// the pattern see jostle/physics/block_ldl.h.)
//
// The joints of a body with many, as of a chassis with its wheels, are all coupled. Such a hub is a
// pair of nodes of its own instead (joint_system_blocks.h), whose unknowns are the linear and the
// angular impulse that its joints exert. With W = M^-1 of the hub:
//     | A      J W |
//     | W J'   -W  |
// Neither a heavy nor a light hub, nor a locked axis, needs an inverse of W.
//
// Rebuilt in each step per solver task; patterns are cached.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "jostle/physics/joint_defs.h"
#include "physics/src/constraint_graph/joint_levels.h"
#include "physics/src/constraint_graph/joint_solver_preferences.h"
#include "physics/src/constraints/direct/joint_system_blocks.h"

namespace jostle::physics {

// Data shared by all groups with the same connectivity. Joints are numbered in their order, bodies
// in the order of their first occurrence in the joints.
struct JointPattern {
    std::vector<JointEnds> joints;
    std::vector<std::uint8_t> pushed;  // indexed by body
    std::vector<JointSystemBlock> system_blocks;
    JointHubs hubs;
    std::vector<int> position;  // indexed by joint: in elimination order
    // The matrix, three rows per node, in elimination order.
    std::vector<int> diagonal, first_below, first_update;
    std::vector<std::uint8_t> negative;  // nodes of hubs
    std::vector<BlockLdl::Below> below;
    std::vector<BlockLdl::Update> updates;
    int values = 0, max_below = 0;
    bool too_dense = false;     // the other fields are then not set
    std::int64_t max_work = 0;  // limit that was exceeded
    std::int64_t work = 0;
    bool locked = false;  // may contain bodies with locked axes
    // Compliance of a row relative to its own response. Nonzero for redundant nets.
    float compliance = 0;
    std::uint64_t used = 0;  // value of JointBatches::count at the last use
};

struct alignas(32) BatchJoint {
    std::int32_t block[8], lane[8];               // position in the levels; -1 if none
    float arm_a[3][8], arm_b[3][8], apart[3][8];  // see JointConstraintWide
    float lever_a[3][8], lever_b[3][8],
        gap[3][8];        // current; from the centres to where the force acts
    float impulse[3][8];  // of a sub-step; see JointConstraintWide::point
};
struct alignas(32) BatchBody {
    std::int32_t hot[8];
    float inverse_mass[3][8], inverse_inertia[6][8];  // see SolverBody
    float rotation[4][8];                             // since the start of the step
    float moved[3][8];                                // since the start of the step, m
    float spins_along[8];                             // see SolverBody
    float v[3][8], w[3][8];                           // during the solve; afterwards the changes
    float stiffness[6][8];  // geometric stiffness of the joint load: N m s / rad
    float stiff[8];         // 1: too stiff for the sub-step; included in `inverse_inertia`
    float turned[3][8];     // rad/s: the resulting change of spin
    bool any_along;         // spins_along is 1 in some lanes
};
struct alignas(32) WideValue {
    float lane[8];
};

struct JointBatch {
    const JointPattern* pattern = nullptr;
    int groups = 0;  // lanes in use
    std::vector<BatchJoint> joints;
    std::vector<BatchBody> bodies;
    std::vector<WideValue> values;   // of the matrix, then of its factor
    std::vector<WideValue> inverse;  // of the pivots, six per node, in elimination order
    std::vector<WideValue> unknown;  // three per node, in elimination order
    std::vector<WideValue> column;   // scratch memory
};

// View of a batch for the kernels: code built for one instruction set must not call code built for
// another.
struct BatchView {
    int groups, joint_count, body_count, node_count, system_block_count, value_count;
    BatchJoint* joints;
    BatchBody* bodies;
    WideValue *values, *inverse, *unknown, *column;
    const JointEnds* ends;
    const std::uint8_t* pushed;
    const JointSystemBlock* system_blocks;
    const JointHub* hubs;
    const JointHubBlock* hub_blocks;
    int hub_count, hub_block_count;
    const int *position, *diagonal, *first_below, *first_update;
    const std::uint8_t* negative;
    const BlockLdl::Below* below;
    const BlockLdl::Update* updates;
    JointConstraintWide* blocks;
    float compliance;
};
BatchView view_of(JointBatch& batch, JointLevels& levels);

struct JointBatches {
    std::vector<JointBatch> all;
    int used = 0;  // number of batches in use
    std::map<std::vector<std::int32_t>, std::unique_ptr<JointPattern>> patterns;
    std::uint64_t count = 0;  // number of times that batches were built

    std::span<JointBatch> batches() { return std::span(all).first(static_cast<std::size_t>(used)); }

    // Scratch memory.
    struct Size {
        int joints = 0, bodies = 0;
        JointSolverPreferences preferences = 0;
        bool locked = false;  // see JointSolverOptions
    };
    std::vector<std::int32_t> parent, first, next, last;
    std::vector<Size> size;  // indexed by root
    std::vector<std::int32_t> key;
    std::vector<std::uint8_t> is_point;
    std::vector<JointSolverPreferences> preferences;
    std::vector<std::uint8_t> locked;

    std::vector<std::uint8_t> found;  // indexed like JointLevels::joints: the joint is in a batch
    int refused = 0;                  // joints that requested a batch but are in none
};

// Whether a kind holds the two ends together as stiffly as possible.
bool holds_point(const JointKind& kind);

// Forms groups among the joints of `levels` for which `is_point` (indexed like levels.joints) is
// set: two or more joints that bodies connect and that have no other preference, and single joints
// that request it. Call after assign_levels(). `bodies`: number of hot indices.
void find_batches(JointBatches& batches, JointLevels& levels,
                  std::span<const std::uint8_t> is_point, std::size_t bodies,
                  const JointSolverOptions& options = {});
// Call after the blocks of the levels are written.
void load_batch(JointBatch& batch, const JointLevels& levels);

}  // namespace jostle::physics
