// SPDX-License-Identifier: MIT
//
// A way that a joint leaves free, as one number, with what acts along it: limits, a motor, friction
// and a spring. An angle, a travel along a line or a distance; in double.
//
// Limits, motors and friction are an active set: the way has one row, which holds it on a limit, or
// at a speed, or not at all. What grips it (a motor and friction) pushes with a force that falls by
// steps as the way gets faster: each step is at the speed that a motor or friction wants, and twice
// as high as that may push. At the speed of a step the row finds the force; between steps it is
// known, and the row is off.
#pragma once

#include <cstdint>

#include "jostle/physics/joint_defs.h"
#include "physics/src/constraints/direct/direct_body.h"

namespace jostle::physics {

struct FreeAxis {
    enum class Kind : std::uint8_t { hinge, first, middle, last, travel, distance, twist, swing };
    static constexpr double never = 1e300;
    static constexpr double min_response = 1e-30;  // 1/kg or 1/(kg m^2): below it, none

    Kind kind = Kind::hinge;
    int slot = 0;                          // of the joint's impulses that are kept
    double lower = -never, upper = never;  // rad or m
    // The steps of what grips it, by speed.
    int steps = 0;
    double speeds[2] = {}, most[2] = {};  // rad/s or m/s; N m or N
    double friction_limit = 0;            // what of that is friction, N m or N
    double rate = 0, damping_ratio = 0;   // of the spring, rad/s
    double rest = 0;
    // Constant: in the principal axes of the bodies.
    Quat frame_a, frame_b;
    Vec3 axis_a, x_a, y_a, x_b;  // of a hinge; of a travel its axis

    // Where the two bodies are. The row's vectors are these when it is on.
    double value = 0;  // rad or m
    Vec3 linear, angular_a, angular_b;
    double start = 0;      // as the step began
    double stiffness = 0;  // of the spring as the step began, N m / rad or N/m
    double damper = 0;     // impulse per speed of half a step
    double applied = 0;    // impulse of the energy-momentum step that is no row's
    bool overrun = false;  // the limit, as the step began: the row's push leaves no speed
    int at_limit = 0;      // 1: on the lower one, -1: on the upper one, 0: between
    // 2 p: between steps, p of them at less speed; 2 p + 1: at the speed of step p; or at_rest: a
    // limit bears it all.
    static constexpr int at_rest = -1;
    int actuation = at_rest;
    bool implicit = false;  // the spring is a row of the step under way
    bool bound = false;     // the row holds: on a limit or at a speed

    bool is_linear() const { return kind == Kind::travel || kind == Kind::distance; }
    bool has_limit() const { return lower > -never || upper < never; }
    bool is_held() const { return actuation >= 0 && actuation % 2 == 1; }
    // The force between steps, of which p are at less speed.
    double push_between(int p) const;
    double push() const {
        return actuation >= 0 && actuation % 2 == 0 ? push_between(actuation / 2) : 0;
    }
    double hold_speed() const { return speeds[actuation / 2]; }
    bool is_damped() const { return rate > 0 && damping_ratio > 0; }
};

// The ends of its joint: world.
struct FreeAxisEnds {
    Vec3 arm_a, arm_b, apart;  // m
    Quat a, b;                 // of the principal axes
    Mat3 axes_a, axes_b;
};

// Value and vectors there.
void write_free_axis(FreeAxis& free_axis, const FreeAxisEnds& ends);
double value_of(const FreeAxis& free_axis, const FreeAxisEnds& ends);
// Vectors with which the value changes by h J (v, w) from one place to the other; the value stays
// what it is.
void write_mean_free_axis(FreeAxis& free_axis, const FreeAxisEnds& before,
                          const FreeAxisEnds& after);
// Rate of the value.
double rate_of(const FreeAxis& free_axis, const DirectBody& a, const DirectBody& b);
// By how much a unit impulse speeds it up, 1/kg or 1/(kg m^2).
double response_of(const FreeAxis& free_axis, const DirectBody& a, const DirectBody& b);
// From where the spring is at rest.
double stretch_of(const FreeAxis& free_axis, double value);

void add_step(FreeAxis& free_axis, double speed, double most);
// Grip on a limit: a motor that drives into it presses on it, one that drives away leaves it, and
// else it bears all.
void actuation_on_limit(FreeAxis& free_axis);
// Of what gripped the way before: its force on b.
void load_actuation(FreeAxis& free_axis, double force);

// A way along which nothing acts.
void nothing_along(FreeAxis& free_axis);

// Within a turn.
inline double wrapped(double angle) {
    return angle > pi ? angle - 2 * pi : (angle < -pi ? angle + 2 * pi : angle);
}

}  // namespace jostle::physics
