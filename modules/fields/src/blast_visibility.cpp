// SPDX-License-Identifier: MIT
#include "modules/fields/src/blast_visibility.h"

#include <algorithm>
#include <utility>

#include "jostle/physics/scalar.h"

namespace jostle::modules::fields_detail {

using namespace physics;

namespace {

constexpr double ray_start_offset = 0.01;  // m from the centre at which rays start
constexpr double hit_tolerance = 1e-3;     // m: a hit nearer to a point than this is at the point

}  // namespace

double strength_at(const Explosion& e, double distance) {
    if (distance >= e.radius) return 0;
    double strength = e.strength;
    const double share = e.core / maximum(distance, e.core);
    for (std::uint32_t k = 0; k < e.falloff; k++) strength *= share;
    return e.fade ? strength * (1 - distance / e.radius) : strength;
}

Vec3 offset_center(const Queries& queries, const Explosion& e) {
    Vec3 center = e.center;
    for (int k = 0; k < 3 && e.standoff > 0; k++) {
        const auto near = queries.closest_point(center, e.standoff);
        if (!near.ok() || !*near || (*near)->distance >= e.standoff * (1 - 1e-9)) break;
        center = (*near)->point + (*near)->normal * e.standoff;
    }
    return center;
}

BlastVisibility::BlastVisibility(const Queries& queries, Vec3 center)
    : queries_(queries), center_(center) {
    if (auto shapes = queries.shapes_at(center); shapes.ok())
        enclosing_shapes_ = std::move(*shapes);
}

bool BlastVisibility::is_visible(Vec3 point) const {
    const std::optional<RayHit> hit = first_hit(point);
    return !hit || length(point - hit->point) <= hit_tolerance;
}

bool BlastVisibility::is_visible(const BlastPoint& point, ShapeId shape, bool is_compound) const {
    const std::optional<RayHit> hit = first_hit(point.position);
    if (!hit) return true;
    const double left = length(point.position - hit->point);
    if (left <= hit_tolerance) return true;
    if (hit->shape != shape) return false;
    return !is_compound || left <= 0.1 * square_root(length(point.area));
}

std::optional<RayHit> BlastVisibility::first_hit(Vec3 point) const {
    const Vec3 offset = point - center_;
    const double distance = length(offset);
    const Vec3 start = center_ + offset * minimum(ray_start_offset / distance, 0.5);
    const Ray ray{.origin = start, .motion = point - start};
    if (enclosing_shapes_.empty()) {
        const auto hit = queries_.cast_ray(ray);
        return hit.ok() ? *hit : std::nullopt;
    }
    const auto hits = queries_.cast_ray_all(ray);
    if (!hits.ok()) return std::nullopt;
    for (const RayHit& hit : *hits)
        if (std::ranges::find(enclosing_shapes_, hit.shape) == enclosing_shapes_.end()) return hit;
    return std::nullopt;
}

}  // namespace jostle::modules::fields_detail
