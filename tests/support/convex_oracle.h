// SPDX-License-Identifier: MIT
//
// Distance or penetration depth of two convex shapes by a search over all directions. Uses neither
// GJK nor a list of separating axes, and shares only vector types with the library.
//
// For a unit direction n the slabs of both shapes along n leave the gap s(n) = min over b of n.x -
// max over a of n.x. The signed distance of two convex shapes is the largest s(n) over all n: if
// positive, their distance; if negative, minus the penetration depth. Every s(n) is a lower bound,
// so the normal of any other method can be checked by evaluating s there.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "jostle/physics/geometry.h"
#include "jostle/physics/hull.h"
#include "jostle/physics/transform.h"
#include "tests/support/distance_field.h"

namespace jostle::test {

// The largest n.x over the shape in its pose. Not for planes.
inline double support(const physics::Geometry& geometry, const physics::Transform& pose,
                      physics::Vec3 n) {
    using namespace physics;
    const Vec3 d = inverse_rotate(pose.rotation, n);
    const double center = dot(pose.position, n);
    if (const auto* sphere = std::get_if<Sphere>(&geometry))
        return center + sphere->radius * length(n);
    if (const auto* capsule = std::get_if<Capsule>(&geometry))
        return center + capsule->half_length * std::fabs(d.y) + capsule->radius * length(n);
    if (const auto* cylinder = std::get_if<Cylinder>(&geometry))
        return center + cylinder->half_length * std::fabs(d.y) +
               cylinder->radius * std::hypot(d.x, d.z);
    if (const auto* cone = std::get_if<Cone>(&geometry))
        return center + std::max(cone->half_length * d.y,
                                 cone->radius * std::hypot(d.x, d.z) - cone->half_length * d.y);
    if (const auto* hull = std::get_if<Hull>(&geometry)) {
        double most = -1e300;
        for (const Vec3 v : hull->data->vertices) most = std::max(most, dot(v, d));
        return center + most;
    }
    const Vec3 h = std::get<Box>(geometry).half_extents;
    return center + h.x * std::fabs(d.x) + h.y * std::fabs(d.y) + h.z * std::fabs(d.z);
}

// s(n): the gap between the slabs of a and b along n.
inline double slab_gap(const physics::Geometry& a, const physics::Transform& pose_a,
                       const physics::Geometry& b, const physics::Transform& pose_b,
                       physics::Vec3 n) {
    return -support(b, pose_b, -n) - support(a, pose_a, n);
}

struct OracleGap {
    double distance = 0;   // m, signed
    physics::Vec3 normal;  // unit, from a to b
};

namespace detail {

// 1500 directions of a Fibonacci spiral, about 4 degrees apart.
inline const std::vector<physics::Vec3>& directions() {
    static const std::vector<physics::Vec3> all = [] {
        std::vector<physics::Vec3> list;
        const int count = 1500;
        const double golden = physics::pi * (3 - std::sqrt(5.0));
        for (int i = 0; i < count; i++) {
            const double y = 1 - 2 * (i + 0.5) / count, r = std::sqrt(1 - y * y);
            list.push_back({r * std::cos(golden * i), y, r * std::sin(golden * i)});
        }
        return list;
    }();
    return all;
}

// Maximizes s by hill climbing from n. Evaluates a ring of trial directions that shrinks if none is
// better and rotates in every iteration, so that it does not miss a ridge between the directions.
template <class Gap>
OracleGap climb(const Gap& gap, physics::Vec3 n) {
    double best = gap(n), step = 0.06, turn = 0;
    while (step > 1e-9) {
        const physics::Vec3 t1 = normalized(
            cross(n, std::fabs(n.x) < 0.7 ? physics::Vec3{1, 0, 0} : physics::Vec3{0, 1, 0}));
        const physics::Vec3 t2 = cross(n, t1);
        physics::Vec3 winner = n;
        double record = best;
        for (int k = 0; k < 12; k++) {
            const double angle = turn + k * physics::pi / 6;
            const physics::Vec3 trial =
                normalized(n + (t1 * std::cos(angle) + t2 * std::sin(angle)) * step);
            const double s = gap(trial);
            if (s > record) record = s, winner = trial;
        }
        turn += 0.7;
        if (record > best)
            best = record, n = winner;
        else
            step *= 0.6;
    }
    return {best, n};
}

}  // namespace detail

// The largest gap(n) over all n, accurate to about 1e-6 of the sizes.
template <class Gap>
OracleGap widest(const Gap& gap) {
    using physics::Vec3;
    // Hill climbing from the best few of all directions. The maxima of s are as wide as the faces
    // that cause them.
    constexpr int starts = 10;
    std::array<OracleGap, starts> best;
    best.fill({-1e300, {}});
    for (const Vec3 n : detail::directions()) {
        const double s = gap(n);
        if (s <= best.back().distance) continue;
        int index = starts - 1;
        for (; index > 0 && best[static_cast<std::size_t>(index - 1)].distance < s; index--)
            best[static_cast<std::size_t>(index)] = best[static_cast<std::size_t>(index - 1)];
        best[static_cast<std::size_t>(index)] = {s, n};
    }
    OracleGap result{-1e300, {}};
    for (const OracleGap& start : best) {
        if (start.distance < -1e299) continue;
        const OracleGap top = detail::climb(gap, start.normal);
        if (top.distance > result.distance) result = top;
    }
    return result;
}

// a must not be a plane.
inline OracleGap separation(const physics::Geometry& a, const physics::Transform& pose_a,
                            const physics::Geometry& b, const physics::Transform& pose_b) {
    using namespace physics;
    if (const auto* plane = std::get_if<Plane>(&b)) {
        const Vec3 up = rotate(pose_b.rotation, plane->normal);
        return {-support(a, pose_a, -up) - dot(up, pose_b.position), -up};
    }
    return widest([&](Vec3 n) { return slab_gap(a, pose_a, b, pose_b, n); });
}

// Whether the signed distance is certainly greater than `least`: one direction with a wider gap
// proves it, and is found much sooner than the widest gap. a must not be a plane.
inline bool farther_apart_than(double least, const physics::Geometry& a,
                               const physics::Transform& pose_a, const physics::Geometry& b,
                               const physics::Transform& pose_b) {
    using namespace physics;
    if (std::holds_alternative<Plane>(b)) return separation(a, pose_a, b, pose_b).distance > least;
    const Vec3 between = pose_b.position - pose_a.position;
    if (length(between) > 0 && slab_gap(a, pose_a, b, pose_b, normalized(between)) > least)
        return true;
    for (const Vec3 n : detail::directions())
        if (slab_gap(a, pose_a, b, pose_b, n) > least) return true;
    return separation(a, pose_a, b, pose_b).distance > least;
}

// The point of the shape nearest to p. Not for planes.
inline physics::Vec3 nearest_point(const physics::Geometry& geometry,
                                   const physics::Transform& pose, physics::Vec3 p) {
    using namespace physics;
    const Vec3 q = apply_inverse(pose, p);
    Vec3 core, out;
    double radius = 0;
    if (const auto* box = std::get_if<Box>(&geometry)) {
        const Vec3 h = box->half_extents;
        return apply(pose, {clamp(q.x, -h.x, h.x), clamp(q.y, -h.y, h.y), clamp(q.z, -h.z, h.z)});
    }
    if (const auto* hull = std::get_if<Hull>(&geometry))
        return signed_distance(geometry, q) <= 0 ? p
                                                 : apply(pose, nearest_on_border(*hull->data, q));
    if (std::holds_alternative<Cylinder>(geometry) || std::holds_alternative<Cone>(geometry)) {
        const auto outline = std::holds_alternative<Cone>(geometry)
                                 ? outline_of(std::get<Cone>(geometry))
                                 : outline_of(std::get<Cylinder>(geometry));
        const double r = std::hypot(q.x, q.z);
        Flat at{};
        if (distance_to_outline(outline, {r, q.y}, at) <= 0) return p;
        const double scale = r > 0 ? at.r / r : 0;
        return apply(pose, {q.x * scale, at.y, q.z * scale});
    }
    if (const auto* sphere = std::get_if<Sphere>(&geometry)) radius = sphere->radius;
    if (const auto* capsule = std::get_if<Capsule>(&geometry)) {
        radius = capsule->radius;
        core.y = clamp(q.y, -capsule->half_length, capsule->half_length);
    }
    out = q - core;
    const double d = length(out);
    return apply(pose, d <= radius ? q : core + out * (radius / d));
}

// An upper bound of the distance, while slab_gap is a lower bound: alternating projections of two
// points onto the other shape converge to the distance of the shapes.
inline double distance_at_most(const physics::Geometry& a, const physics::Transform& pose_a,
                               const physics::Geometry& b, const physics::Transform& pose_b) {
    physics::Vec3 on_a = pose_a.position, on_b = pose_b.position;
    for (int i = 0; i < 400; i++) {
        on_b = nearest_point(b, pose_b, on_a);
        on_a = nearest_point(a, pose_a, on_b);
    }
    return length(on_b - on_a);
}

}  // namespace jostle::test
