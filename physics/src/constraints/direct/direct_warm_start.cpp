// SPDX-License-Identifier: MIT
//
// Converts the stored state of a joint to the forces of a group, and back.
#include "jostle/base/check.h"
#include "physics/src/constraints/direct/direct_joint.h"

namespace jostle::physics {
namespace {

// The three rows of a gimbal whose locked rotations are zero, world. Evaluated at the state of
// write_vectors(): the rotational rows span the locked subspace.
struct LockedRows {
    Vec3 first, middle, last;
};
LockedRows locked_rows(const DirectJoint& j, const DirectBody& a, const DirectBody& b) {
    const Vec3 first = rotate(a.q * j.frame_a, {1, 0, 0});
    const Vec3 last = rotate(b.q * j.frame_b, {0, 0, 1});
    return {first, normalized(cross(last, first)), last};
}

// A limit with a larger impulse is active.
double idle_impulse(const FreeAxis& free_axis) {
    return free_axis.is_ambiguous() ? 2 * side_mark : 0;
}

void load_free_axis(FreeAxis& free_axis, double& force,
                    const WarmStartCache::FreeAxisImpulses& cache, double h) {
    const double idle = idle_impulse(free_axis);
    if (free_axis.has_limit())
        free_axis.at_limit = cache.lower > idle ? 1 : (cache.upper > idle ? -1 : 0);
    if (free_axis.is_ambiguous())
        free_axis.reference =
            reference_angle({true, free_axis.lower, free_axis.upper}, cache.lower, cache.upper);
    load_actuation(free_axis, (cache.motor + cache.friction) / h);
    ASSERT(h > 0 && cache.lower >= 0 && cache.upper >= 0);
    if (free_axis.at_limit != 0) {
        if (free_axis.is_held()) free_axis.actuation = FreeAxis::at_rest;
        actuation_on_limit(free_axis);  // the motor may have changed
        force = (cache.lower - cache.upper) * (0.5 / h);
    } else if (free_axis.is_held()) {
        force = (cache.motor + cache.friction) * (0.5 / h);
    }
}

WarmStartCache::FreeAxisImpulses save_free_axis(const FreeAxis& free_axis, double force, double h) {
    WarmStartCache::FreeAxisImpulses cache;
    const double least = free_axis.is_ambiguous() ? 2 * idle_impulse(free_axis) : 1e-300;
    if (free_axis.at_limit > 0) cache.lower = maximum(2 * h * force, least);
    if (free_axis.at_limit < 0) cache.upper = maximum(-2 * h * force, least);
    if (free_axis.is_ambiguous() && free_axis.at_limit == 0) {
        if (free_axis.value < free_axis.lower + side_margin) cache.lower = side_mark;
        if (free_axis.value > free_axis.upper - side_margin) cache.upper = side_mark;
    }
    const bool held = free_axis.at_limit == 0 && free_axis.is_held();
    const double gripped = h * (held ? 2 * force : free_axis.push());
    cache.friction =
        maximum(-free_axis.friction_limit * h, minimum(gripped, free_axis.friction_limit * h));
    cache.motor = gripped - cache.friction;
    if (free_axis.rate > 0)
        cache.spring = -h * free_axis.stiffness * stretch_of(free_axis, free_axis.value);
    return cache;
}

}  // namespace

// Forces are stored as halves, one per half step.
void load_forces(DirectJoint& j, const DirectBody& a, const DirectBody& b,
                 const WarmStartCache& cache, double h) {
    const double half = 0.5 / h;
    ASSERT(h > 0);
    if (j.is_ball())
        for (int k = 0; k < 3; k++) j.force[k] = cache.point[k] * half;
    else if (j.kind == DirectJoint::Points::rod)
        j.force[0] = cache.free_axes[0].spring * half;
    else
        for (int k = 0; k < j.points; k++) j.force[k] = dot(j.linear[k], cache.point) * half;
    Vec3 angular = cache.angular;
    if (j.gimbal && j.turns > 0) {
        const LockedRows rows = locked_rows(j, a, b);
        angular =
            rows.first * cache.turns.x + rows.middle * cache.turns.y + rows.last * cache.turns.z;
    }
    // The rotational rows are perpendicular if the joint holds.
    for (int k = j.points; k < j.first_free_axis(); k++) {
        const double size = length_squared(j.angular_b[k]);
        j.force[k] = size > 1e-6 ? dot(j.angular_b[k], angular) * half / size : 0;
    }
    int row = j.first_free_axis();
    for (FreeAxis& free_axis : j.free_axes) {
        load_free_axis(free_axis, j.force[row],
                       cache.free_axes[static_cast<std::size_t>(free_axis.slot)], h);
        row++;
    }
}

WarmStartCache save_forces(const DirectJoint& j, const DirectBody& a, const DirectBody& b,
                           double h) {
    const double both = 2 * h;
    ASSERT(h > 0);
    WarmStartCache cache;
    if (j.is_ball())
        cache.point = Vec3{j.force[0], j.force[1], j.force[2]} * both;
    else if (j.kind == DirectJoint::Points::rod)
        cache.free_axes[0].spring = j.force[0] * both;
    else
        for (int k = 0; k < j.points; k++) cache.point += j.linear[k] * (j.force[k] * both);
    for (int k = j.points; k < j.first_free_axis(); k++)
        cache.angular += j.angular_b[k] * (j.force[k] * both);
    if (j.gimbal && j.turns > 0) {
        const LockedRows rows = locked_rows(j, a, b);
        cache.turns = {dot(rows.first, cache.angular), dot(rows.middle, cache.angular),
                       dot(rows.last, cache.angular)};
        cache.angular = {};
    }
    int row = j.first_free_axis();
    for (const FreeAxis& free_axis : j.free_axes)
        cache.free_axes[static_cast<std::size_t>(free_axis.slot)] =
            save_free_axis(free_axis, j.force[row++], h);
    return cache;
}

}  // namespace jostle::physics
