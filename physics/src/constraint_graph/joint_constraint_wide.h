// SPDX-License-Identifier: MIT
//
// Solver data of joints within one step, in blocks of eight joints of a kind. Rebuilt in each step.
// Floats are relative to the start of the step (see constraint_graph/solver_body.h).
#pragma once

#include <cstdint>

namespace jostle::physics {

// Data common to all kinds. Lane k of a row is joint k. The bodies of a block are distinct. Empty
// lanes have no bodies and contain zeros.
struct alignas(32) JointConstraintWide {
    std::int32_t a[8], b[8];         // hot indices; 0: immovable
    float arm_a[3][8], arm_b[3][8];  // from the centres of mass to the frames' origins, m
    float apart[3][8];               // from a's frame origin to b's, m
    float point[3][8];               // impulse, N s, in axes that rotate with the carrying body
    float force[3][8];               // N s, accumulated over the step, world axes
};

// A spring as coefficients of one sub-step (constraints/softness.h).
struct SoftRow {
    float position_rate[8], velocity_scale[8], impulse_scale[8];
    float once[8];  // 1: skipped in the relaxing pass
};

// Additional data of hinges, cones, fixed joints and distance joints; each kind uses a part of it.
// Disabled rows have parameters that make their impulse zero: a distant limit, or a motor without
// force.
struct alignas(32) JointAngularWide {
    float frame_a[4][8], frame_b[4][8];   // x y z w, world
    float angular[3][8], friction[3][8];  // impulses, like `point`, N m s
    float torque[3][8];                   // N m s, accumulated over the step, world axes
    float drive[4][8];                    // x y z w, rotation from the target to b
    float drive_most[8];  // maximum of the drive or of a hinge's spring, N m s per sub-step
    float lower[8], upper[8], swing[8], spring[8], motor[8];  // impulses along the kind's own rows
    float lower_at[8], upper_at[8];                           // limits, rad or m
    float swing_at[8], spring_at[8];                          // rad; rad or m
    float margin[8];  // angle left to the nearest limit, rad, as the last pass found it
    float motor_speed[8], motor_most[8];  // rad/s, N m s per sub-step
    SoftRow spring_soft;                  // for a fixed joint: of its rotational rows
    SoftRow point_soft;                   // fixed joints only
};

// Additional data of velocity rows: VelocityRow (jostle/physics/joint_defs.h) in floats.
struct alignas(32) VelocityRowWide {
    float linear_a[3][8], angular_a[3][8];  // world, at the start of the step
    float linear_b[3][8], angular_b[3][8];
    float turns[8];  // 1: the vectors rotate with their bodies; 0: they are constant
    float speed[8], bias[8];
    float softness[8];         // velocity per impulse of a sub-step
    float lower[8], upper[8];  // bounds of the impulse of a sub-step
    float impulse[8];          // impulse of a sub-step
    float torque[3][8];        // N m s on b, accumulated over the step, world axes
};

// Additional data of one of the six axes of sliders, six-dofs and wheels
// (constraints/joints/axes_layout.h). Disabled rows have parameters that make their impulse zero,
// as in JointAngularWide.
struct alignas(32) JointAxisWide {
    float lower[8], upper[8], spring[8], motor[8], friction[8];  // impulses of a sub-step
    float lower_at[8], upper_at[8], spring_at[8];                // m or rad
    float motor_speed[8];                                        // m/s or rad/s
    float motor_most[8], friction_most[8], spring_most[8];       // maximum impulses of a sub-step
    SoftRow soft;
};
struct alignas(32) JointAxesWide {
    float frame_a[4][8];  // x y z w, world, at the start of the step
    float turn[4][8];     // rotation from frame_a to b's frame, in frame_a's axes
    float locked[6][8];   // 1 if locked
    float by_a[8];        // 1: the point impulses rotate with a, whichever body carries the others
    float turns[3][8];    // impulses along the rows of locked rotations, N m s
    float torque[3][8];   // N m s, accumulated over the step, world axes
    float curvature[8];   // of a path, towards the second axis, 1/m
    double at[8];         // position on the path at the start of the step
    JointAxisWide axes[6];
};

// Additional data of gears, racks and pulleys: one row couples the displacements of two ends, with
// up to four bodies. Slots 0 and 1 are a and b; the others are their carriers, unless a carrier is
// a or b.
struct alignas(32) JointGearWide {
    std::int32_t body[4][8];  // hot indices; 0: none, or immovable
    float arm[2][4][3]
             [8];         // of each end, from each slot's centre of mass, at the start of the step
    float sign[2][4][8];  // sign of the slot's motion in the end's motion: 1, -1 or 0
    float axis[2][3]
              [8];       // axis of the motion at the start of the step; for a rope, towards its end
    float travel[2][8];  // length of a rope to its end at the start of the step, m
    float scale[2][8];   // factor of each end's displacement in the row
    float turns[2][8];   // 1: its displacement is a rotation; 0: a length
    float rope[8];       // 1: its ends are ropes, which only pull
    float error[8];      // at the start of the step
    float impulse[8];    // impulse of a sub-step
    float moved[2][8];   // displacement of each end since the start of the step
    float torque[3][8];  // N m s on b, accumulated over the step, world axes
    double travels[2][8], sum[8];  // of GearMemory, at the start of the step
    double carriers[2][8];         // same as travels, for the carriers
};

// The rows of a kind that at least one joint of a block uses. For axes, shifted by four bits per
// axis.
enum JointUses : std::uint8_t {
    uses_limit = 1,
    uses_spring = 2,
    uses_motor = 4,
    uses_friction = 8,
    uses_drive = 16,
};
inline constexpr std::uint32_t uses_batch = 1u << 30;  // all its points are solved in batches
inline constexpr std::uint32_t uses_curve = 1u << 31;  // axes: the first one is a path

// The joints and bodies of a block.
struct JointConstraintWideMeta {
    std::uint32_t joint[8] = {};
    // Hot indices of the two bodies. Negative for bodies that move but cannot be pushed; 0 for
    // immovable ones.
    std::int32_t a[8] = {}, b[8] = {};
    int angular = -1;        // its JointAngularWide; -1 if the kind has none
    int row = -1;            // its VelocityRowWide; -1 if the kind has none
    int axes = -1;           // its JointAxesWide; -1 if the kind has none
    int gear = -1;           // its JointGearWide; -1 if the kind has none
    std::uint32_t uses = 0;  // JointUses
    std::uint8_t count = 0;
    std::uint8_t in_batch = 0;      // number of its joints in batches (joint_batches.h)
    std::uint8_t broken_lanes = 0;  // bit mask of lanes, at the end of the step
};

}  // namespace jostle::physics
