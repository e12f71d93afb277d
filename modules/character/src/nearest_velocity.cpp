// SPDX-License-Identifier: MIT
#include "modules/character/src/nearest_velocity.h"

#include <optional>

#include "jostle/physics/mat3.h"

namespace jostle::modules::character_detail {
namespace {

using namespace physics;

constexpr double tolerance = 1e-9;  // m/s
// cosine of 1 degree: normals within this angle count as one
constexpr double same_normal_tolerance = 0.99985;

using Planes = std::span<const VelocityPlane>;

bool allowed(Vec3 v, Planes planes) {
    for (const VelocityPlane& plane : planes)
        if (dot(plane.normal, v) < plane.min_speed - tolerance * (1 + absolute(plane.min_speed)))
            return false;
    return true;
}

// Projects `desired` onto one plane; nullopt if `desired` does not violate it.
std::optional<Vec3> project_on_one(Vec3 desired, const VelocityPlane& a) {
    const double push = a.min_speed - dot(a.normal, desired);
    if (push <= 0) return std::nullopt;
    return desired + a.normal * push;
}

// Projects onto the intersection line of two planes; nullopt if one of them does not push.
std::optional<Vec3> project_on_two(Vec3 desired, const VelocityPlane& a, const VelocityPlane& b) {
    const double c = dot(a.normal, b.normal), det = 1 - c * c;
    if (det < 1e-9) return std::nullopt;
    const double ra = a.min_speed - dot(a.normal, desired),
                 rb = b.min_speed - dot(b.normal, desired);
    const double pa = (ra - c * rb) / det, pb = (rb - c * ra) / det;
    if (pa < 0 || pb < 0) return std::nullopt;
    return desired + a.normal * pa + b.normal * pb;
}

// Returns the intersection point of three planes; nullopt if one of them does not push.
std::optional<Vec3> intersect_three(Vec3 desired, const VelocityPlane& a, const VelocityPlane& b,
                                    const VelocityPlane& c) {
    // v solves N v = min_speed, where the rows of N are the normals. The pushes p solve N^T p = v -
    // desired.
    const Mat3 normals{a.normal, b.normal, c.normal};  // as columns
    if (absolute(determinant(normals)) < 1e-6) return std::nullopt;
    const Vec3 v = inverse(transpose(normals)) * Vec3{a.min_speed, b.min_speed, c.min_speed};
    const Vec3 push = inverse(normals) * (v - desired);
    if (push.x < 0 || push.y < 0 || push.z < 0) return std::nullopt;
    return v;
}

// For contradictory planes: projects onto each plane in turn, for a few rounds.
Vec3 least_violating_velocity(Vec3 v, Planes planes, double most) {
    for (int round = 0; round < 8; round++)
        for (const VelocityPlane& plane : planes)
            v += plane.normal * maximum(0, plane.min_speed - dot(plane.normal, v));
    const double speed = length(v);
    return speed > most ? v * (most / speed) : v;
}

// Upper bound on the speed of a valid result. Sliding along stationary planes never increases the
// speed. Three moving, mutually orthogonal planes add at most three times their speed.
double max_plane_speed(Vec3 desired, Planes planes) {
    double fastest = 0;
    for (const VelocityPlane& plane : planes) fastest = maximum(fastest, plane.min_speed);
    return square_root(length_squared(desired) + 3 * fastest * fastest) * (1 + 1e-9) + tolerance;
}

}  // namespace

// The problem is convex, so the first allowed candidate that all of its planes push is the nearest
// (Karush-Kuhn-Tucker conditions). Planes that are nearly parallel because of rounding, or that
// close like a wedge, intersect far away; max_plane_speed() rejects these candidates.
Vec3 nearest_velocity(Vec3 desired, Planes planes) {
    planes =
        planes.first(planes.size() < velocity_planes_max ? planes.size() : velocity_planes_max);
    if (allowed(desired, planes)) return desired;
    const double most = max_plane_speed(desired, planes);
    const auto good = [&](const std::optional<Vec3>& v) {
        return v && length(*v) <= most && allowed(*v, planes);
    };
    const std::size_t n = planes.size();
    for (std::size_t a = 0; a < n; a++)
        if (const auto v = project_on_one(desired, planes[a]); good(v)) return *v;
    for (std::size_t a = 0; a < n; a++)
        for (std::size_t b = a + 1; b < n; b++)
            if (const auto v = project_on_two(desired, planes[a], planes[b]); good(v)) return *v;
    for (std::size_t a = 0; a < n; a++)
        for (std::size_t b = a + 1; b < n; b++)
            for (std::size_t c = b + 1; c < n; c++)
                if (const auto v = intersect_three(desired, planes[a], planes[b], planes[c]);
                    good(v))
                    return *v;
    return least_violating_velocity(desired, planes, most);
}

void VelocityPlanes::add(Vec3 normal, double least) {
    for (std::size_t k = 0; k < count_; k++)
        if (dot(planes_[k].normal, normal) > same_normal_tolerance) {
            planes_[k].min_speed = maximum(planes_[k].min_speed, least);
            return;
        }
    if (count_ < planes_.size()) planes_[count_++] = {normal, least};
}

}  // namespace jostle::modules::character_detail
