// SPDX-License-Identifier: MIT
#include "jostle/modules/blast.h"

#include <algorithm>
#include <optional>
#include <span>

#include "jostle/physics/limits.h"
#include "modules/fields/src/blast_points.h"
#include "modules/fields/src/body_field_cache.h"
#include "modules/fields/src/field_checks.h"

namespace jostle::modules {

using namespace physics;
using fields_detail::BlastPoint;

namespace {

constexpr double ray_start_offset = 0.01;  // m from the centre at which rays start
constexpr double hit_tolerance = 1e-3;     // m: a hit nearer to a point than this is at the point

// Impulse per area that faces the centre, N s/m^2.
double strength_at(const Explosion& e, double distance) {
    if (distance >= e.radius) return 0;
    double strength = e.strength;
    const double share = e.core / maximum(distance, e.core);
    for (std::uint32_t k = 0; k < e.falloff; k++) strength *= share;
    return e.fade ? strength * (1 - distance / e.radius) : strength;
}

// Moves the centre out of surfaces that are too near; in a corner, out of one after the other.
Vec3 offset_center(const Queries& queries, const Explosion& e) {
    Vec3 center = e.center;
    for (int k = 0; k < 3 && e.standoff > 0; k++) {
        const auto near = queries.closest_point(center, e.standoff);
        if (!near.ok() || !*near || (*near)->distance >= e.standoff * (1 - 1e-9)) break;
        center = (*near)->point + (*near)->normal * e.standoff;
    }
    return center;
}

// Line-of-sight tests from the centre of an explosion.
class BlastVisibility {
public:
    BlastVisibility(const Queries& queries, Vec3 center) : queries_(queries), center_(center) {
        if (auto shapes = queries.shapes_at(center); shapes.ok())
            enclosing_shapes_ = std::move(*shapes);
    }

    // A convex shape does not hide its own surface that faces the centre. Children of a compound
    // may hide each other.
    bool is_visible(const BlastPoint& point, ShapeId shape, bool is_compound) const {
        const std::optional<RayHit> hit = first_hit(point.position);
        if (!hit) return true;
        const double left = length(point.position - hit->point);
        if (left <= hit_tolerance) return true;
        if (hit->shape != shape) return false;
        return !is_compound || left <= 0.1 * square_root(length(point.area));
    }

private:
    std::optional<RayHit> first_hit(Vec3 point) const {
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
            if (std::ranges::find(enclosing_shapes_, hit.shape) == enclosing_shapes_.end())
                return hit;
        return std::nullopt;
    }

    const Queries& queries_;
    Vec3 center_;
    std::vector<ShapeId> enclosing_shapes_;  // shapes that contain the centre
};

// Fraction of the impulse that is applied, 1 for all. It also respects the limits of
// World::apply_impulse().
double allowed_impulse_share(const Explosion& e, const BlastImpulse& push, double mass) {
    constexpr double most_impulse = 1e11;  // N s, N m s
    const double max_speed = e.max_speed > 0 ? e.max_speed : limits::max_speed;
    const double impulse = length(push.impulse), turn = length(push.angular_impulse);
    double share = 1;
    if (impulse > max_speed * mass) share = max_speed * mass / impulse;
    if (impulse * share > most_impulse) share = most_impulse / impulse;
    if (turn * share > most_impulse) share = most_impulse / turn;
    return share;
}

bool is_within(Vec3 p, double most) {
    return absolute(p.x) <= most && absolute(p.y) <= most && absolute(p.z) <= most;
}

struct Target {
    BodyState body;
    double distance;  // m, of its centre of mass
};

// Dynamic bodies in range, nearest first.
std::vector<Target> targets_of(const World& world, const Queries& queries, const Explosion& e,
                               Vec3 center) {
    const Vec3 reach{e.radius, e.radius, e.radius};
    std::vector<BodyId> bodies;
    if (const auto shapes = queries.overlap_box({center - reach, center + reach}); shapes.ok())
        for (const ShapeId id : *shapes)
            if (const auto shape = world.shape(id); shape.ok()) bodies.push_back(shape->body);
    std::ranges::sort(bodies);
    bodies.erase(std::ranges::unique(bodies).begin(), bodies.end());
    std::vector<Target> targets;
    for (const BodyId id : bodies) {
        const auto body = world.body(id);
        if (!body.ok() || body->type != BodyType::dynamic) continue;
        if (!is_within(body->center, limits::max_coordinate)) continue;
        if ((fields_detail::categories_of(world, id) & e.mask) == 0) continue;
        targets.push_back({*body, length(body->center - center)});
    }
    std::ranges::stable_sort(targets, {}, &Target::distance);
    return targets;
}

struct Blast {
    const Explosion& explosion;
    Vec3 center;
    BlastVisibility visibility;
    std::uint32_t points;  // per shape
    std::size_t rays = 0;

    void add(const BlastPoint& point, ShapeId shape, bool is_compound, BlastImpulse& push) {
        const Vec3 offset = point.position - center;
        const double distance = length(offset);
        if (!(distance > 1e-9)) return;
        const Vec3 away = offset * (1 / distance);
        const double area = -dot(point.area, away);
        const double strength = strength_at(explosion, distance);
        if (!(area > 0) || strength == 0) return;
        rays++;
        if (!visibility.is_visible(point, shape, is_compound)) {
            push.occluded_area += area;
            return;
        }
        push.area += area;
        const Vec3 impulse = away * (strength * area);
        push.impulse += impulse;
        push.angular_impulse += cross(point.position - push.center, impulse);
    }

    BlastImpulse impulse_of(const World& world, const BodyState& body) {
        BlastImpulse push{.body = body.id, .center = body.center};
        for (const ShapeId id : world.shapes_of(body.id)) {
            const auto shape = world.shape(id);
            if (!shape.ok() || shape->trigger || rays >= blast_rays_max) continue;
            const bool is_compound = kind_of(shape->geometry) == ShapeKind::compound;
            for (const BlastPoint& point : fields_detail::blast_points(
                     shape->geometry, compose(body.pose, shape->pose), points))
                add(point, id, is_compound, push);
        }
        const double most = allowed_impulse_share(explosion, push, body.mass);
        push.impulse *= most;
        push.angular_impulse *= most;
        return push;
    }
};

}  // namespace

Result<std::vector<BlastImpulse>> compute_blast(const World& world, const Explosion& explosion) {
    if (Status s = fields_detail::check(explosion); !s.ok()) return s.error();
    const Queries queries = world.queries();
    const Vec3 center = offset_center(queries, explosion);
    const std::vector<Target> targets = targets_of(world, queries, explosion, center);
    const std::size_t share = 2 * blast_rays_max / (targets.size() + 1);
    Blast blast{explosion, center, BlastVisibility(queries, center),
                static_cast<std::uint32_t>(std::clamp<std::size_t>(share, 6, explosion.points))};
    std::vector<BlastImpulse> impulses;
    for (const Target& target : targets) {
        if (blast.rays >= blast_rays_max) break;
        BlastImpulse push = blast.impulse_of(world, target.body);
        if (push.area > 0 || push.occluded_area > 0) impulses.push_back(push);
    }
    std::ranges::sort(impulses, {}, &BlastImpulse::body);
    return impulses;
}

Result<std::vector<BlastImpulse>> explode(World& world, const Explosion& explosion) {
    auto impulses = compute_blast(world, explosion);
    if (!impulses.ok()) return impulses;
    for (const BlastImpulse& push : *impulses) {
        if (push.impulse == Vec3{} && push.angular_impulse == Vec3{}) continue;
        if (Status s = world.apply_impulse(push.body, push.impulse, push.center); !s.ok())
            return s.error();
        if (Status s = world.apply_angular_impulse(push.body, push.angular_impulse); !s.ok())
            return s.error();
    }
    return impulses;
}

}  // namespace jostle::modules
