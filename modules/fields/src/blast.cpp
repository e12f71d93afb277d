// SPDX-License-Identifier: MIT
#include "jostle/modules/blast.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>

#include "jostle/modules/deformables.h"
#include "jostle/physics/limits.h"
#include "modules/fields/src/blast_points.h"
#include "modules/fields/src/blast_visibility.h"
#include "modules/fields/src/body_field_cache.h"
#include "modules/fields/src/field_checks.h"

namespace jostle::modules {

using namespace physics;
using fields_detail::BlastPoint;
using fields_detail::BlastVisibility;
using fields_detail::offset_center;
using fields_detail::strength_at;

namespace {

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
    if (Status s = push_deformables(world, explosion); !s.ok()) return s.error();
    return impulses;
}

Status push_deformables(World& world, const Explosion& explosion) {
    if (Status s = fields_detail::check(explosion); !s.ok()) return s;
    const Queries queries = world.queries();
    const Vec3 center = offset_center(queries, explosion);
    const BlastVisibility visibility(queries, center);
    // Neighbouring points see the centre alike: one ray for each cell of a grid.
    const double cell = explosion.radius / 16;
    std::map<std::array<std::int64_t, 3>, bool> seen;
    const auto is_seen = [&](Vec3 point) {
        const Vec3 at = (point - center) * (1 / cell);
        const std::array<std::int64_t, 3> key{static_cast<std::int64_t>(std::floor(at.x)),
                                              static_cast<std::int64_t>(std::floor(at.y)),
                                              static_cast<std::int64_t>(std::floor(at.z))};
        const auto [entry, is_new] = seen.try_emplace(key, false);
        if (is_new) entry->second = visibility.is_visible(point);
        return entry->second;
    };
    apply_pulse(world,
                {.center = center,
                 .radius = explosion.radius,
                 .max_speed = explosion.max_speed > 0 ? explosion.max_speed : limits::max_speed,
                 .impulse_per_area = [&](Vec3 point) {
                     const Vec3 offset = point - center;
                     const double distance = length(offset);
                     const double strength = strength_at(explosion, distance);
                     if (!(distance > 1e-9) || strength == 0 || !is_seen(point)) return Vec3{};
                     return offset * (strength / distance);
                 }});
    return {};
}

}  // namespace jostle::modules
