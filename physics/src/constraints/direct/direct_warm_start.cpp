// SPDX-License-Identifier: MIT
//
// What a world keeps of a joint, as the forces that a group works with, and back.
#include "physics/src/constraints/direct/direct_joint.h"

namespace jostle::physics {
namespace {

// The three rows of a gimbal whose locked turns are zero, world. Read where write_vectors() left
// them: the rows of the turns lie in the plane of what is locked.
struct LockedRows {
    Vec3 first, middle, last;
};
LockedRows locked_rows(const DirectJoint& j, const DirectBody& a, const DirectBody& b) {
    const Vec3 first = rotate(a.q * j.frame_a, {1, 0, 0});
    const Vec3 last = rotate(b.q * j.frame_b, {0, 0, 1});
    return {first, normalized(cross(last, first)), last};
}

void load_free_axis(FreeAxis& way, double& force, const WarmStartCache::FreeAxisImpulses& cache, double h) {
    if (way.has_limit()) way.at_limit = cache.lower > 0 ? 1 : (cache.upper > 0 ? -1 : 0);
    load_grip(way, (cache.motor + cache.friction) / h);
    if (way.at_limit != 0) {
        if (way.is_held()) way.grip = FreeAxis::at_rest;
        force = (cache.lower - cache.upper) * (0.5 / h);
    } else if (way.is_held()) {
        force = (cache.motor + cache.friction) * (0.5 / h);
    }
}

WarmStartCache::FreeAxisImpulses save_free_axis(const FreeAxis& way, double force, double h) {
    WarmStartCache::FreeAxisImpulses cache;
    if (way.at_limit > 0) cache.lower = maximum(2 * h * force, 1e-300);
    if (way.at_limit < 0) cache.upper = maximum(-2 * h * force, 1e-300);
    const bool held = way.at_limit == 0 && way.is_held();
    const double gripped = h * (held ? 2 * force : way.push());
    cache.friction = maximum(-way.rubs * h, minimum(gripped, way.rubs * h));
    cache.motor = gripped - cache.friction;
    if (way.rate > 0) cache.spring = -h * way.stiffness * stretch_of(way, way.value);
    return cache;
}

}  // namespace

// Forces are halves, of the two halves of a step.
void load_forces(DirectJoint& j, const DirectBody& a, const DirectBody& b, const WarmStartCache& cache,
                 double h) {
    const double half = 0.5 / h;
    if (j.is_ball())
        for (int k = 0; k < 3; k++) j.force[k] = cache.point[k] * half;
    else if (j.kind == DirectJoint::Points::rod)
        j.force[0] = cache.ways[0].spring * half;
    else
        for (int k = 0; k < j.points; k++) j.force[k] = dot(j.linear[k], cache.point) * half;
    Vec3 angular = cache.angular;
    if (j.gimbal && j.turns > 0) {
        const LockedRows rows = locked_rows(j, a, b);
        angular = rows.first * cache.turns.x + rows.middle * cache.turns.y + rows.last * cache.turns.z;
    }
    // The rows of the turns are perpendicular where joints hold.
    for (int k = j.points; k < j.first_way(); k++) {
        const double size = length_squared(j.angular_b[k]);
        j.force[k] = size > 1e-6 ? dot(j.angular_b[k], angular) * half / size : 0;
    }
    int row = j.first_way();
    for (FreeAxis& way : j.ways) {
        load_free_axis(way, j.force[row], cache.ways[static_cast<std::size_t>(way.slot)], h);
        row++;
    }
}

WarmStartCache save_forces(const DirectJoint& j, const DirectBody& a, const DirectBody& b, double h) {
    const double both = 2 * h;
    WarmStartCache cache;
    if (j.is_ball())
        cache.point = Vec3{j.force[0], j.force[1], j.force[2]} * both;
    else if (j.kind == DirectJoint::Points::rod)
        cache.ways[0].spring = j.force[0] * both;
    else
        for (int k = 0; k < j.points; k++) cache.point += j.linear[k] * (j.force[k] * both);
    for (int k = j.points; k < j.first_way(); k++)
        cache.angular += j.angular_b[k] * (j.force[k] * both);
    if (j.gimbal && j.turns > 0) {
        const LockedRows rows = locked_rows(j, a, b);
        cache.turns = {dot(rows.first, cache.angular), dot(rows.middle, cache.angular),
                      dot(rows.last, cache.angular)};
        cache.angular = {};
    }
    int row = j.first_way();
    for (const FreeAxis& way : j.ways)
        cache.ways[static_cast<std::size_t>(way.slot)] = save_free_axis(way, j.force[row++], h);
    return cache;
}

}  // namespace jostle::physics
