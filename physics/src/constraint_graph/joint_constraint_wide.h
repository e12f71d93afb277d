// SPDX-License-Identifier: MIT
//
// What the solver knows of joints within one step, eight of a kind at a time; made anew each step.
// Floats, relative to the start of the step, as constraint_graph/solver_body.h says.
#pragma once

#include <cstdint>

namespace jostle::physics {

// What every kind has. Lane k of a row is joint k; bodies of a block are distinct. Empty lanes have
// no bodies and zeroes.
struct alignas(32) JointConstraintWide {
    std::int32_t a[8], b[8];         // hot indices; 0: does not move
    float arm_a[3][8], arm_b[3][8];  // of the frames' origins from the centres, m
    float apart[3][8];               // of b's origin from a's, m
    float point[3][8];               // impulse, N s, in axes that turn with the carrying body
    float force[3][8];               // N s over the step so far, world axes
};

// A spring as numbers of one sub-step (constraints/softness.h).
struct SoftRow {
    float position_rate[8], velocity_scale[8], impulse_scale[8];
    float once[8];  // 1: not in the relaxing pass
};

// What hinges, cones, fixed joints and distances have as well; each uses a part of it. What is
// switched off has numbers that make its impulse zero: a limit far away, a motor that may do
// nothing.
struct alignas(32) JointAngularWide {
    float frame_a[4][8], frame_b[4][8];   // x y z w, in the world
    float angular[3][8], friction[3][8];  // impulses as `point`, N m s
    float torque[3][8];                   // N m s over the step so far, world axes
    float drive[4][8];                    // x y z w, from the target to b
    float drive_most[8];                  // of it or a hinge's spring, N m s in a sub-step
    float lower[8], upper[8], swing[8], spring[8], motor[8];  // impulses along the kind's own rows
    float lower_at[8], upper_at[8];                           // limits, rad or m
    float swing_at[8], spring_at[8];                          // rad; rad or m
    float motor_speed[8], motor_most[8];                      // rad/s, N m s in a sub-step
    SoftRow spring_soft;                                      // of a fixed joint: of its turns
    SoftRow point_soft;                                       // of a fixed joint
};

// What velocity rows have instead: VelocityRow (jostle/physics/joint_defs.h) in floats.
struct alignas(32) VelocityRowWide {
    float linear_a[3][8], angular_a[3][8];  // in the world, as the step starts
    float linear_b[3][8], angular_b[3][8];
    float turns[8];  // 1: those turn with their bodies; 0: they do not
    float speed[8], bias[8];
    float softness[8];         // rate per impulse of a sub-step
    float lower[8], upper[8];  // of the impulse of a sub-step
    float impulse[8];          // of a sub-step
    float torque[3][8];        // N m s on b over the step so far, world axes
};

// What sliders, six-dofs and wheels have instead (constraints/joints/axes_layout.h): one of six
// axes. What is switched off has numbers that make its impulse zero, as in JointAngularWide.
struct alignas(32) JointAxisWide {
    float lower[8], upper[8], spring[8], motor[8], friction[8];  // impulses of a sub-step
    float lower_at[8], upper_at[8], spring_at[8];                // m or rad
    float motor_speed[8];                                        // m/s or rad/s
    float motor_most[8], friction_most[8], spring_most[8];       // impulses of a sub-step
    SoftRow soft;
};
struct alignas(32) JointAxesWide {
    float frame_a[4][8];  // x y z w, in the world, as the step starts
    float turn[4][8];     // from that to b's, in its own axes
    float locked[6][8];   // 1: locked
    float by_a[8];        // 1: the impulses at the point turn with a, whatever carries others
    float turns[3][8];    // impulses along the rows of locked turns, N m s
    float torque[3][8];   // N m s over the step so far, world axes
    float curvature[8];   // of a path, towards the second axis, 1/m
    double at[8];         // on the path, as the step starts
    JointAxisWide axes[6];
};

// What gears, racks and pulleys have instead: one row that couples the ways of two ends, of up to
// four bodies. Slots 0 and 1 are a and b, the others their carriers, where those are neither.
struct alignas(32) JointGearWide {
    std::int32_t body[4][8];       // hot indices; 0: none, or does not move
    float arm[2][4][3][8];         // of each end, from each slot's centre as the step starts
    float sign[2][4][8];           // what of an end's motion the slot's is: 1, -1 or 0
    float axis[2][3][8];           // along or about which, as the step starts; a rope: to its end
    float travel[2][8];            // a rope's length to its end, as the step starts, m
    float scale[2][8];             // of each end's way in the row
    float turns[2][8];             // 1: its way is a turn; else a length
    float rope[8];                 // 1: its ends are ropes, which pull only
    float error[8];                // as the step starts
    float impulse[8];              // of a sub-step
    float moved[2][8];             // way of each end since the step began
    float torque[3][8];            // N m s on b over the step so far, world axes
    double travels[2][8], sum[8];  // of GearMemory, as the step starts
    double carriers[2][8];         // likewise
};

// Which of a kind's rows some joint of a block has. Of axes: four bits each, so shifted.
enum JointUses : std::uint8_t {
    uses_limit = 1,
    uses_spring = 2,
    uses_motor = 4,
    uses_friction = 8,
    uses_drive = 16,
};
inline constexpr std::uint32_t uses_batch = 1u << 30;  // all its points are solved at once
inline constexpr std::uint32_t uses_curve = 1u << 31;  // of axes: the first is a path

// Who is in a block.
struct JointConstraintWideMeta {
    std::uint32_t joint[8] = {};
    // Hot indices of the two bodies, negative for what moves but cannot be pushed; 0: does not
    // move.
    std::int32_t a[8] = {}, b[8] = {};
    int angular = -1;        // its JointAngularWide, if the kind has one
    int row = -1;            // its VelocityRowWide, if the kind has one
    int axes = -1;           // its JointAxesWide, if the kind has one
    int gear = -1;           // its JointGearWide, if the kind has one
    std::uint32_t uses = 0;  // JointUses
    std::uint8_t count = 0;
    std::uint8_t in_batch = 0;      // how many of them are in batches (joint_batches.h)
    std::uint8_t broken_lanes = 0;  // by lane, at the end of the step
};

}  // namespace jostle::physics
