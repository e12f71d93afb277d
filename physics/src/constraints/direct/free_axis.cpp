// SPDX-License-Identifier: MIT
#include "physics/src/constraints/direct/free_axis.h"

#include <utility>

#include "physics/src/constraints/joints/angles.h"
#include "physics/src/constraints/joints/axes_layout.h"

namespace jostle::physics {
namespace {

using Kind = FreeAxis::Kind;

// Of what only turns.
Vec3 turn_row(const FreeAxis& way, const FreeAxisEnds& ends) {
    if (way.kind == Kind::hinge) return ends.axes_a * way.axis_a;
    const Quat a = ends.a * way.frame_a, b = ends.b * way.frame_b;
    if (way.kind == Kind::swing || way.kind == Kind::twist) {
        const Vec3 x = rotate(a, {1, 0, 0}), to = rotate(b, {1, 0, 0});
        // At a swing of a half turn there is no twist to speak of.
        if (way.kind == Kind::twist) return (x + to) * (1 / maximum(1 + dot(x, to), 0.05));
        const Vec3 away = cross(x, to);
        const double sine = length(away);
        return sine > 1e-12 ? away * (1 / sine) : rotate(a, {0, 1, 0});
    }
    const GimbalRows rows = gimbal_rows(a, b);
    return way.kind == Kind::first ? rows.first
                                   : (way.kind == Kind::middle ? rows.middle : rows.last);
}

Vec3 line_of(Vec3 apart) {
    const double size = length(apart);
    return size > 1e-12 ? apart * (1 / size) : Vec3{0, 1, 0};
}

void write_turn(FreeAxis& way, Vec3 row) {
    way.linear = {};
    way.angular_a = -row;
    way.angular_b = row;
}

// Both bodies feel the force in one point, or along the line of two.
void write_line(FreeAxis& way, Vec3 line, Vec3 lever_a, Vec3 lever_b) {
    way.linear = line;
    way.angular_a = cross(line, lever_a);
    way.angular_b = cross(lever_b, line);
}

}  // namespace

double FreeAxis::push_between(int p) const {
    double sum = 0;
    for (int k = 0; k < steps; k++) sum += k < p ? -most[k] : most[k];
    return sum;
}

double value_of(const FreeAxis& way, const FreeAxisEnds& ends) {
    switch (way.kind) {
        case Kind::travel:
            return dot(ends.axes_a * way.axis_a, ends.apart);
        case Kind::distance:
            return length(ends.apart);
        case Kind::hinge: {
            const Vec3 x = ends.axes_b * way.x_b;
            return arc_tangent(dot(x, ends.axes_a * way.y_a), dot(x, ends.axes_a * way.x_a));
        }
        case Kind::twist:
            return twist_angle(ends.a * way.frame_a, ends.b * way.frame_b);
        case Kind::swing:
            return swing_angle(ends.a * way.frame_a, ends.b * way.frame_b);
        default:
            break;
    }
    const GimbalAngles turns = gimbal_angles(ends.a * way.frame_a, ends.b * way.frame_b);
    return way.kind == Kind::first ? turns.first
                                   : (way.kind == Kind::middle ? turns.middle : turns.last);
}

void write_way(FreeAxis& way, const FreeAxisEnds& ends) {
    way.value = value_of(way, ends);
    if (way.kind == Kind::travel)
        write_line(way, ends.axes_a * way.axis_a, ends.arm_a + ends.apart, ends.arm_b);
    else if (way.kind == Kind::distance)
        write_line(way, line_of(ends.apart), ends.arm_a, ends.arm_b);
    else
        write_turn(way, turn_row(way, ends));
}

void write_mean_way(FreeAxis& way, const FreeAxisEnds& before, const FreeAxisEnds& after) {
    const Vec3 arm_a = (before.arm_a + after.arm_a) * 0.5,
               arm_b = (before.arm_b + after.arm_b) * 0.5;
    if (way.kind == Kind::travel) {
        const Vec3 axis = (before.axes_a * way.axis_a + after.axes_a * way.axis_a) * 0.5;
        write_line(way, axis, arm_a + (before.apart + after.apart) * 0.5, arm_b);
    } else if (way.kind == Kind::distance) {
        // The lengths' difference is the mean way along it, exactly.
        const double sum = length(before.apart) + length(after.apart);
        write_line(way,
                   sum > 1e-12 ? (before.apart + after.apart) * (1 / sum) : line_of(before.apart),
                   arm_a, arm_b);
    } else {
        const Vec3 row = (turn_row(way, before) + turn_row(way, after)) * 0.5;
        write_turn(way, way.kind == Kind::hinge ? normalized(row) : row);
    }
}

double rate_of(const FreeAxis& way, const DirectBody& a, const DirectBody& b) {
    const double turning = dot(way.angular_a, spin(a)) + dot(way.angular_b, spin(b));
    return way.is_linear() ? turning + dot(way.linear, velocity(b) - velocity(a)) : turning;
}

double response_of(const FreeAxis& way, const DirectBody& a, const DirectBody& b) {
    const auto of = [&](const DirectBody& body, Vec3 angular) {
        return body.pushed ? dot(way.linear, scaled(way.linear, body.inverse_masses)) +
                                 dot(angular, body.inverse_inertia * angular)
                           : 0;
    };
    return of(a, way.angular_a) + of(b, way.angular_b);
}

double stretch_of(const FreeAxis& way, double value) {
    const double stretch = value - way.rest;
    return way.is_linear() ? stretch : wrapped(stretch);
}

// ---- grip ----

void add_step(FreeAxis& way, double speed, double most) {
    for (int k = 0; k < way.steps; k++)
        if (way.speeds[k] == speed) {
            way.most[k] += most;
            return;
        }
    way.speeds[way.steps] = speed;
    way.most[way.steps] = most;
    if (way.steps == 1 && way.speeds[0] > speed) {
        std::swap(way.speeds[0], way.speeds[1]);
        std::swap(way.most[0], way.most[1]);
    }
    way.steps++;
}

void nothing_along(FreeAxis& way) {
    way.lower = -DirectWay::never;
    way.upper = FreeAxis::never;
    way.steps = way.at_limit = 0;
    way.grip = FreeAxis::at_rest;
    way.rate = way.rubs = 0;
}

void grip_on_limit(FreeAxis& way) {
    if (way.steps == 0 || way.at_limit == 0) return;
    const int into = -way.at_limit;
    // Steps that are slower than what creeps that way.
    const auto slower = [&](int direction) {
        int count = 0;
        for (int k = 0; k < way.steps; k++)
            if (direction > 0 ? way.speeds[k] <= 0 : way.speeds[k] < 0) count++;
        return count;
    };
    if (way.push_between(slower(into)) * into > 0) {
        way.grip = 2 * slower(into);
    } else if (way.push_between(slower(-into)) * into < 0) {
        if (way.is_held()) way.at_limit = 0;
    } else {
        way.grip = FreeAxis::at_rest;
    }
}

void load_grip(FreeAxis& way, double force) {
    way.grip = FreeAxis::at_rest;
    if (way.steps == 0) return;
    const double fuzz = 1e-7 * way.push_between(0);
    for (int p = 0; p <= way.steps; p++) {
        const double push = way.push_between(p);
        if (p == 0 ? force >= push - fuzz : absolute(force - push) <= fuzz) {
            way.grip = 2 * p;
            return;
        }
        if (p == way.steps) {
            way.grip = 2 * p;
        } else if (force > way.push_between(p + 1) + fuzz) {
            way.grip = 2 * p + 1;
            return;
        }
    }
}

}  // namespace jostle::physics
