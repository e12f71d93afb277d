// SPDX-License-Identifier: MIT
//
// Questions to a world between steps, or to a copy of one. Answers do not depend on the broad
// phase: ties go to the lower id. Positions, motions and distances are in metres, each component
// within 1e7 (limits.h).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "jostle/physics/aabb.h"
#include "jostle/physics/geometry.h"
#include "jostle/physics/ids.h"
#include "jostle/physics/result.h"
#include "jostle/physics/transform.h"

namespace jostle::physics {

// Which shapes a query sees.
struct QueryFilter {
    std::uint32_t categories = 0xffffffff;  // shapes whose Filter::category has a bit in here
    bool triggers = false;                  // whether triggers are seen
    BodyId ignore = {};                     // a body that is not seen; null: all are
};

struct Ray {
    Vec3 origin = {};  // m
    Vec3 motion = {};  // m, not zero: the ray ends at origin + motion
};

struct RayHit {
    ShapeId shape = {};
    BodyId body = {};
    double fraction = 0;  // 0..1 of the motion; 0 when the origin is inside the shape
    Vec3 point = {};      // m, world
    Vec3 normal = {};  // unit, out of the shape; opposite to the motion when the origin is inside
};

// A convex shape that moves without turning.
struct ShapeCast {
    Geometry geometry = {};  // convex
    Transform pose = {};     // where it starts
    Vec3 motion = {};        // m; may be zero
};

struct ShapeCastHit {
    ShapeId shape = {};
    BodyId body = {};
    double fraction = 0;  // 0..1 of the motion when they touch; 0 when they overlap at the start
    Vec3 point = {};      // m, world: where they touch
    Vec3 normal = {};     // unit, out of the shape that was hit
};

struct ClosestPoint {
    ShapeId shape = {};
    BodyId body = {};
    double distance = 0;  // m; negative inside a solid shape: the shortest way out
    Vec3 point = {};      // m, world, on the shape's surface
    Vec3 normal = {};     // unit, out of the shape
};

// Where a shape of the world stands, or stood.
struct ShapePlacement {
    ShapeId shape = {};
    Transform pose = {};  // of the shape, in the world
};

// How two shapes stand to each other.
struct ShapeDistance {
    double distance = 0;  // m; negative: the depth of the overlap, the shortest way to part them
    Vec3 normal = {};     // unit, from a to b
    Vec3 point_a = {}, point_b = {};  // m, world, on the surfaces; the closest or the deepest pair
};

// The points where two shapes touch, as the solver gets them: 1 to 4.
struct ContactManifold {
    Vec3 normal = {};  // unit, from a to b
    struct Point {
        Vec3 position;   // m, world, halfway between the surfaces
        double gap = 0;  // m along the normal; negative: overlap
    };
    std::vector<Point> points;
};

// The signed distance of two solids: convex kinds and planes, but not two planes.
Result<ShapeDistance> distance(const Geometry& a, const Transform& pose_a, const Geometry& b,
                               const Transform& pose_b);

// What the narrow phase finds for any two kinds: a manifold for each flat piece of a mesh or height
// field and each child of a compound, else one or none. Points further apart than `margin` (m, 0 to
// 1e6) are left out.
Result<std::vector<ContactManifold>> collide_shapes(const Geometry& a, const Transform& pose_a,
                                                    const Geometry& b, const Transform& pose_b,
                                                    double margin);

class QuerySource;

// Queries on one moment of a world: on the world itself (World::queries, good until the world
// changes or ends) or on a copy of it (World::query_frame, good for ever). Many threads may ask at
// once. Each call checks its arguments; an Error names the one that was wrong, of several questions
// with its number.
class Queries {
public:
    explicit Queries(std::shared_ptr<const QuerySource> source);

    // World::step_count() of this moment.
    std::uint64_t step() const;

    // The same questions to these shapes alone, where the list puts them: as a world was a moment
    // ago, say. Those that are gone are left out, one that is named twice is there twice. Good for
    // as long as this is. Costs about as much as naming them: half a millisecond for a thousand.
    Result<Queries> with_shapes_at(std::vector<ShapePlacement> shapes) const;

    // The first shape along the ray; nothing when it meets none.
    Result<std::optional<RayHit>> cast_ray(const Ray& ray, const QueryFilter& filter = {}) const;
    // Whether the ray meets any shape. Cheaper: it ends at the first that is found.
    Result<bool> ray_hits_any(const Ray& ray, const QueryFilter& filter = {}) const;
    // Every shape along the ray, each once where it is entered, by fraction, then by id.
    Result<std::vector<RayHit>> cast_ray_all(const Ray& ray, const QueryFilter& filter = {}) const;
    // One answer per ray, in their order.
    Result<std::vector<std::optional<RayHit>>> cast_rays(std::span<const Ray> rays,
                                                         const QueryFilter& filter = {}) const;

    // The first shape that the moving one touches.
    Result<std::optional<ShapeCastHit>> cast_shape(const ShapeCast& cast,
                                                   const QueryFilter& filter = {}) const;
    // Every shape that it touches, each once, by fraction, then by id.
    Result<std::vector<ShapeCastHit>> cast_shape_all(const ShapeCast& cast,
                                                     const QueryFilter& filter = {}) const;
    // One answer per cast, in their order.
    Result<std::vector<std::optional<ShapeCastHit>>> cast_shapes(
        std::span<const ShapeCast> casts, const QueryFilter& filter = {}) const;

    // Shapes whose bounding boxes overlap the box, by id. The shapes themselves may miss it.
    Result<std::vector<ShapeId>> overlap_box(const Aabb& box, const QueryFilter& filter = {}) const;
    // Shapes that a convex shape in that pose overlaps, by id.
    Result<std::vector<ShapeId>> overlap_shape(const Geometry& geometry, const Transform& pose,
                                               const QueryFilter& filter = {}) const;
    // Shapes that hold the point, by id. Meshes and height fields are surfaces and hold none.
    Result<std::vector<ShapeId>> shapes_at(Vec3 point, const QueryFilter& filter = {}) const;
    // The nearest shape within max_distance of the point, if any.
    Result<std::optional<ClosestPoint>> closest_point(Vec3 point, double max_distance,
                                                      const QueryFilter& filter = {}) const;
    // One answer per point, in their order.
    Result<std::vector<std::optional<ClosestPoint>>> closest_points(
        std::span<const Vec3> points, double max_distance, const QueryFilter& filter = {}) const;

private:
    std::shared_ptr<const QuerySource> source_;
};

}  // namespace jostle::physics
