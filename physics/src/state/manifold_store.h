// SPDX-License-Identifier: MIT
//
// Manifolds in solver order: blocks of eight of one colour side by side. A lane is taken when a
// manifold begins and kept until it ends; the impulses live in it, so nothing is prepared from,
// copied to or stored in another structure each step. All constraints of a colour have different
// moving bodies, so blocks of a colour may be solved in any order.
//
// All points of a manifold share its normal, so along it a manifold has three degrees of freedom:
// approach at the centre and tilt about two tangents. Point i sees vn_i = u0 + y_i u1 - x_i u2, and
// the 4x4 matrix of the normals is J G J^T with one symmetric 3x3 matrix G. The points are solved
// in registers against u; bodies are read and written once.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "state/tier.h"

namespace jostle::physics {

inline constexpr float no_point =
    1e6f;  // gap of an unused point: solves to zero by itself, without a mask

// 200 bytes a manifold. Units: m, N s, kg; floats relative to the poses at the start of the step.
struct alignas(64) ContactConstraintWide {
    std::int32_t a[8], b[8];  // hot body indices; of unused lanes below 0
    float normal[3][8];       // from a to b
    float tangent[3][8];      // second tangent = normal x tangent
    float arm_a[3][8];        // centre of the manifold from each centre of mass
    float arm_b[3][8];
    float x[4][8], y[4][8];  // points in the plane of the tangents, from the centre
    float gap[4][8];         // separation at the start of the step
    float lambda[4][8];      // accumulated normal impulses of one sub-step
    float friction[2][8];    // accumulated friction impulse at the centre
    float torsion[8];        // ... and about the normal
    float g[6][8];  // 00 01 02 11 12 22: inverse effective mass along (normal; tilt t1; tilt t2)
    float friction_mass[3][8];  // inverse of the 2x2 tangential block: 00 01 11
    float torsion_mass[8];
    float mu[8];
    float friction_radius[8];  // mean distance of the points from the centre: limits twist, ages by
                               // rotation
    float mean_impulse[4][8];  // slow mean of lambda: what a soft contact need not give up
    // Which body the point of contact travels with: 0 is a, 1 is b, between them both.
    float anchor_blend[8];
};
inline constexpr int wide_rows = 50;  // of 32 bytes, a and b included
static_assert(sizeof(ContactConstraintWide) == wide_rows * 32);

// Read once per step, so kept away from the block.
struct alignas(64) ContactConstraintWideMeta {
    float moved[8];  // m of relative motion since the manifold was built
    float restitution[8];
    std::uint32_t contact[8];        // who owns the lane; 0xffffffff: nobody
    std::uint8_t needs_rebuild = 0;  // lanes to rebuild before the next solve, one bit each
    std::uint8_t touching = 0;       // lanes whose contact is touching
    std::uint8_t touching_now =
        0;  // what the last pass found; becomes `touching` when the islands are linked
    std::uint8_t anisotropic = 0;   // lanes with a body whose inertia is not isotropic
    std::uint8_t locked = 0;        // lanes with a body whose axes are locked
    std::uint8_t restitutions = 0;  // lanes with restitution > 0
    std::uint8_t reporting = 0;     // lanes of a shape with report_stays
    std::uint8_t rolls = 0;         // lanes whose RollingWide means something
};

// What few materials ask for: resistance to rolling and turning, moving surfaces. Not read where no
// lane is rough.
struct alignas(64) RollingWide {
    float surface[2][8];          // m/s along the tangents: of b's surface against a's
    float rolling[8];             // m: torque held per unit of normal force
    float torsional_friction[8];  // m, about the normal
    float roll[2][8];             // accumulated angular impulse about the tangents, N m s
};
inline constexpr int rolling_rows = 6;
static_assert(sizeof(RollingWide) == rolling_rows * 32);

// Scratch of bouncy blocks within one step.
struct alignas(64) RestitutionWide {
    float approach[4][8];  // m/s at the start of the step, negative: approaching
    float peak[4][8];      // largest impulse of any sub-step
};

// What the second body of a colour is: decides which kernel runs.
enum class PairKind : std::uint8_t {
    moving,  // read and written
    driven,  // kinematic: read only
    fixed,   // not even read
};

struct Colour {
    std::vector<ContactConstraintWide> blocks;
    std::vector<ContactConstraintWideMeta> metas;
    // As many as blocks; contents mean something for bouncy and for rough blocks only.
    std::vector<RestitutionWide> restitutions;
    std::vector<RollingWide> rollings;
    std::int32_t lanes = 0;
};

// 64 colours, as one bit mask per body, and three overflow lists whose blocks hold one lane each
// and are solved one after the other, for bodies with more contacts of a kind than there are
// colours.
inline constexpr int dynamic_colours = 48, kinematic_colours = 6, static_colours = 10;
inline constexpr int mask_colours = dynamic_colours + kinematic_colours + static_colours;
static_assert(mask_colours == 64);
// Each of the 64 has two lists of blocks: manifolds of several points, and, from single_colours on,
// those of one point, whose kernels do a quarter of the work.
inline constexpr int single_colours = mask_colours;
inline constexpr int overflow_colours = 2 * mask_colours;
inline constexpr int colour_count = overflow_colours + 3;

inline constexpr bool is_overflow(int colour) {
    return colour >= overflow_colours;
}
inline constexpr bool is_single(int colour) {
    return colour >= single_colours && colour < overflow_colours;
}
// The bit in the bodies' masks.
inline constexpr int mask_bit(int colour) {
    return colour % mask_colours;
}
inline constexpr PairKind pair_kind_of(int colour) {
    if (is_overflow(colour)) return static_cast<PairKind>(colour - overflow_colours);
    const int bit = mask_bit(colour);
    if (bit < dynamic_colours) return PairKind::dynamic;
    return bit < dynamic_colours + kinematic_colours ? PairKind::kinematic : PairKind::static_;
}
inline constexpr int lanes_per_block(int colour) {
    return is_overflow(colour) ? 1 : 8;
}

// Contacts with fixed bodies come last: what rests on the floor is pushed out of it in the end.
inline constexpr std::array<int, colour_count> make_solve_order() {
    std::array<int, colour_count> order{};
    int n = 0;
    for (const PairKind kind : {PairKind::dynamic, PairKind::kinematic, PairKind::static_}) {
        order[static_cast<unsigned>(n++)] = overflow_colours + static_cast<int>(kind);
        for (int c = 0; c < mask_colours; c++)
            if (pair_kind_of(c) == kind) {
                order[static_cast<unsigned>(n++)] = c;
                order[static_cast<unsigned>(n++)] = single_colours + c;
            }
    }
    return order;
}
inline constexpr std::array<int, colour_count> solve_order = make_solve_order();

// One manifold outside the solver: what a sleeping island keeps.
struct SavedManifold {
    std::uint32_t contact = 0xffffffff;
    std::array<float, wide_rows - 2> rows{};  // of ContactConstraintWide, without a and b
    std::array<float, rolling_rows> rolling_values{};
    float moved = 0, restitution = 0;
    bool needs_rebuild = false, rolls = false;
};

// Whether a manifold has one point, by the second one's gap.
inline bool is_single_point(float second_gap) {
    return second_gap > 0.5f * no_point;
}

struct ColourSet {
    std::array<Colour, colour_count> colours;
    std::int32_t lanes = 0;  // of all colours
};
using ConstraintGraph = std::array<ColourSet, colour_set_count>;

// Whether threads share its colours. Those of a smaller one are so short that handing them over
// again and again would cost more than they do.
inline bool is_shared(const ColourSet& set) {
    constexpr std::int32_t shared_manifolds = 2000;
    return set.constraints >= shared_manifolds;
}

// The stores that the solver works on.
inline auto solved_sets(ConstraintGraph& graph) {
    return std::span(graph.sets).first<solved_set_count>();
}

// Calls visit(colour) or visit(colour, its number) for every colour of every store in use.
template <class Sets, class Visit>
void for_each_colour(Sets&& sets, Visit&& visit) {
    for (auto& set : sets) {
        if (set.constraints == 0) continue;
        for (int c = 0; c < colour_count; c++) {
            auto& colour = set.colours[static_cast<std::size_t>(c)];
            if constexpr (std::is_invocable_v<Visit, decltype(colour), int>)
                visit(colour, c);
            else
                visit(colour);
        }
    }
}

}  // namespace jostle::physics
