// SPDX-License-Identifier: MIT
//
// Contact constraints in the layout that the solver reads: eight manifolds per block, one per lane.
// A manifold occupies its lane from its begin to its end. The lane stores the accumulated impulses,
// so no step prepares, copies or stores them.
//
// All points of a manifold share its normal. Along the normal a manifold has three degrees of
// freedom: approach at the centre and tilt about two tangents. The velocity of point i is vn_i = u0
// + y_i u1 - x_i u2, and the 4x4 matrix of the normals is J G J^T with one symmetric 3x3 matrix G.
// The points are solved in registers against u; bodies are read and written once.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "jostle/base/check.h"
#include "physics/src/constraint_graph/wide_rows.h"

namespace jostle::physics {

inline constexpr int block_lanes = 8;
inline constexpr std::uint32_t no_contact = 0xffffffff;

// Gap of an unused point. Its impulse solves to zero without a mask.
inline constexpr float no_point = 1e6f;

// 200 bytes per manifold. Units: m, N s, kg. Floats are relative to the poses at the start of the
// step.
struct alignas(64) ContactConstraintWide {
    std::int32_t a[8], b[8];  // hot body indices; negative for unused lanes
    float normal[3][8];       // from a to b
    float tangent[3][8];      // second tangent = normal x tangent
    float arm_a[3][8];        // from each centre of mass to the manifold's centre
    float arm_b[3][8];
    float x[4][8], y[4][8];  // points in the tangent plane, relative to the centre
    float gap[4][8];         // separation at the start of the step
    float lambda[4][8];      // accumulated normal impulses in one sub-step
    float friction[2][8];    // accumulated friction impulse at the centre
    float torsion[8];        // accumulated torsional friction impulse about the normal
    float g[6][8];  // 00 01 02 11 12 22: inverse effective mass along (normal; tilt t1; tilt t2)
    float friction_mass[3][8];  // inverse of the 2x2 tangential block: 00 01 11
    float torsion_mass[8];
    float mu[8];
    // Mean distance of the points from the centre, m. Limits torsional friction; a rotation counts
    // as motion by this lever arm.
    float friction_radius[8];
    float mean_impulse[4][8];  // running mean of lambda: the part that a soft contact retains
    // The body that the contact point moves with: 0 for a, 1 for b, intermediate values blend.
    float anchor_blend[8];
};
inline constexpr int wide_rows = 50;       // of 32 bytes each, a and b included
inline constexpr int first_saved_row = 2;  // after a and b
static_assert(sizeof(ContactConstraintWide) == wide_rows * 32);

// Per-lane flags, one bit each. This is the only list of flags: clearing, moving, saving and
// deriving a lane iterate over it.
enum class LaneFlag : std::uint8_t {
    needs_rebuild,  // its manifold must be rebuilt before the next solve
    touching,       // its contact is touching
    touching_now,   // result of the last pass; copied to `touching` when islands are merged
    anisotropic,    // one of its bodies has an anisotropic inertia
    locked,         // one of its bodies has locked axes
    bounces,        // restitution > 0
    rolls,          // its RollingWide lane is valid
    reports,        // a shape with report_stays
    unusual,        // non-default length and speed scales (foundation/size_scale.h)
};
inline constexpr std::size_t lane_flag_count = 9;

// Read once per step, so stored separately from the constraint.
struct alignas(64) ContactConstraintWideMeta {
    float moved[8];  // m, relative motion since the manifold was built
    float restitution[8];
    std::uint32_t contact[8];                  // owner of the lane, or no_contact
    std::uint8_t flags[lane_flag_count] = {};  // indexed by LaneFlag; one bit per lane
    // Size of the smaller body in metres, as the upper half of a float; 0 for the default scale.
    // Derived.
    std::uint16_t size[8] = {};

    // Always inlined because kernels of several instruction sets call these functions.
    [[gnu::always_inline]] std::uint8_t& bits(LaneFlag flag) {
        return flags[static_cast<std::size_t>(flag)];
    }
    [[gnu::always_inline]] std::uint8_t bits(LaneFlag flag) const {
        return flags[static_cast<std::size_t>(flag)];
    }
    bool has(LaneFlag flag, int lane) const { return (bits(flag) >> lane & 1) != 0; }
    void set(LaneFlag flag, int lane, bool on) {
        ASSERT(lane >= 0 && lane < block_lanes);
        const auto bit = static_cast<std::uint8_t>(1u << lane);
        std::uint8_t& byte = bits(flag);
        byte = static_cast<std::uint8_t>(on ? byte | bit : byte & ~bit);
    }
};
static_assert(sizeof(ContactConstraintWideMeta) == 128);

// Data that few materials need: rolling resistance, torsional friction, moving surfaces. Not read
// if no lane rolls.
struct alignas(64) RollingWide {
    float surface[2][8];          // m/s along the tangents: velocity of b's surface relative to a's
    float rolling[8];             // m: maximum torque per unit of normal force
    float torsional_friction[8];  // m, about the normal
    float roll[2][8];             // accumulated angular impulse about the tangents, N m s
};
inline constexpr int rolling_rows = 6;
static_assert(sizeof(RollingWide) == rolling_rows * 32);

// Scratch data of blocks that bounce, valid within one step.
struct alignas(64) RestitutionWide {
    float approach[4][8];  // m/s at the start of the step; negative means approaching
    float peak[4][8];      // largest impulse in any sub-step
};

// The type of the second body of a constraint, which selects the kernel.
enum class PairKind : std::uint8_t {
    dynamic,    // read and written
    kinematic,  // read only
    static_,    // not read
};

// Returns whether a manifold has one point, from the gap of the second point.
inline bool is_single_point(float second_gap) {
    return second_gap > 0.5f * no_point;
}

// Row `row` of one lane as a float. Rows 0 and 1 of a constraint hold the body indices.
inline float& float_at(ContactConstraintWide& block, int row, int lane) {
    return reinterpret_cast<float*>(&block)[row * 8 + lane];
}
inline float& float_at(RollingWide& rolling, int row, int lane) {
    return reinterpret_cast<float*>(&rolling)[row * 8 + lane];
}

// One lane of a block.
struct ContactLaneRef {
    ContactConstraintWide* block;
    ContactConstraintWideMeta* meta;
    RollingWide* rolling;
    int lane;
};
inline Vec3 normal_of(const ContactLaneRef& lane_ref) {
    return get_lane(lane_ref.block->normal, lane_ref.lane);
}

// A manifold outside the graph, as stored for a sleeping island.
struct SavedContact {
    std::uint32_t contact = no_contact;
    std::array<float, wide_rows - first_saved_row> rows{};  // without a and b
    std::array<float, rolling_rows> rolling_values{};
    float moved = 0, restitution = 0;
    bool needs_rebuild = false, rolls = false;
};
inline bool is_single_point(const SavedContact& saved) {
    return is_single_point(
        saved.rows[offsetof(ContactConstraintWide, gap) / 32 + 1 - first_saved_row]);
}

}  // namespace jostle::physics
