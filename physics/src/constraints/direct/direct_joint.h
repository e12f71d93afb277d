// SPDX-License-Identifier: MIT
//
// A joint of a group as rows: what it keeps zero, in double. With v, w the velocities of the two
// bodies, a row's error changes at the rate
//     linear . (v_b - v_a) + angular_a . w_a + angular_b . w_b
// and its multiplier pushes along the same vectors. Rows come in this order: those of the points,
// those that keep directions perpendicular, one for each way that is free and has something along
// it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "physics/src/constraints/direct/free_axis.h"

namespace jostle::physics {

// Bodies by number in the group.
struct DirectJoint {
    static constexpr int max_rows = 8;
    // ball: the ends stay together, three rows along the world's axes; rod: at a distance, one row;
    // across: b's end stays on a line or in a plane of a's, or is free.
    enum class Points : std::uint8_t { ball, rod, across };

    int a = 0, b = 0;
    Points kind = Points::across;
    int points = 0;  // rows of the points
    int turns = 0;   // directions of a that stay perpendicular to directions of b: 0..3
    int count = 0;   // of all rows
    std::vector<FreeAxis> free_axes;
    int rows() const { return count; }
    int first_free_axis() const { return points + turns; }
    bool is_ball() const { return kind == Points::ball; }
    // Whether a row's error is in m; else in rad.
    bool is_linear(int row) const {
        return row < points ||
               (row >= first_free_axis() &&
                free_axes[static_cast<std::size_t>(row - first_free_axis())].is_linear());
    }

    // Constant: in the principal axes of the bodies.
    Vec3 arm_a, arm_b;          // of the ends, m
    double distance = 0;        // m, of a rod
    Vec3 across[2];             // unit, of a
    Vec3 turn_a[3], turn_b[3];  // unit
    bool gimbal = false;        // keeps impulses of locked turns by gimbal row (axes_layout.h)
    Quat frame_a, frame_b;      // of that

    // Where the two bodies are.
    Vec3 apart;  // of the ends, b's from a's, m
    // Not of balls: theirs are the axes of the world.
    Vec3 linear[max_rows];
    Vec3 angular_a[max_rows], angular_b[max_rows];
    // Rows that are switched off just now (a limit that is not reached, a motor at its most) have
    // no vectors and no multiplier.
    std::array<bool, max_rows> off{};
    // ... and rows along which locked axes let nothing move: what is wrong there stays wrong.
    std::array<bool, max_rows> blocked{};

    double start[max_rows] = {};    // errors as the step began; not of ways
    double target[max_rows] = {};   // what is to be left of them
    double error[max_rows] = {};    // of where the step tries to go: m and rad
    double impulse[max_rows] = {};  // unknowns of the step under way
    double force[max_rows] = {};    // half of what acts on b, N and N m: from step to step
    Vec3 force_sum, torque_sum;     // impulses on b over the whole step, N s and N m s
};

// The rows' vectors: at the bodies' state, or means over the step, with which the error changes by
// exactly h J (v, w) where a Cayley map turns the bodies.
void write_vectors(DirectJoint& joint, const DirectBody& a, const DirectBody& b);
void write_mean_vectors(DirectJoint& joint, const DirectBody& a, const DirectBody& b);

// Errors of the state, and of where the step tries to go (`h` later: what is held at a speed goes
// on by speed h).
void measure_start(DirectJoint& joint, const DirectBody& a, const DirectBody& b);
void measure(DirectJoint& joint, const DirectBody& a, const DirectBody& b, double h);
// Of a way there.
double trial_value(const DirectJoint& joint, const FreeAxis& free_axis, const DirectBody& a,
                   const DirectBody& b);
// The force on b of impulses along the rows.
inline Vec3 pull_of(const DirectJoint& joint, const double* value) {
    if (joint.is_ball()) return {value[0], value[1], value[2]};
    Vec3 sum;
    for (int k = 0; k < joint.rows(); k++) sum += joint.linear[k] * value[k];
    return sum;
}
// By how much a limit is overrun beyond `most` as the step begins; negative at the lower one.
inline bool is_overrun(const FreeAxis& free_axis) {
    return free_axis.at_limit > 0 ? free_axis.start < free_axis.lower
                                  : free_axis.start > free_axis.upper;
}
double bounded_excess(const FreeAxis& free_axis, double most);
// What a row of a spring takes in this step: impulse per error at its end (that of the step's mean
// stretch, or of a later one where the spring is damped and too stiff for h to resolve),
// 1/compliance.
double spring_pull(const FreeAxis& free_axis, double h);

// Which kinds have rows here.
bool supported(const JointKind& kind);
struct DirectEnd {
    Vec3 arm;    // of the frame's origin from the centre, principal axes
    Quat frame;  // of the frame, principal axes
};
void set_up(DirectJoint& joint, const JointKind& kind, const DirectEnd& a, const DirectEnd& b);

// What a world keeps of a joint from step to step: impulses of a sub-step of h on b. Of a distance
// only what acts along it. After write_vectors().
struct WarmStartCache {
    Vec3 point, angular;  // world
    Vec3 turns;           // of what keeps them by gimbal row: first, middle, last
    struct FreeAxisImpulses {
        double lower = 0, upper = 0, spring = 0, motor = 0, friction = 0;
    };
    std::array<FreeAxisImpulses, 6> free_axes{};  // by slot
};
void load_forces(DirectJoint& joint, const DirectBody& a, const DirectBody& b,
                 const WarmStartCache& cache, double h);
WarmStartCache save_forces(const DirectJoint& joint, const DirectBody& a, const DirectBody& b,
                           double h);

}  // namespace jostle::physics
