// SPDX-License-Identifier: MIT
//
// A degree of freedom that a joint leaves free, as one scalar, with everything that acts along it:
// limits, a motor, friction and a spring. The scalar is an angle, a travel along a line or a
// distance, in double.
//
// Limits, motors and friction form an active set. The free axis has one row, which holds it at a
// limit, holds it at a speed, or is inactive. Actuation (a motor and friction) is a force that
// falls in steps as the speed rises. Each step is at the target speed of a motor or of friction,
// and its height is twice the maximum force. At the speed of a step the row determines the force.
// Between steps the force is known and the row is inactive.
#pragma once

#include <cstdint>

#include "jostle/physics/joint_defs.h"
#include "physics/src/constraints/direct/direct_body.h"
#include "physics/src/constraints/joints/angles.h"

namespace jostle::physics {

struct FreeAxis {
    // path: along a curve. rope: of a pulley; its row is that of a gear.
    enum class Kind : std::uint8_t {
        hinge,
        first,
        middle,
        last,
        travel,
        distance,
        path,
        rope,
        twist,
        swing
    };
    static constexpr double never = 1e300;
    static constexpr double min_response =
        1e-30;  // 1/kg or 1/(kg m^2): a lower response counts as immovable

    Kind kind = Kind::hinge;
    int slot = 0;                          // index into the joint's stored impulses
    double lower = -never, upper = never;  // rad or m
    // The steps of the actuation, in ascending order of speed.
    int steps = 0;
    double speeds[2] = {}, most[2] = {};  // rad/s or m/s; N m or N
    double friction_limit = 0;            // friction part of the maximum, N m or N
    double rate = 0, damping_ratio = 0;   // of the spring, rad/s
    double rest = 0;
    // Constant: in the principal axes of the bodies.
    Quat frame_a, frame_b;
    Vec3 axis_a, x_a, y_a, x_b;  // of a hinge; for a travel, axis_a is its axis

    // A rotation with limits is read within half a turn of this angle: the middle of their range,
    // later its own value at the start of the step (angles.h).
    double reference = 0;  // rad

    // At the current state of the two bodies. The vectors of the row if it is active.
    double value = 0;  // rad or m
    Vec3 linear, angular_a, angular_b;
    double start = 0;      // at the start of the step
    double stiffness = 0;  // of the spring at the start of the step, N m / rad or N/m
    double damper = 0;     // impulse per speed in half a step
    double applied = 0;    // impulse of the energy-momentum step outside the row
    bool overrun = false;  // limit overrun at the start of the step: the row's push leaves no speed
    int at_limit = 0;      // 1: at the lower limit, -1: at the upper limit, 0: between
    // 2 p: between steps, with p steps at lower speed; 2 p + 1: at the speed of step p; at_rest: a
    // limit carries the whole force.
    static constexpr int at_rest = -1;
    int actuation = at_rest;
    bool implicit = false;  // the spring is a row of the current step
    bool bound = false;     // the row holds: at a limit or at a speed

    bool is_linear() const {
        return kind == Kind::travel || kind == Kind::distance || kind == Kind::path ||
               kind == Kind::rope;
    }
    bool has_limit() const { return lower > -never || upper < never; }
    bool has_range() const { return lower > -never && upper < never; }
    bool is_ambiguous() const { return !is_linear() && physics::is_ambiguous(lower, upper); }
    bool is_held() const { return actuation >= 0 && actuation % 2 == 1; }
    // The force between steps, with p steps at lower speed.
    double push_between(int p) const;
    double push() const {
        return actuation >= 0 && actuation % 2 == 0 ? push_between(actuation / 2) : 0;
    }
    double hold_speed() const { return speeds[actuation / 2]; }
    bool is_damped() const { return rate > 0 && damping_ratio > 0; }
};

// The ends of the joint, world.
struct FreeAxisEnds {
    Vec3 arm_a, arm_b, apart;  // m
    Quat a, b;                 // of the principal axes
    Mat3 axes_a, axes_b;
    // Of a curve: travel of b's end, tangent in the world, and b's end in the frame of the curve.
    double travel = 0;
    Vec3 tangent, on_curve;
};

// Writes the value and the vectors at the given ends.
void write_free_axis(FreeAxis& free_axis, const FreeAxisEnds& ends);
double value_of(const FreeAxis& free_axis, const FreeAxisEnds& ends);
// Writes the vectors for which the value changes by h J (v, w) from `before` to `after`. Leaves the
// value unchanged.
void write_mean_free_axis(FreeAxis& free_axis, const FreeAxisEnds& before,
                          const FreeAxisEnds& after);
// Rate of change of the value.
double rate_of(const FreeAxis& free_axis, const DirectBody& a, const DirectBody& b);
// Speed per unit impulse, 1/kg or 1/(kg m^2).
double response_of(const FreeAxis& free_axis, const DirectBody& a, const DirectBody& b);
// Displacement from the rest position of the spring. Between limits a spring never pulls through
// them. Otherwise it pulls the shorter way.
double stretch_of(const FreeAxis& free_axis, double value);

void add_step(FreeAxis& free_axis, double speed, double most);
// Actuation at a limit: a motor that drives into the limit presses against it, a motor that drives
// away leaves it, and otherwise the limit carries the whole force.
void actuation_on_limit(FreeAxis& free_axis);
// Restores the actuation state from its force on b.
void load_actuation(FreeAxis& free_axis, double force);

// Disables everything along a free axis.
void nothing_along(FreeAxis& free_axis);

// Wraps an angle to -pi..pi.
inline double wrapped(double angle) {
    return angle > pi ? angle - 2 * pi : (angle < -pi ? angle + 2 * pi : angle);
}

}  // namespace jostle::physics
