// SPDX-License-Identifier: MIT
//
// A joint of a group as constraint rows, in double. With the velocities v, w of the two bodies, the
// error of a row changes at the rate
//     linear . (v_b - v_a) + angular_a . w_a + angular_b . w_b
// and its multiplier pushes along the same vectors. Row order: point rows, rows that keep
// directions perpendicular, then one row per free axis on which something acts.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "physics/src/constraints/direct/direct_gear.h"
#include "physics/src/constraints/direct/free_axis.h"

namespace jostle::physics {

// Bodies are referenced by their number in the group.
struct DirectJoint {
    static constexpr int max_rows = 8;
    // ball: the ends coincide, three rows along the world axes. rod: the ends keep a distance, one
    // row. across: b's end stays on a line, on a curve or in a plane of a, or is free. gear: a
    // single row, of a gear.
    enum class Points : std::uint8_t { ball, rod, across, gear };

    int a = 0, b = 0;
    Points kind = Points::across;
    int points = 0;  // number of point rows
    int turns = 0;   // number of directions of a that stay perpendicular to directions of b: 0..3
    int count = 0;   // number of all rows
    std::vector<FreeAxis> free_axes;
    int rows() const { return count; }
    int first_free_axis() const { return points + turns; }
    bool is_ball() const { return kind == Points::ball; }
    bool is_gear() const { return kind == Points::gear; }
    // Whether its point is all that it holds.
    bool is_ball_alone() const { return is_ball() && count == 3; }
    // Whether a row's error is in metres; otherwise it is in radians.
    bool is_linear(int row) const {
        return row < points ||
               (row >= first_free_axis() &&
                free_axes[static_cast<std::size_t>(row - first_free_axis())].is_linear());
    }

    // Constant, in the principal axes of the bodies.
    Vec3 arm_a, arm_b;             // of the ends, m
    double distance = 0;           // m, for a rod
    Vec3 across[2];                // unit, fixed in a
    Vec3 turn_a[3], turn_b[3];     // unit
    std::vector<DirectGear> gear;  // one for gears, racks and pulleys, otherwise none
    // A curve in frame_a that b's end stays on; null: none. `across` is perpendicular to it at the
    // state of write_vectors(), and follows it.
    const PathJoint* path = nullptr;
    double path_at = 0;                // parameter, counts laps
    double curvature = 0;              // 1/m, at that state
    std::vector<double> path_travels;  // m, of its pieces; empty if nothing acts along it
    bool gimbal = false;    // stores impulses of locked rotations by gimbal row (axes_layout.h)
    Quat frame_a, frame_b;  // frames of the gimbal or of the curve

    // At the current state of the two bodies.
    Vec3 apart;  // from a's end to b's end, m
    // Of a ball joint: from the centres to the point where both bodies receive the force, m.
    Vec3 lever_a, lever_b;
    // Not used by ball joints, whose rows are the world axes.
    Vec3 linear[max_rows];
    Vec3 angular_a[max_rows], angular_b[max_rows];
    // Inactive rows (a limit that is not reached, a motor at its maximum) have no vectors and no
    // multiplier.
    std::array<bool, max_rows> off{};
    // Rows along locked axes, where nothing can move. Their errors are not corrected.
    std::array<bool, max_rows> blocked{};

    double start[max_rows] = {};    // errors at the start of the step; without free axes
    double target[max_rows] = {};   // errors to be left over
    double error[max_rows] = {};    // errors at the end of the current attempt: m and rad
    double impulse[max_rows] = {};  // unknowns of the current step
    double force[max_rows] = {};    // half of the force on b, N and N m; carried from step to step
    Vec3 force_sum, torque_sum;     // impulses on b over the whole step, N s and N m s
};

// Write the vectors of the rows: at the bodies' state, or as means over the step, for which the
// error changes by exactly h J (v, w) if a Cayley map rotates the bodies.
// The functions of two bodies are for joints other than gears.
void write_vectors(DirectJoint& joint, const DirectBody& a, const DirectBody& b);
void write_vectors(DirectJoint& joint, std::span<const DirectBody> bodies);
void write_mean_vectors(DirectJoint& joint, std::span<const DirectBody> bodies);

// Errors at the current state, and at the end of the attempt, `h` later. An axis held at a speed
// advances by speed times h.
void measure_start(DirectJoint& joint, std::span<const DirectBody> bodies);
void measure(DirectJoint& joint, std::span<const DirectBody> bodies, double h);
// The value of a free axis at the end of the attempt.
double trial_value(const DirectJoint& joint, const FreeAxis& free_axis,
                   std::span<const DirectBody> bodies);
// The force on b from impulses along the rows.
inline Vec3 pull_of(const DirectJoint& joint, const double* value) {
    if (joint.is_ball()) return {value[0], value[1], value[2]};
    if (joint.is_gear()) return part_of(joint.gear[0], joint.b).linear * value[0];
    Vec3 sum;
    for (int k = 0; k < joint.rows(); k++) sum += joint.linear[k] * value[k];
    return sum;
}
// Returns whether the limit is overrun at the start of the step. bounded_excess(): the overrun
// beyond `most`; negative at the lower limit.
inline bool is_overrun(const FreeAxis& free_axis) {
    return free_axis.at_limit > 0 ? free_axis.start < free_axis.lower
                                  : free_axis.start > free_axis.upper;
}
double bounded_excess(const FreeAxis& free_axis, double most);
// Stiffness of a spring row in this step, 1/compliance: impulse per error at its end. The error is
// that of the mean stretch over the step, or of a later stretch if the spring is damped and too
// stiff for h to resolve.
double spring_pull(const FreeAxis& free_axis, double h);

// Speed of b's end along the curve of a path joint, m/s.
double speed_along_path(const DirectJoint& joint, std::span<const DirectBody> bodies);

// Whether the kind has rows in the direct solver.
bool supported(const JointKind& kind);
struct DirectEnd {
    Vec3 arm;    // from the centre to the frame's origin, principal axes
    Quat frame;  // orientation of the frame, principal axes
};
void set_up(DirectJoint& joint, const JointKind& kind, const DirectEnd& a, const DirectEnd& b);
// The rigid rows and the limits alone. Also for kinds that are not supported otherwise, if they
// hold a point.
void set_up_rigid(DirectJoint& joint, const JointKind& kind, const DirectEnd& a,
                  const DirectEnd& b);
// The carrier of an end: body -1 is the world.
struct DirectCarrier {
    int body = -1;
    Quat axes;    // of its principal axes in its frame
    Vec3 center;  // m, of its centre of mass in its frame
};
// For a gear, rack or pulley, after set_up().
void set_carriers(DirectJoint& joint, const DirectCarrier& of_a, const DirectCarrier& of_b);

// State of a joint that the world retains from step to step: impulses on b of a sub-step of h. For
// a distance joint only the component along it. Valid after write_vectors().
struct WarmStartCache {
    Vec3 point, angular;  // world
    Vec3 turns;           // for gimbal joints: first, middle, last
    struct FreeAxisImpulses {
        double lower = 0, upper = 0, spring = 0, motor = 0, friction = 0;
    };
    std::array<FreeAxisImpulses, 6> free_axes{};  // indexed by slot
};
void load_forces(DirectJoint& joint, const DirectBody& a, const DirectBody& b,
                 const WarmStartCache& cache, double h);
WarmStartCache save_forces(const DirectJoint& joint, const DirectBody& a, const DirectBody& b,
                           double h);

}  // namespace jostle::physics
