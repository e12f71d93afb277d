// SPDX-License-Identifier: MIT
//
// Spatial queries: a broad-phase query, then tests of the shapes.
#include <algorithm>

#include "jostle/physics/limits.h"
#include "physics/src/collision/narrowphase/collide.h"
#include "physics/src/collision/narrowphase/collide_composite.h"
#include "physics/src/collision/narrowphase/shape_distance.h"
#include "physics/src/collision/narrowphase/sweep_surface.h"
#include "physics/src/collision/narrowphase/time_of_impact.h"
#include "physics/src/foundation/uninitialized_array.h"
#include "physics/src/geometry/ray.h"
#include "physics/src/geometry/shape_measures.h"
#include "physics/src/world/checks.h"
#include "physics/src/world/query_source.h"

namespace jostle::physics {
namespace {

bool sees(const QueryFilter& filter, const QueryShape& shape) {
    if ((shape.filter.category & filter.categories) == 0) return false;
    if (shape.trigger && !filter.triggers) return false;
    return is_null(filter.ignore) || shape.body != filter.ignore;
}

bool reaches(const TransformedShape& plane, const Aabb& box) {
    const Vec3 n = plane.axes * std::get<Plane>(*plane.geometry).normal;
    const Vec3 lowest{n.x > 0 ? box.low.x : box.high.x, n.y > 0 ? box.low.y : box.high.y,
                      n.z > 0 ? box.low.z : box.high.z};
    return dot(lowest - plane.position, n) <= 0;
}

// Returns every shape near the box that passes the filter, sorted by index.
std::vector<QueryShape> shapes_near(const QuerySource& source, const Aabb& box,
                                    const QueryFilter& filter) {
    std::vector<std::uint32_t> found;
    found.reserve(16);
    source.query(box, filter.categories, found);
    for (const std::uint32_t plane : source.planes())
        if (reaches(source.shape(plane).transformed_shape, box)) found.push_back(plane);
    std::sort(found.begin(), found.end());
    std::vector<QueryShape> shapes;
    shapes.reserve(found.size());
    for (const std::uint32_t index : found) {
        const QueryShape shape = source.shape(index);
        if (sees(filter, shape)) shapes.push_back(shape);
    }
    return shapes;
}

Status check_ray(const Ray& ray) {
    if (Status s = check_vector("ray.origin", ray.origin, limits::max_coordinate); !s.ok())
        return s;
    if (Status s = check_vector("ray.motion", ray.motion, limits::max_coordinate); !s.ok())
        return s;
    if (ray.motion == Vec3{})
        return Error{ErrorCode::invalid_argument, "ray.motion is zero; it must not be zero"};
    return {};
}

Status check_probe(const char* name, const Geometry& geometry) {
    if (Status s = check_geometry(name, geometry); !s.ok()) return s;
    if (is_convex(kind_of(geometry))) return {};
    return Error{ErrorCode::invalid_argument,
                 std::string(name) + " is a " + kind_name(kind_of(geometry)) +
                     "; it must be a sphere, capsule, box, cylinder, cone or hull"};
}

RayHit hit_of(const QueryShape& shape, const Ray& ray, const ShapeRayHit& hit) {
    return {.shape = shape.shape,
            .body = shape.body,
            .fraction = hit.fraction,
            .point = ray.origin + ray.motion * hit.fraction,
            .normal = hit.normal};
}

// Calls visit(shape, hit, limit), which returns the new limit, for every shape that the ray hits.
template <class Visit>
void along_ray(const QuerySource& source, const Ray& ray, const QueryFilter& filter,
               Visit&& visit) {
    const auto test = [&](std::uint32_t index, double limit) {
        const QueryShape shape = source.shape(index);
        if (!sees(filter, shape)) return limit;
        const auto hit = physics::cast_ray(shape.transformed_shape, ray.origin, ray.motion);
        return hit ? visit(shape, *hit, limit) : limit;
    };
    source.cast_ray(ray.origin, ray.motion, filter.categories, test);
    for (const std::uint32_t plane : source.planes()) test(plane, 1);
}

std::optional<RayHit> first_hit(const QuerySource& source, const Ray& ray,
                                const QueryFilter& filter) {
    std::optional<RayHit> best;
    along_ray(source, ray, filter,
              [&](const QueryShape& shape, const ShapeRayHit& hit, double limit) {
                  const bool closer = !best || hit.fraction < best->fraction ||
                                      (hit.fraction == best->fraction && shape.shape < best->shape);
                  if (!closer) return limit;
                  best = hit_of(shape, ray, hit);
                  return minimum(limit, hit.fraction);
              });
    return best;
}

Status check_cast(const ShapeCast& cast) {
    if (Status s = check_probe("cast.geometry", cast.geometry); !s.ok()) return s;
    if (Status s = check_pose("cast.pose", cast.pose); !s.ok()) return s;
    return check_vector("cast.motion", cast.motion, limits::max_coordinate);
}

// Computes the contact point and normal after the moving shape has reached `moved`.
void find_contact(const TransformedShape& moved, const TransformedShape& still, Vec3 motion,
                  double gap, ShapeCastHit& hit) {
    if (!is_composite(kind_of(*still.geometry))) {
        PairCache cache;
        const SignedDistance d = signed_distance(moved, still, cache);
        hit.point = d.on_b;
        hit.normal = -d.normal;
        return;
    }
    std::vector<ChildManifold> parts;
    collide_composite(moved, still, 10 * gap, parts);
    const Manifold* best = nullptr;
    for (const ChildManifold& part : parts)
        if (best == nullptr || part.manifold.distance < best->distance) best = &part.manifold;
    hit.normal = best != nullptr ? -best->normal : normalized(-motion);
    hit.point = best != nullptr ? best->point[0] : moved.position;
}

// Casts a shape against a plane: the deepest point of the shape touches first.
std::optional<ShapeCastHit> touch_of_plane(const TransformedShape& probe, Vec3 motion, double gap,
                                           const TransformedShape& plane) {
    const Vec3 n = plane.axes * std::get<Plane>(*plane.geometry).normal;
    const Convex shape = convex_of(probe, plane.position);
    const Vec3 deepest = support(shape, -n) - n * shape.radius;
    const double apart = dot(deepest, n), speed = -dot(motion, n);
    double fraction = 0;
    if (apart > 2 * gap) {
        if (apart - gap > speed) return std::nullopt;
        fraction = (apart - gap) / speed;
    }
    const Vec3 moved = deepest + motion * fraction;
    return ShapeCastHit{
        .fraction = fraction, .point = plane.position + moved - n * dot(moved, n), .normal = n};
}

// Returns the fraction at which the moving shape first touches another shape; 0 if they touch at
// the start.
std::optional<double> touches_at(const ShapeCast& cast, const TransformedShape& probe,
                                 const TransformedShape& still, double size, double gap) {
    if (shapes_overlap(probe, still)) return 0;
    const SweptShape moving{
        .geometry = &cast.geometry,
        .offset = {},
        .axes = {},
        .radius = size,
        .sweep = {0, cast.pose.position, unit(cast.pose.rotation), cast.motion, {}}};
    const SweptShape resting{.geometry = still.geometry,
                             .offset = {},
                             .axes = still.axes,
                             .radius = radius_of(*still.geometry),
                             .sweep = {0, still.position, {}, {}, {}}};
    const Impact impact = time_of_impact(moving, resting, 0, gap);
    if (impact.at_start) return 0;
    if (impact.fraction > 1) return std::nullopt;
    return impact.fraction;
}

// Casts a shape against one shape of the world.
std::optional<ShapeCastHit> touch_of(const ShapeCast& cast, const TransformedShape& probe,
                                     const QueryShape& shape) {
    const double size = radius_of(cast.geometry), gap = 1e-6 * size;
    const ShapeKind kind = kind_of(*shape.transformed_shape.geometry);
    ShapeCastHit hit{.shape = shape.shape, .body = shape.body};
    if (kind == ShapeKind::plane) {
        auto touch = touch_of_plane(probe, cast.motion, gap, shape.transformed_shape);
        if (!touch) return std::nullopt;
        touch->shape = shape.shape;
        touch->body = shape.body;
        return touch;
    }
    if (kind == ShapeKind::mesh || kind == ShapeKind::height_field) {
        const auto touch = sweep_to_surface(shape.transformed_shape, probe, cast.motion, gap);
        if (!touch) return std::nullopt;
        hit.fraction = touch->fraction;
        hit.point = touch->point;
        hit.normal = touch->normal;
        if (touch->settled) return hit;
    } else {
        const auto fraction = touches_at(cast, probe, shape.transformed_shape, size, gap);
        if (!fraction) return std::nullopt;
        hit.fraction = *fraction;
    }
    TransformedShape moved = probe;
    moved.position += cast.motion * hit.fraction;
    find_contact(moved, shape.transformed_shape, cast.motion, gap, hit);
    return hit;
}

TransformedShape probe_of(const ShapeCast& cast) {
    return transformed_shape(cast.geometry, {cast.pose.position, unit(cast.pose.rotation)});
}
Aabb sweep_of(const TransformedShape& probe, Vec3 motion) {
    const Aabb box = bounds_of(probe);
    return grow({box.low + min(motion, Vec3{}), box.high + max(motion, Vec3{})}, 1e-6);
}

std::vector<ShapeCastHit> all_touches(const QuerySource& source, const ShapeCast& cast,
                                      const QueryFilter& filter) {
    const TransformedShape probe = probe_of(cast);
    std::vector<ShapeCastHit> hits;
    for (const QueryShape& shape : shapes_near(source, sweep_of(probe, cast.motion), filter))
        if (const auto hit = touch_of(cast, probe, shape)) hits.push_back(*hit);
    std::sort(hits.begin(), hits.end(), [](const ShapeCastHit& x, const ShapeCastHit& y) {
        return x.fraction < y.fraction || (x.fraction == y.fraction && x.shape < y.shape);
    });
    return hits;
}

// Returns the first contact with the shapes for which may_touch() is true.
template <class MayTouch>
std::optional<ShapeCastHit> first_touch(std::span<const QueryShape> shapes, const ShapeCast& cast,
                                        const TransformedShape& probe, MayTouch&& may_touch) {
    std::optional<ShapeCastHit> best;
    for (const QueryShape& shape : shapes) {
        if (!may_touch(shape)) continue;
        const auto hit = touch_of(cast, probe, shape);
        // Ties: the lower id wins.
        if (hit && (!best || hit->fraction < best->fraction)) best = hit;
    }
    return best;
}

// ---- batches of casts, like those of the wheels of a car ----

// A batch shares one broad-phase query if its casts are close to each other.
constexpr std::size_t batch_max = 16;
// Area of the common box, relative to the sum of the individual boxes.
constexpr double batch_area = 8;

bool are_close(std::span<const Aabb> boxes, const Aabb& all) {
    double areas = 0;
    for (const Aabb& box : boxes) areas += half_area(box);
    return half_area(all) <= batch_area * areas;
}

// Skips shapes that are near the batch but not near this cast.
bool is_near(const QueryShape& shape, const Aabb& box) {
    const ShapeKind kind = kind_of(*shape.transformed_shape.geometry);
    if (kind == ShapeKind::plane) return reaches(shape.transformed_shape, box);
    // These have their own tree.
    if (kind == ShapeKind::mesh || kind == ShapeKind::height_field) return true;
    return overlap(grow(bounds_of(shape.transformed_shape),
                        1e-5 * radius_of(*shape.transformed_shape.geometry)),
                   box);
}

std::optional<ShapeCastHit> first_touch_alone(const QuerySource& source, const ShapeCast& cast,
                                              const QueryFilter& filter) {
    const TransformedShape probe = probe_of(cast);
    return first_touch(shapes_near(source, sweep_of(probe, cast.motion), filter), cast, probe,
                       [](const QueryShape&) { return true; });
}

// Casts at most batch_max shapes.
void first_touches(const QuerySource& source, std::span<const ShapeCast> casts,
                   const QueryFilter& filter, std::vector<std::optional<ShapeCastHit>>& hits) {
    UninitializedArray<TransformedShape, batch_max> probes;
    UninitializedArray<Aabb, batch_max> boxes;
    Aabb all;
    for (std::size_t k = 0; k < casts.size(); k++) {
        probes[k] = probe_of(casts[k]);
        boxes[k] = sweep_of(probes[k], casts[k].motion);
        all = k == 0 ? boxes[k] : unite(all, boxes[k]);
    }
    if (casts.size() < 2 || !are_close({boxes.data(), casts.size()}, all)) {
        for (const ShapeCast& cast : casts) hits.push_back(first_touch_alone(source, cast, filter));
        return;
    }
    const std::vector<QueryShape> shapes = shapes_near(source, all, filter);
    for (std::size_t k = 0; k < casts.size(); k++)
        hits.push_back(first_touch(shapes, casts[k], probes[k], [&](const QueryShape& shape) {
            return is_near(shape, boxes[k]);
        }));
}

std::optional<ClosestPoint> nearest(const QuerySource& source, Vec3 point, double max_distance,
                                    const QueryFilter& filter) {
    std::optional<ClosestPoint> best;
    const Vec3 reach{max_distance, max_distance, max_distance};
    for (const QueryShape& shape : shapes_near(source, {point - reach, point + reach}, filter)) {
        const SurfacePoint p = nearest_point(shape.transformed_shape, point);
        if (p.distance > max_distance || (best && p.distance >= best->distance)) continue;
        best = ClosestPoint{shape.shape, shape.body, p.distance, p.point, p.normal};
    }
    return best;
}

// Evaluates every query of a batch. Returns the results, or the first error with the index of its
// query.
template <class Hit, class Query, class Evaluate>
Result<std::vector<Hit>> each(std::span<const Query> queries, const char* name,
                              Evaluate&& evaluate) {
    std::vector<Hit> results;
    results.reserve(queries.size());
    for (std::size_t k = 0; k < queries.size(); k++) {
        Result<Hit> result = evaluate(queries[k]);
        if (!result.ok())
            return Error{result.error().code, std::string(name) + "[" + std::to_string(k) +
                                                  "]: " + result.error().message};
        results.push_back(*result);
    }
    return results;
}

}  // namespace

Queries::Queries(std::shared_ptr<const QuerySource> source) : source_(std::move(source)) {}

std::uint64_t Queries::step() const {
    return source_->step();
}

Result<std::optional<RayHit>> Queries::cast_ray(const Ray& ray, const QueryFilter& filter) const {
    if (Status s = check_ray(ray); !s.ok()) return s.error();
    return first_hit(*source_, ray, filter);
}

Result<bool> Queries::ray_hits_any(const Ray& ray, const QueryFilter& filter) const {
    if (Status s = check_ray(ray); !s.ok()) return s.error();
    bool any = false;
    // A negative limit ends the traversal.
    along_ray(*source_, ray, filter, [&](const QueryShape&, const ShapeRayHit&, double) {
        any = true;
        return -1.0;
    });
    return any;
}

Result<std::vector<RayHit>> Queries::cast_ray_all(const Ray& ray, const QueryFilter& filter) const {
    if (Status s = check_ray(ray); !s.ok()) return s.error();
    std::vector<RayHit> hits;
    along_ray(*source_, ray, filter,
              [&](const QueryShape& shape, const ShapeRayHit& hit, double limit) {
                  hits.push_back(hit_of(shape, ray, hit));
                  return limit;
              });
    std::sort(hits.begin(), hits.end(), [](const RayHit& x, const RayHit& y) {
        return x.fraction < y.fraction || (x.fraction == y.fraction && x.shape < y.shape);
    });
    return hits;
}

Result<std::vector<std::optional<RayHit>>> Queries::cast_rays(std::span<const Ray> rays,
                                                              const QueryFilter& filter) const {
    return each<std::optional<RayHit>>(rays, "rays",
                                       [&](const Ray& ray) { return cast_ray(ray, filter); });
}

Result<std::optional<ShapeCastHit>> Queries::cast_shape(const ShapeCast& cast,
                                                        const QueryFilter& filter) const {
    if (Status s = check_cast(cast); !s.ok()) return s.error();
    return first_touch_alone(*source_, cast, filter);
}

Result<std::vector<ShapeCastHit>> Queries::cast_shape_all(const ShapeCast& cast,
                                                          const QueryFilter& filter) const {
    if (Status s = check_cast(cast); !s.ok()) return s.error();
    return all_touches(*source_, cast, filter);
}

Result<std::vector<std::optional<ShapeCastHit>>> Queries::cast_shapes(
    std::span<const ShapeCast> casts, const QueryFilter& filter) const {
    for (std::size_t k = 0; k < casts.size(); k++)
        if (Status s = check_cast(casts[k]); !s.ok())
            return Error{s.error().code, "casts[" + std::to_string(k) + "]: " + s.error().message};
    std::vector<std::optional<ShapeCastHit>> hits;
    hits.reserve(casts.size());
    for (std::size_t k = 0; k < casts.size(); k += batch_max)
        first_touches(*source_, casts.subspan(k, std::min(batch_max, casts.size() - k)), filter,
                      hits);
    return hits;
}

Result<std::vector<ShapeId>> Queries::overlap_box(const Aabb& box,
                                                  const QueryFilter& filter) const {
    if (Status s = check_vector("box.low", box.low, limits::max_coordinate); !s.ok())
        return s.error();
    if (Status s = check_vector("box.high", box.high, limits::max_coordinate); !s.ok())
        return s.error();
    if (box.high.x < box.low.x || box.high.y < box.low.y || box.high.z < box.low.z)
        return Error{ErrorCode::invalid_argument,
                     "box.high is below box.low; box.low must be the lower corner"};
    std::vector<ShapeId> ids;
    for (const QueryShape& shape : shapes_near(*source_, box, filter))
        if (kind_of(*shape.transformed_shape.geometry) == ShapeKind::plane ||
            overlap(bounds_of(shape.transformed_shape), box))
            ids.push_back(shape.shape);
    return ids;
}

Result<std::vector<ShapeId>> Queries::overlap_shape(const Geometry& geometry, const Transform& pose,
                                                    const QueryFilter& filter) const {
    if (Status s = check_probe("geometry", geometry); !s.ok()) return s.error();
    if (Status s = check_pose("pose", pose); !s.ok()) return s.error();
    const TransformedShape probe =
        transformed_shape(geometry, {pose.position, unit(pose.rotation)});
    std::vector<ShapeId> ids;
    for (const QueryShape& shape : shapes_near(*source_, bounds_of(probe), filter))
        if (shapes_overlap(probe, shape.transformed_shape)) ids.push_back(shape.shape);
    return ids;
}

Result<std::vector<ShapeId>> Queries::shapes_at(Vec3 point, const QueryFilter& filter) const {
    if (Status s = check_vector("point", point, limits::max_coordinate); !s.ok()) return s.error();
    std::vector<ShapeId> ids;
    for (const QueryShape& shape : shapes_near(*source_, {point, point}, filter)) {
        const ShapeKind kind = kind_of(*shape.transformed_shape.geometry);
        if (kind == ShapeKind::mesh || kind == ShapeKind::height_field) continue;
        if (nearest_point(shape.transformed_shape, point).distance <= 0) ids.push_back(shape.shape);
    }
    return ids;
}

Result<std::optional<ClosestPoint>> Queries::closest_point(Vec3 point, double max_distance,
                                                           const QueryFilter& filter) const {
    if (Status s = check_vector("point", point, limits::max_coordinate); !s.ok()) return s.error();
    if (Status s = check_range("max_distance", max_distance, 0, limits::max_coordinate); !s.ok())
        return s.error();
    return nearest(*source_, point, max_distance, filter);
}

Result<std::vector<std::optional<ClosestPoint>>> Queries::closest_points(
    std::span<const Vec3> points, double max_distance, const QueryFilter& filter) const {
    return each<std::optional<ClosestPoint>>(
        points, "points", [&](Vec3 point) { return closest_point(point, max_distance, filter); });
}

Result<ShapeDistance> distance(const Geometry& a, const Transform& pose_a, const Geometry& b,
                               const Transform& pose_b) {
    for (const auto& [name, geometry] : {std::pair("a", &a), std::pair("b", &b)}) {
        if (Status s = check_geometry(name, *geometry); !s.ok()) return s.error();
        if (!is_convex(kind_of(*geometry)) && kind_of(*geometry) != ShapeKind::plane)
            return Error{ErrorCode::invalid_argument,
                         std::string(name) + " is a " + kind_name(kind_of(*geometry)) +
                             "; distance() supports convex shapes and planes"};
    }
    if (kind_of(a) == ShapeKind::plane && kind_of(b) == ShapeKind::plane)
        return Error{ErrorCode::invalid_argument,
                     "a and b are both planes; at most one may be a plane"};
    if (Status s = check_pose("pose_a", pose_a); !s.ok()) return s.error();
    if (Status s = check_pose("pose_b", pose_b); !s.ok()) return s.error();
    const Geometry ga = stored(a), gb = stored(b);
    PairCache cache;
    const SignedDistance d =
        signed_distance(transformed_shape(ga, {pose_a.position, unit(pose_a.rotation)}),
                        transformed_shape(gb, {pose_b.position, unit(pose_b.rotation)}), cache);
    return ShapeDistance{d.distance, d.normal, d.on_a, d.on_b};
}

Result<std::vector<ContactManifold>> collide_shapes(const Geometry& a, const Transform& pose_a,
                                                    const Geometry& b, const Transform& pose_b,
                                                    double margin) {
    if (Status s = check_geometry("a", a); !s.ok()) return s.error();
    if (Status s = check_geometry("b", b); !s.ok()) return s.error();
    if (Status s = check_pose("pose_a", pose_a); !s.ok()) return s.error();
    if (Status s = check_pose("pose_b", pose_b); !s.ok()) return s.error();
    if (Status s = check_range("margin", margin, 0, 1e6); !s.ok()) return s.error();
    const Geometry ga = stored(a), gb = stored(b);
    const TransformedShape pa = transformed_shape(ga, {pose_a.position, unit(pose_a.rotation)}),
                           pb = transformed_shape(gb, {pose_b.position, unit(pose_b.rotation)});
    std::vector<ChildManifold> parts;
    if (is_composite(kind_of(a)) || is_composite(kind_of(b))) {
        collide_composite(pa, pb, margin, parts);
    } else {
        PairCache cache;
        parts.push_back({0, collide(pa, pb, margin, cache)});
    }
    std::vector<ContactManifold> manifolds;
    for (const ChildManifold& part : parts) {
        if (part.manifold.count == 0) continue;
        ContactManifold m{.normal = part.manifold.normal, .points = {}};
        for (int k = 0; k < part.manifold.count; k++)
            m.points.push_back({part.manifold.point[k], part.manifold.gap[k]});
        manifolds.push_back(std::move(m));
    }
    return manifolds;
}

}  // namespace jostle::physics
