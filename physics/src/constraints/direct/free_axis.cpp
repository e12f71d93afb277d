// SPDX-License-Identifier: MIT
#include "physics/src/constraints/direct/free_axis.h"

#include <utility>

#include "jostle/base/check.h"
#include "physics/src/constraints/joints/angles.h"
#include "physics/src/constraints/joints/axes_layout.h"

namespace jostle::physics {
namespace {

using Kind = FreeAxis::Kind;

// The row of a purely rotational free axis.
Vec3 turn_row(const FreeAxis& free_axis, const FreeAxisEnds& ends) {
    if (free_axis.kind == Kind::hinge) return ends.axes_a * free_axis.axis_a;
    const Quat a = ends.a * free_axis.frame_a, b = ends.b * free_axis.frame_b;
    if (free_axis.kind == Kind::swing || free_axis.kind == Kind::twist) {
        const Vec3 x = rotate(a, {1, 0, 0}), to = rotate(b, {1, 0, 0});
        // At a swing of 180 degrees the twist is undefined.
        if (free_axis.kind == Kind::twist) return (x + to) * (1 / maximum(1 + dot(x, to), 0.05));
        const Vec3 away = cross(x, to);
        const double sine = length(away);
        return sine > 1e-12 ? away * (1 / sine) : rotate(a, {0, 1, 0});
    }
    const GimbalRows rows = gimbal_rows(a, b);
    return free_axis.kind == Kind::first
               ? rows.first
               : (free_axis.kind == Kind::middle ? rows.middle : rows.last);
}

Vec3 line_of(Vec3 apart) {
    const double size = length(apart);
    return size > 1e-12 ? apart * (1 / size) : Vec3{0, 1, 0};
}

void write_turn(FreeAxis& free_axis, Vec3 row) {
    free_axis.linear = {};
    free_axis.angular_a = -row;
    free_axis.angular_b = row;
}

// Both bodies receive the force at one point, or along the line through two points.
void write_line(FreeAxis& free_axis, Vec3 line, Vec3 lever_a, Vec3 lever_b) {
    free_axis.linear = line;
    free_axis.angular_a = cross(line, lever_a);
    free_axis.angular_b = cross(lever_b, line);
}

}  // namespace

double FreeAxis::push_between(int p) const {
    ASSERT(p >= 0 && p <= steps);
    double sum = 0;
    for (int k = 0; k < steps; k++) sum += k < p ? -most[k] : most[k];
    return sum;
}

namespace {

// The angle of a rotation is in -pi..pi.
double raw_value(const FreeAxis& free_axis, const FreeAxisEnds& ends) {
    switch (free_axis.kind) {
        case Kind::travel:
            return dot(ends.axes_a * free_axis.axis_a, ends.apart);
        case Kind::distance:
            return length(ends.apart);
        case Kind::path:
            return ends.travel;
        case Kind::hinge: {
            const Vec3 x = ends.axes_b * free_axis.x_b;
            return arc_tangent(dot(x, ends.axes_a * free_axis.y_a),
                               dot(x, ends.axes_a * free_axis.x_a));
        }
        case Kind::twist:
            return twist_angle(ends.a * free_axis.frame_a, ends.b * free_axis.frame_b);
        case Kind::swing:
            return swing_angle(ends.a * free_axis.frame_a, ends.b * free_axis.frame_b);
        default:
            break;
    }
    const GimbalAngles turns =
        gimbal_angles(ends.a * free_axis.frame_a, ends.b * free_axis.frame_b);
    return free_axis.kind == Kind::first
               ? turns.first
               : (free_axis.kind == Kind::middle ? turns.middle : turns.last);
}

}  // namespace

double value_of(const FreeAxis& free_axis, const FreeAxisEnds& ends) {
    const double value = raw_value(free_axis, ends);
    return free_axis.is_linear() ? value : nearest_angle(value, free_axis.reference);
}

void write_free_axis(FreeAxis& free_axis, const FreeAxisEnds& ends) {
    free_axis.value = value_of(free_axis, ends);
    if (free_axis.kind == Kind::travel)
        write_line(free_axis, ends.axes_a * free_axis.axis_a, ends.arm_a + ends.apart, ends.arm_b);
    else if (free_axis.kind == Kind::path)
        write_line(free_axis, ends.tangent, ends.arm_a + ends.apart, ends.arm_b);
    else if (free_axis.kind == Kind::distance)
        write_line(free_axis, line_of(ends.apart), ends.arm_a, ends.arm_b);
    else
        write_turn(free_axis, turn_row(free_axis, ends));
}

void write_mean_free_axis(FreeAxis& free_axis, const FreeAxisEnds& before,
                          const FreeAxisEnds& after) {
    const Vec3 arm_a = (before.arm_a + after.arm_a) * 0.5,
               arm_b = (before.arm_b + after.arm_b) * 0.5;
    if (free_axis.kind == Kind::travel) {
        const Vec3 axis =
            (before.axes_a * free_axis.axis_a + after.axes_a * free_axis.axis_a) * 0.5;
        write_line(free_axis, axis, arm_a + (before.apart + after.apart) * 0.5, arm_b);
    } else if (free_axis.kind == Kind::path) {
        // Along the chord, and as much longer as the curve is.
        const Vec3 chord = after.on_curve - before.on_curve;
        Vec3 row = (before.tangent + after.tangent) * 0.5;
        if (length_squared(chord) > 1e-18) {
            const Vec3 along = chord * ((after.travel - before.travel) / length_squared(chord));
            row = (rotate(before.a * free_axis.frame_a, along) +
                   rotate(after.a * free_axis.frame_a, along)) *
                  0.5;
        }
        write_line(free_axis, row, arm_a + (before.apart + after.apart) * 0.5, arm_b);
    } else if (free_axis.kind == Kind::distance) {
        // The difference of the lengths is exactly the mean displacement along the line.
        const double sum = length(before.apart) + length(after.apart);
        write_line(free_axis,
                   sum > 1e-12 ? (before.apart + after.apart) * (1 / sum) : line_of(before.apart),
                   arm_a, arm_b);
    } else {
        const Vec3 row = (turn_row(free_axis, before) + turn_row(free_axis, after)) * 0.5;
        write_turn(free_axis, free_axis.kind == Kind::hinge ? normalized(row) : row);
    }
}

double rate_of(const FreeAxis& free_axis, const DirectBody& a, const DirectBody& b) {
    const double turning = dot(free_axis.angular_a, spin(a)) + dot(free_axis.angular_b, spin(b));
    return free_axis.is_linear() ? turning + dot(free_axis.linear, velocity(b) - velocity(a))
                                 : turning;
}

double response_of(const FreeAxis& free_axis, const DirectBody& a, const DirectBody& b) {
    const auto of = [&](const DirectBody& body, Vec3 angular) {
        return body.pushed ? dot(free_axis.linear, scaled(free_axis.linear, body.inverse_masses)) +
                                 dot(angular, body.inverse_inertia * angular)
                           : 0;
    };
    return of(a, free_axis.angular_a) + of(b, free_axis.angular_b);
}

double stretch_of(const FreeAxis& free_axis, double value) {
    const double stretch = value - free_axis.rest;
    return free_axis.is_linear() || free_axis.has_range() ? stretch : wrapped(stretch);
}

// ---- actuation ----

void add_step(FreeAxis& free_axis, double speed, double most) {
    ASSERT(most >= 0 && free_axis.steps < 3);
    for (int k = 0; k < free_axis.steps; k++)
        if (free_axis.speeds[k] == speed) {
            free_axis.most[k] += most;
            return;
        }
    free_axis.speeds[free_axis.steps] = speed;
    free_axis.most[free_axis.steps] = most;
    if (free_axis.steps == 1 && free_axis.speeds[0] > speed) {
        std::swap(free_axis.speeds[0], free_axis.speeds[1]);
        std::swap(free_axis.most[0], free_axis.most[1]);
    }
    free_axis.steps++;
}

void nothing_along(FreeAxis& free_axis) {
    free_axis.lower = -FreeAxis::never;
    free_axis.upper = FreeAxis::never;
    free_axis.steps = free_axis.at_limit = 0;
    free_axis.reference = 0;
    free_axis.actuation = FreeAxis::at_rest;
    free_axis.rate = free_axis.friction_limit = 0;
}

void actuation_on_limit(FreeAxis& free_axis) {
    if (free_axis.steps == 0 || free_axis.at_limit == 0) return;
    const int into = -free_axis.at_limit;
    ASSERT(into == 1 || into == -1);
    // Number of steps that are slower than a creeping motion in that direction.
    const auto slower = [&](int direction) {
        int count = 0;
        for (int k = 0; k < free_axis.steps; k++)
            if (direction > 0 ? free_axis.speeds[k] <= 0 : free_axis.speeds[k] < 0) count++;
        return count;
    };
    if (free_axis.push_between(slower(into)) * into > 0) {
        free_axis.actuation = 2 * slower(into);
    } else if (free_axis.push_between(slower(-into)) * into < 0) {
        if (free_axis.is_held())
            free_axis.at_limit = 0;
        else
            free_axis.actuation = 2 * slower(-into);
    } else {
        free_axis.actuation = FreeAxis::at_rest;
    }
}

void load_actuation(FreeAxis& free_axis, double force) {
    free_axis.actuation = FreeAxis::at_rest;
    if (free_axis.steps == 0) return;
    const double fuzz = 1e-7 * free_axis.push_between(0);
    ASSERT(free_axis.steps <= 2);
    for (int p = 0; p <= free_axis.steps; p++) {
        const double push = free_axis.push_between(p);
        if (p == 0 ? force >= push - fuzz : absolute(force - push) <= fuzz) {
            free_axis.actuation = 2 * p;
            return;
        }
        if (p == free_axis.steps) {
            free_axis.actuation = 2 * p;
        } else if (force > free_axis.push_between(p + 1) + fuzz) {
            free_axis.actuation = 2 * p + 1;
            return;
        }
    }
}

}  // namespace jostle::physics
