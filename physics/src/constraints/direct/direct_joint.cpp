// SPDX-License-Identifier: MIT
#include "physics/src/constraints/direct/direct_joint.h"

#include "jostle/base/check.h"
#include "physics/src/constraints/joints/path_curve.h"

namespace jostle::physics {
namespace {

// Both bodies receive the force at one point, midway across the remaining gap between the ends. The
// angular momentum of the pair is then conserved exactly, regardless of the gap.
void write_ball(DirectJoint& j, Vec3 arm_a, Vec3 arm_b, Vec3 apart) {
    const Vec3 a = j.lever_a = arm_a + apart * 0.5, b = j.lever_b = arm_b - apart * 0.5;
    j.angular_a[0] = {0, -a.z, a.y};
    j.angular_a[1] = {a.z, 0, -a.x};
    j.angular_a[2] = {-a.y, a.x, 0};
    j.angular_b[0] = {0, b.z, -b.y};
    j.angular_b[1] = {-b.z, 0, b.x};
    j.angular_b[2] = {b.y, -b.x, 0};
}

void write_line(DirectJoint& j, int row, Vec3 line, Vec3 lever_a, Vec3 lever_b) {
    ASSERT(row >= 0 && row < j.points);
    j.linear[row] = line;
    j.angular_a[row] = cross(line, lever_a);
    j.angular_b[row] = cross(lever_b, line);
}

void write_turn(DirectJoint& j, int k, Vec3 of_a, Vec3 of_b) {
    j.angular_a[j.points + k] = cross(of_a, of_b);
    ASSERT(k >= 0 && k < j.turns);
    j.angular_b[j.points + k] = -j.angular_a[j.points + k];
}

// Copies the rows of the free axes; inactive rows are zero.
void copy_free_axes(DirectJoint& j) {
    int row = j.first_free_axis();
    for (const FreeAxis& free_axis : j.free_axes) {
        const bool off = j.off[static_cast<std::size_t>(row)];
        j.linear[row] = off ? Vec3{} : free_axis.linear;
        j.angular_a[row] = off ? Vec3{} : free_axis.angular_a;
        j.angular_b[row] = off ? Vec3{} : free_axis.angular_b;
        row++;
    }
}

// b's end near the curve, in the frame of the curve.
struct OnCurve {
    Vec3 at;
    double parameter;
    CurvePoint nearest;
};
OnCurve on_curve(const DirectJoint& j, Quat a, Vec3 apart) {
    const Vec3 at = inverse_rotate(a * j.frame_a, apart);
    const double parameter = follow_path(*j.path, at, j.path_at);
    return {at, parameter, curve_point_at(*j.path, parameter)};
}

// The two directions across the tangent, principal axes of a, that differ least from the current
// ones.
struct AcrossCurve {
    Vec3 first, second;
};
AcrossCurve across_curve(const DirectJoint& j, Vec3 tangent) {
    const Vec3 along = rotate(j.frame_a, tangent);
    const Vec3 first = normalized(j.across[0] - along * dot(along, j.across[0]));
    return {first, cross(along, first)};
}

void find_on_curve(const DirectJoint& j, FreeAxisEnds& ends) {
    if (j.path == nullptr || j.path_travels.empty()) return;
    const OnCurve b = on_curve(j, ends.a, ends.apart);
    ends.on_curve = b.at;
    ends.tangent = rotate(ends.a * j.frame_a, b.nearest.tangent);
    // Beyond the end of an open curve, along its tangent.
    ends.travel = travel_at(*j.path, j.path_travels, b.parameter) +
                  dot(b.nearest.tangent, b.at - b.nearest.position);
}

FreeAxisEnds ends_of(const DirectJoint& j, const DirectBody& a, const DirectBody& b) {
    const Vec3 arm_a = a.axes * j.arm_a, arm_b = b.axes * j.arm_b;
    FreeAxisEnds ends{arm_a, arm_b, (b.x + arm_b) - (a.x + arm_a), a.q, b.q, a.axes, b.axes};
    find_on_curve(j, ends);
    return ends;
}
FreeAxisEnds trial_ends(const DirectJoint& j, const DirectBody& a, const DirectBody& b) {
    const Vec3 arm_a = a.axes1 * j.arm_a, arm_b = b.axes1 * j.arm_b;
    FreeAxisEnds ends{arm_a, arm_b, (b.x1 + arm_b) - (a.x1 + arm_a), a.q1, b.q1, a.axes1, b.axes1};
    find_on_curve(j, ends);
    return ends;
}

const DirectBody& body_at(std::span<const DirectBody> bodies, int body) {
    return bodies[static_cast<std::size_t>(body)];
}

// The row of a slack rope is inactive.
void drop_slack(DirectJoint& j) {
    if (j.off[0]) clear_parts(j.gear[0]);
}

void measure_curve(const DirectJoint& j, const Quat& a, Vec3 apart, double* error) {
    const OnCurve b = on_curve(j, a, apart);
    const AcrossCurve across = across_curve(j, b.nearest.tangent);
    const Vec3 off = rotate(j.frame_a, b.at - b.nearest.position);
    error[0] = dot(across.first, off);
    error[1] = dot(across.second, off);
}

void measure_at(DirectJoint& j, Vec3 xa, const Mat3& a, const Quat& qa, Vec3 xb, const Mat3& b,
                double* error) {
    const Vec3 apart = (xb + b * j.arm_b) - (xa + a * j.arm_a);
    if (j.is_ball())
        error[0] = apart.x, error[1] = apart.y, error[2] = apart.z;
    else if (j.kind == DirectJoint::Points::rod)
        error[0] = length(apart) - j.distance;
    else if (j.path != nullptr)
        measure_curve(j, qa, apart, error);
    else
        for (int k = 0; k < j.points; k++) error[k] = dot(a * j.across[k], apart);
    for (int k = 0; k < j.turns; k++) error[j.points + k] = dot(a * j.turn_a[k], b * j.turn_b[k]);
}

constexpr double min_stiffness = 1e-30;  // N/m or N m / rad

// The weight of the final stretch in the mean that pulls. A weight of 0.5 conserves energy; damped
// springs that h does not resolve settle at rest instead.
double end_share(const FreeAxis& free_axis, double h) {
    const double turn = free_axis.rate * h;
    ASSERT(free_axis.rate >= 0 && free_axis.damping_ratio >= 0);
    return 0.5 + 0.5 * minimum(1, free_axis.damping_ratio * turn * turn);
}

double free_axis_error(const FreeAxis& free_axis, double value, double impulse, double h) {
    if (free_axis.at_limit != 0)
        return value - (free_axis.at_limit > 0 ? free_axis.lower : free_axis.upper);
    if (free_axis.is_held()) {
        const double travelled = value - free_axis.start;
        return free_axis.is_linear() ? travelled - free_axis.hold_speed() * h
                                     : wrapped(wrapped(travelled) - free_axis.hold_speed() * h);
    }
    if (!free_axis.implicit) return 0;
    const double share = end_share(free_axis, h);
    return stretch_of(free_axis, value) +
           stretch_of(free_axis, free_axis.start) * ((1 - share) / share) +
           impulse / spring_pull(free_axis, h);
}

}  // namespace

double bounded_excess(const FreeAxis& free_axis, double most) {
    ASSERT(free_axis.at_limit != 0 && most >= 0);
    return free_axis.at_limit > 0 ? minimum(0, free_axis.start - free_axis.lower + most)
                                  : maximum(0, free_axis.start - free_axis.upper - most);
}

double spring_pull(const FreeAxis& free_axis, double h) {
    return maximum(free_axis.stiffness, min_stiffness) * h * end_share(free_axis, h);
}

void write_vectors(DirectJoint& j, std::span<const DirectBody> bodies) {
    if (!j.is_gear()) return write_vectors(j, body_at(bodies, j.a), body_at(bodies, j.b));
    write_gear(j.gear[0], bodies);
    for (FreeAxis& free_axis : j.free_axes) free_axis.value = j.gear[0].value;
    drop_slack(j);
}

void write_vectors(DirectJoint& j, const DirectBody& a, const DirectBody& b) {
    ASSERT(!j.is_gear());
    const Vec3 arm_a = a.axes * j.arm_a, arm_b = b.axes * j.arm_b;
    j.apart = (b.x + arm_b) - (a.x + arm_a);
    if (j.path != nullptr) {
        const OnCurve at = on_curve(j, a.q, j.apart);
        const AcrossCurve across = across_curve(j, at.nearest.tangent);
        j.path_at = at.parameter;
        j.across[0] = across.first;
        j.across[1] = across.second;
        j.curvature = at.nearest.curvature;
    }
    if (j.is_ball())
        write_ball(j, arm_a, arm_b, j.apart);
    else if (j.kind == DirectJoint::Points::rod)
        write_line(j, 0, normalized(j.apart), arm_a, arm_b);
    else
        for (int k = 0; k < j.points; k++)
            write_line(j, k, a.axes * j.across[k], arm_a + j.apart, arm_b);
    for (int k = 0; k < j.turns; k++) write_turn(j, k, a.axes * j.turn_a[k], b.axes * j.turn_b[k]);
    if (j.free_axes.empty()) return;
    const FreeAxisEnds ends = ends_of(j, a, b);
    for (FreeAxis& free_axis : j.free_axes) write_free_axis(free_axis, ends);
    copy_free_axes(j);
}

void write_mean_vectors(DirectJoint& j, std::span<const DirectBody> bodies) {
    if (j.is_gear()) {
        write_mean_gear(j.gear[0], bodies);
        return drop_slack(j);
    }
    const DirectBody &a = body_at(bodies, j.a), &b = body_at(bodies, j.b);
    const auto mean = [](const DirectBody& body, Vec3 v) {
        return (body.axes * v + body.axes1 * v) * 0.5;
    };
    const Vec3 arm_a = mean(a, j.arm_a), arm_b = mean(b, j.arm_b);
    const Vec3 apart = ((b.x + b.x1) * 0.5 + arm_b) - ((a.x + a.x1) * 0.5 + arm_a);
    if (j.is_ball()) {
        write_ball(j, arm_a, arm_b, apart);
    } else if (j.kind == DirectJoint::Points::rod) {
        // The difference of the lengths is exactly the mean displacement along the line.
        const Vec3 before = (b.x + b.axes * j.arm_b) - (a.x + a.axes * j.arm_a);
        const Vec3 after = (b.x1 + b.axes1 * j.arm_b) - (a.x1 + a.axes1 * j.arm_a);
        const double sum = length(before) + length(after);
        write_line(j, 0, sum > 1e-12 ? (before + after) * (1 / sum) : Vec3{0, 1, 0}, arm_a, arm_b);
    } else if (j.path != nullptr) {
        // Across the chord from the start to the end of the step, so that the force does no work.
        const Vec3 before = (b.x + b.axes * j.arm_b) - (a.x + a.axes * j.arm_a);
        const Vec3 after = (b.x1 + b.axes1 * j.arm_b) - (a.x1 + a.axes1 * j.arm_a);
        const Vec3 chord =
            inverse_rotate(a.q1 * j.frame_a, after) - inverse_rotate(a.q * j.frame_a, before);
        const double size = length(chord);
        const AcrossCurve across = size > 1e-9 ? across_curve(j, chord * (1 / size))
                                               : AcrossCurve{j.across[0], j.across[1]};
        write_line(j, 0, mean(a, across.first), arm_a + apart, arm_b);
        write_line(j, 1, mean(a, across.second), arm_a + apart, arm_b);
    } else {
        for (int k = 0; k < j.points; k++)
            write_line(j, k, mean(a, j.across[k]), arm_a + apart, arm_b);
    }
    for (int k = 0; k < j.turns; k++) write_turn(j, k, mean(a, j.turn_a[k]), mean(b, j.turn_b[k]));
    if (j.free_axes.empty()) return;
    const FreeAxisEnds before = ends_of(j, a, b), after = trial_ends(j, a, b);
    for (FreeAxis& free_axis : j.free_axes) write_mean_free_axis(free_axis, before, after);
    copy_free_axes(j);
}

namespace {

// At the state of write_vectors().
void measure_gear_start(DirectJoint& j) {
    j.start[0] = j.gear[0].value - j.gear[0].target;
    for (FreeAxis& free_axis : j.free_axes) free_axis.start = j.gear[0].value;
}

void measure_gear(DirectJoint& j, std::span<const DirectBody> bodies, double h) {
    const double sum = trial_sum(j.gear[0], bodies);
    j.error[0] = sum - j.gear[0].target;
    for (const FreeAxis& free_axis : j.free_axes)
        j.error[0] = free_axis.at_limit != 0 ? free_axis_error(free_axis, sum, j.impulse[0], h) : 0;
}

}  // namespace

void measure_start(DirectJoint& j, std::span<const DirectBody> bodies) {
    if (j.is_gear()) return measure_gear_start(j);
    const DirectBody &a = body_at(bodies, j.a), &b = body_at(bodies, j.b);
    measure_at(j, a.x, a.axes, a.q, b.x, b.axes, j.start);
    if (j.free_axes.empty()) return;
    const FreeAxisEnds ends = ends_of(j, a, b);
    for (FreeAxis& free_axis : j.free_axes) {
        free_axis.start = value_of(free_axis, ends);
        if (free_axis.has_range()) free_axis.reference = free_axis.start;
    }
}

void measure(DirectJoint& j, std::span<const DirectBody> bodies, double h) {
    if (j.is_gear()) return measure_gear(j, bodies, h);
    const DirectBody &a = body_at(bodies, j.a), &b = body_at(bodies, j.b);
    measure_at(j, a.x1, a.axes1, a.q1, b.x1, b.axes1, j.error);
    if (j.free_axes.empty()) return;
    const FreeAxisEnds ends = trial_ends(j, a, b);
    int row = j.first_free_axis();
    for (const FreeAxis& free_axis : j.free_axes) {
        const bool on = free_axis.at_limit != 0 || free_axis.is_held() || free_axis.implicit;
        j.error[row] =
            on ? free_axis_error(free_axis, value_of(free_axis, ends), j.impulse[row], h) : 0;
        row++;
    }
}

double speed_along_path(const DirectJoint& j, std::span<const DirectBody> bodies) {
    const DirectBody &a = body_at(bodies, j.a), &b = body_at(bodies, j.b);
    const Vec3 arm_b = b.axes * j.arm_b, at = b.x + arm_b;
    const Vec3 speed =
        (velocity(b) + cross(spin(b), arm_b)) - (velocity(a) + cross(spin(a), at - a.x));
    return dot(rotate(a.q * j.frame_a, curve_point_at(*j.path, j.path_at).tangent), speed);
}

double trial_value(const DirectJoint& j, const FreeAxis& free_axis,
                   std::span<const DirectBody> bodies) {
    if (j.is_gear()) return trial_sum(j.gear[0], bodies);
    return value_of(free_axis, trial_ends(j, body_at(bodies, j.a), body_at(bodies, j.b)));
}

}  // namespace jostle::physics
