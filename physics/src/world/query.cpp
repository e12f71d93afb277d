// SPDX-License-Identifier: MIT
//
// Ray casts and overlaps: the trees first, then the shapes.
#include <algorithm>

#include "collision/narrowphase/collide.h"
#include "geometry/bounds.h"
#include "geometry/ray.h"
#include "jostle/physics/tuning.h"
#include "jostle/physics/world.h"
#include "state/links.h"
#include "world/checks.h"

namespace jostle::physics {
namespace {

Placed placed_shape(const WorldState& world, std::uint32_t index) {
    const ShapeRecord& shape = world.shapes.shapes[index];
    return placed(shape, warm_of(world, shape.body));
}

std::vector<ShapeId> sorted_ids(const WorldState& world, std::vector<std::uint32_t> shapes) {
    std::sort(shapes.begin(), shapes.end());
    std::vector<ShapeId> ids;
    ids.reserve(shapes.size());
    for (const std::uint32_t shape : shapes) ids.push_back(shape_id(world, shape));
    return ids;
}

// Every shape whose fat box overlaps, and every plane that reaches into the box.
template <class Visit>
void visit_near(const WorldState& world, const Aabb& box, Visit&& visit) {
    world.shapes.fixed_tree.query(box, visit);
    world.shapes.moving_tree.query(box, visit);
    for (const std::uint32_t plane : world.shapes.planes)
        if (reaches_plane(world, world.shapes.shapes[plane], box)) visit(plane);
}

}  // namespace

Result<std::optional<RayHit>> World::cast_ray(const Ray& ray) const {
    if (Status s = check_vector("ray.origin", ray.origin, tuning::max_coordinate); !s.ok())
        return s.error();
    if (Status s = check_vector("ray.motion", ray.motion, tuning::max_coordinate); !s.ok())
        return s.error();
    if (ray.motion == Vec3{})
        return Error{ErrorCode::invalid_argument, "ray.motion is zero; it must have a length"};
    const WorldState& world = *state_;
    std::optional<ShapeRayHit> best;
    std::uint32_t best_shape = none;
    const auto visit = [&](std::uint32_t shape, double limit) {
        const auto hit = physics::cast_ray(placed_shape(world, shape), ray.origin, ray.motion);
        if (!hit) return limit;
        const bool closer = !best || hit->fraction < best->fraction ||
                            (hit->fraction == best->fraction && shape < best_shape);
        if (!closer) return limit;
        best = hit;
        best_shape = shape;
        return minimum(limit, hit->fraction);
    };
    world.shapes.fixed_tree.cast_ray(ray.origin, ray.motion, visit);
    world.shapes.moving_tree.cast_ray(ray.origin, ray.motion, visit);
    for (const std::uint32_t plane : world.shapes.planes) visit(plane, 1);
    if (!best) return std::optional<RayHit>{};
    return std::optional<RayHit>{
        RayHit{.shape = shape_id(world, best_shape),
               .body = body_id(world, world.shapes.shapes[best_shape].body),
               .fraction = best->fraction,
               .point = ray.origin + ray.motion * best->fraction,
               .normal = best->normal}};
}

Result<std::vector<ShapeId>> World::overlap_box(const Aabb& box) const {
    if (Status s = check_vector("box.low", box.low, tuning::max_coordinate); !s.ok())
        return s.error();
    if (Status s = check_vector("box.high", box.high, tuning::max_coordinate); !s.ok())
        return s.error();
    if (box.high.x < box.low.x || box.high.y < box.low.y || box.high.z < box.low.z)
        return Error{ErrorCode::invalid_argument,
                     "box.high is below box.low; give the lower corner first"};
    const WorldState& world = *state_;
    std::vector<std::uint32_t> found;
    visit_near(world, box, [&](std::uint32_t shape) {
        if (is_plane(world.shapes.shapes[shape]) ||
            overlap(bounds_of(placed_shape(world, shape)), box))
            found.push_back(shape);
    });
    return sorted_ids(world, std::move(found));
}

Result<std::vector<ShapeId>> World::overlap_shape(const Geometry& geometry,
                                                  const Transform& pose) const {
    if (Status s = check_geometry("geometry", geometry); !s.ok()) return s.error();
    if (Status s = check_pose("pose", pose); !s.ok()) return s.error();
    if (kind_of(geometry) == ShapeKind::plane)
        return Error{ErrorCode::invalid_argument,
                     "geometry is a plane; ask with a sphere, a capsule or a box"};
    const WorldState& world = *state_;
    const Placed probe = placed(geometry, {pose.position, unit(pose.rotation)});
    std::vector<std::uint32_t> found;
    visit_near(world, bounds_of(probe), [&](std::uint32_t shape) {
        AxisCache axis = no_axis;
        if (collide(probe, placed_shape(world, shape), 0, axis).count > 0) found.push_back(shape);
    });
    return sorted_ids(world, std::move(found));
}

}  // namespace jostle::physics
