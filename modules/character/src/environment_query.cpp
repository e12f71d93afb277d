// SPDX-License-Identifier: MIT
#include "modules/character/src/environment_query.h"

#include <algorithm>

namespace jostle::modules::character_detail {
namespace {

using namespace physics;

Aabb box_around(const Capsule& capsule, Vec3 center, double reach) {
    const double side = capsule.radius + reach;
    const Vec3 half{side, side + capsule.half_length, side};
    return {center - half, center + half};
}

Vec3 velocity_of(const BodyState& body, const ShapeState& shape, Vec3 point) {
    Vec3 v = body.linear_velocity + cross(body.angular_velocity, point - body.center);
    if (shape.material.surface_velocity != Vec3{})
        v += rotate(body.pose.rotation, shape.material.surface_velocity);
    return v;
}

// Adds the centre of a manifold. For a moving body, also adds each point, because one end of the
// manifold may approach while the centre does not.
void add_manifold(const ContactManifold& manifold, const BodyState& body, const ShapeState& shape,
                  std::vector<Contact>& out) {
    Contact middle{.normal = -manifold.normal,
                   .gap = manifold.points.front().gap,
                   .point = {},
                   .body = body.id,
                   .shape = shape.id,
                   .velocity = {},
                   .dynamic = body.type == BodyType::dynamic,
                   .pushed = false};
    for (const auto& point : manifold.points) {
        middle.gap = minimum(middle.gap, point.gap);
        middle.point += point.position * (1.0 / static_cast<double>(manifold.points.size()));
    }
    middle.velocity = velocity_of(body, shape, middle.point);
    out.push_back(middle);
    if (!middle.dynamic || manifold.points.size() == 1) return;
    for (const auto& point : manifold.points) {
        Contact end = middle;
        end.gap = point.gap;
        end.point = point.position;
        end.velocity = velocity_of(body, shape, end.point);
        out.push_back(end);
    }
}

void add_contacts(const World& world, ShapeId id, const Capsule& capsule, Vec3 center, double reach,
                  std::vector<Contact>& out) {
    const Result<ShapeState> shape = world.shape(id);
    if (!shape.ok()) return;
    const Result<BodyState> body = world.body(shape->body);
    if (!body.ok()) return;
    const auto manifolds = collide_shapes(capsule, {center, {}}, shape->geometry,
                                          compose(body->pose, shape->pose), reach);
    if (!manifolds.ok()) return;
    for (const ContactManifold& manifold : *manifolds) add_manifold(manifold, *body, *shape, out);
}

}  // namespace

std::vector<Contact> EnvironmentQuery::contacts(const Capsule& capsule, Vec3 center,
                                                double reach) const {
    std::vector<Contact> found;
    const auto shapes = world.queries().overlap_box(box_around(capsule, center, reach), filter);
    if (!shapes.ok()) return found;
    for (const ShapeId shape : *shapes) add_contacts(world, shape, capsule, center, reach, found);
    std::stable_sort(found.begin(), found.end(),
                     [](const Contact& a, const Contact& b) { return a.gap < b.gap; });
    return found;
}

std::optional<ShapeCastHit> EnvironmentQuery::sweep(const Capsule& capsule, Vec3 center,
                                                    Vec3 motion) const {
    const auto hit = world.queries().cast_shape(
        {.geometry = capsule, .pose = {center, {}}, .motion = motion}, filter);
    return hit.ok() ? *hit : std::nullopt;
}

std::optional<ShapeCastHit> EnvironmentQuery::sweep_ignoring(const Capsule& capsule, Vec3 center,
                                                             Vec3 motion, BodyId body) const {
    const auto hits = world.queries().cast_shape_all(
        {.geometry = capsule, .pose = {center, {}}, .motion = motion}, filter);
    if (!hits.ok()) return std::nullopt;
    for (const ShapeCastHit& hit : *hits)
        if (hit.body != body) return hit;
    return std::nullopt;
}

Contact EnvironmentQuery::contact_at(const ShapeCastHit& hit, double gap) const {
    const Result<BodyState> body = world.body(hit.body);
    return {.normal = hit.normal,
            .gap = gap,
            .point = hit.point,
            .body = hit.body,
            .shape = hit.shape,
            .velocity = surface_velocity(world, hit.body, hit.shape, hit.point),
            .dynamic = body.ok() && body->type == BodyType::dynamic,
            .pushed = false};
}

bool EnvironmentQuery::is_free(const Capsule& capsule, Vec3 center) const {
    const auto shapes = world.queries().overlap_shape(capsule, {center, {}}, filter);
    return shapes.ok() && shapes->empty();
}

std::optional<RayHit> EnvironmentQuery::cast_ray(Vec3 from, Vec3 motion) const {
    const auto hit = world.queries().cast_ray({from, motion}, filter);
    return hit.ok() ? *hit : std::nullopt;
}

std::optional<Vec3> EnvironmentQuery::floor_behind(Vec3 edge, Vec3 normal) const {
    constexpr double behind = 0.01, above = 0.05;  // m
    const Vec3 inward = normalized(-horizontal(normal), Vec3{});
    const auto hit = cast_ray(edge + inward * behind + up * above, up * (-2 * above));
    if (!hit || hit->fraction <= 0) return std::nullopt;
    return hit->normal;
}

EnvironmentQuery make_environment_query(const World& world, const CharacterData& record) {
    return {world, {.categories = record.mask, .triggers = false, .ignore = record.body}};
}

Vec3 surface_velocity(const World& world, BodyId body, ShapeId shape, Vec3 point) {
    const Result<BodyState> moving = world.body(body);
    const Result<ShapeState> surface = world.shape(shape);
    if (!moving.ok() || !surface.ok()) return {};
    return velocity_of(*moving, *surface, point);
}

}  // namespace jostle::modules::character_detail
