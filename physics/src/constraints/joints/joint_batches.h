// SPDX-License-Identifier: MIT
//
// Joints that hold bodies together point to point, in groups whose points are solved at once: by
// L D L^T of J M^-1 J^T, in float, eight groups of one pattern side by side. The rest of these
// joints, their limits and motors and axes, is swept as that of others, and so are contacts; the
// points are solved exactly before and after each sweep. What float leaves is taken away by the
// next solve. (D. Baraff, "Linear-time dynamics using Lagrange multipliers", 1996; for the pattern
// constraints/direct/block_ldl.h.)
//
// Made anew each step, by task of the solver; patterns are kept.
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

// What groups have in common that tie their bodies in the same way. Joints are numbered in their
// order, bodies in the order in which joints name them.
struct JointPattern {
    std::vector<JointEnds> joints;
    std::vector<std::uint8_t> pushed;  // by body
    std::vector<JointSystemBlock> system_blocks;
    // The matrix, three rows a joint; by elimination order.
    std::vector<int> node, diagonal, first_below, first_update;
    std::vector<BlockLdl::Below> below;
    std::vector<BlockLdl::Update> updates;
    int values = 0, max_below = 0;
    bool too_dense = false;     // then there is no more than that
    std::int64_t max_work = 0;  // for which
    std::int64_t work = 0;
    float compliance =
        0;  // part of a row's own response by which it gives way: nets have rows to spare
    std::uint64_t used = 0;  // when, by JointBatches::count
};

struct alignas(32) BatchJoint {
    std::int32_t block[8], lane[8];                 // where it is among the levels; -1: none
    float arm_a[3][8], arm_b[3][8], apart[3][8];    // as JointConstraintWide's
    float lever_a[3][8], lever_b[3][8], gap[3][8];  // now; to where the force acts
    float unknown[3][8];
    float impulse[3][8];  // of a sub-step, as JointConstraintWide's `point`
};
struct alignas(32) BatchBody {
    std::int32_t hot[8];
    float inverse_mass[3][8], inverse_inertia[6][8];  // as SolverBody's
    float rotation[4][8];                             // since the step began
    float moved[3][8];                                // likewise, m
    float spins_along[8];                             // as SolverBody's
    float v[3][8], w[3][8];                           // while solving; then what changed them
    float stiffness[6][8];  // of what the joints bear, as the body turns: N m s / rad
    float stiff[8];         // 1: too stiff for the sub-step; `inverse_inertia` knows of it
    float turned[3][8];     // rad/s: what that did
    bool any_along;         // some lanes' spins_along is 1
};
struct alignas(32) WideValue {
    float lane[8];
};

struct JointBatch {
    const JointPattern* pattern = nullptr;
    int groups = 0;  // lanes in use
    std::vector<BatchJoint> joints;
    std::vector<BatchBody> bodies;
    std::vector<WideValue> values;   // of the matrix; then of its factor
    std::vector<WideValue> inverse;  // six a joint, by elimination order: of the pivots
    std::vector<WideValue> column;   // scratch
};

// The same as the kernels see it: code built for one instruction set calls nothing of others.
struct BatchView {
    int groups, joint_count, body_count, system_block_count, value_count;
    BatchJoint* joints;
    BatchBody* bodies;
    WideValue *values, *inverse, *column;
    const JointEnds* ends;
    const std::uint8_t* pushed;
    const JointSystemBlock* system_blocks;
    const int *node, *diagonal, *first_below, *first_update;
    const BlockLdl::Below* below;
    const BlockLdl::Update* updates;
    JointConstraintWide* blocks;
    float compliance;
};
BatchView view_of(JointBatch& batch, JointLevels& levels);

struct JointBatches {
    std::vector<JointBatch> all;
    int used = 0;  // of them
    std::map<std::vector<std::int32_t>, std::unique_ptr<JointPattern>> patterns;
    std::uint64_t count = 0;  // how often batches were made

    std::span<JointBatch> batches() { return std::span(all).first(static_cast<std::size_t>(used)); }

    // Scratch.
    struct Size {
        int joints = 0, bodies = 0;
        JointSolverPreferences preferences = 0;
    };
    std::vector<std::int32_t> parent, first, next, last;
    std::vector<Size> size;  // by root
    std::vector<std::int32_t> key;
    std::vector<std::uint8_t> is_point;
    std::vector<JointSolverPreferences> preferences;

    std::vector<std::uint8_t> found;  // by place in JointLevels::joints: is in a batch
    int refused = 0;                  // joints that asked for it and are not
};

// Kinds whose two ends are held together as stiffly as can be.
bool holds_point(const JointKind& kind);

// Finds the groups among the joints of `levels` for which `is_point` (by place in levels.joints)
// holds: those of two joints or more that bodies tie together and that ask for nothing else, and
// single ones that ask for it. After assign_levels(). `bodies`: how many hot indices there are.
void find_batches(JointBatches& batches, JointLevels& levels,
                  std::span<const std::uint8_t> is_point, std::size_t bodies,
                  const JointSolverOptions& options = {});
// Once the blocks of the levels are written.
void load_batch(JointBatch& batch, const JointLevels& levels);

}  // namespace jostle::physics
