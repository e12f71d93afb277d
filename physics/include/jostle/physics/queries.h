// SPDX-License-Identifier: MIT
//
// Spatial queries: ray casts, shape casts, overlaps and closest points, on a world between steps or
// on a copy. Results do not depend on the broad phase: of equal results the one with the lower id
// is returned. Positions, motions and distances are in metres, each component within 1e7
// (limits.h).
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

/// Selects the shapes that a query tests.
struct QueryFilter {
    /// Bits; tests shapes whose Filter::category has one of them.
    std::uint32_t categories = 0xffffffff;
    bool triggers = false;  ///< whether triggers are tested
    BodyId ignore = {};     ///< shapes of this body are skipped; null: none
};

/// A ray: the segment from origin to origin + motion.
struct Ray {
    Vec3 origin = {};  ///< m
    Vec3 motion = {};  ///< m, not zero
};

/// The intersection of a ray with a shape.
struct RayHit {
    ShapeId shape = {};   ///< the shape that was hit
    BodyId body = {};     ///< its body
    double fraction = 0;  ///< of the motion, 0..1; 0 if the origin is inside the shape
    Vec3 point = {};      ///< m, world
    /// Unit vector out of the shape; opposite to the motion if the origin is inside the shape.
    Vec3 normal = {};
};

/// A convex shape that translates without rotation.
struct ShapeCast {
    Geometry geometry = {};  ///< must be convex (is_convex)
    Transform pose = {};     ///< start pose, world
    Vec3 motion = {};        ///< m; may be zero
};

/// The first contact of a cast shape with a shape of the world.
struct ShapeCastHit {
    ShapeId shape = {};   ///< the shape that was hit
    BodyId body = {};     ///< its body
    double fraction = 0;  ///< of the motion, 0..1; 0 if the shapes overlap at the start
    Vec3 point = {};      ///< m, world, point of contact
    Vec3 normal = {};     ///< unit vector out of the shape that was hit
};

/// The closest point on a shape.
struct ClosestPoint {
    ShapeId shape = {};   ///< the closest shape
    BodyId body = {};     ///< its body
    double distance = 0;  ///< m; negative inside a solid shape: minus the distance to its surface
    Vec3 point = {};      ///< m, world, on the surface of the shape
    Vec3 normal = {};     ///< unit vector out of the shape
};

/// The pose of a shape, as an override of its current pose (Queries::with_shapes_at).
struct ShapePlacement {
    ShapeId shape = {};   ///< the shape
    Transform pose = {};  ///< of the shape, world
};

/// The signed distance of two shapes.
struct ShapeDistance {
    double distance = 0;  ///< m; negative: minus the penetration depth
    Vec3 normal = {};     ///< unit vector from a to b
    /// Closest points, or deepest points if the shapes overlap, on the surfaces. m, world.
    Vec3 point_a = {}, point_b = {};
};

/// A contact manifold as the solver receives it: 1 to 4 points with a common normal.
struct ContactManifold {
    Vec3 normal = {};  ///< unit vector from a to b
    /// A contact point.
    struct Point {
        Vec3 position;   ///< m, world, midway between the surfaces
        double gap = 0;  ///< m along the normal; negative: overlap
    };
    std::vector<Point> points;  ///< 1 to 4 points
};

/// Computes the signed distance of two solid shapes: convex kinds and planes, but not two planes.
/// Thread-safe.
///
/// Errors: invalid_argument for other kinds, invalid geometry or invalid poses.
Result<ShapeDistance> distance(const Geometry& a, const Transform& pose_a, const Geometry& b,
                               const Transform& pose_b);

/// Runs the narrow phase for two shapes of any kind. Returns a manifold per flat piece of a mesh or
/// height field and per child of a compound, otherwise at most one. Points with a gap greater than
/// `margin` (m, 0 to 1e6) are dropped. Thread-safe.
///
/// Errors: invalid_argument for invalid geometry, poses or margin.
Result<std::vector<ContactManifold>> collide_shapes(const Geometry& a, const Transform& pose_a,
                                                    const Geometry& b, const Transform& pose_b,
                                                    double margin);

class QuerySource;

/// Spatial queries on one state of a world: on the world itself (World::queries, valid until the
/// world changes or is destroyed) or on a copy (World::query_frame, valid indefinitely).
///
/// Thread rule: any number of threads may call concurrently.
///
/// Error rule: every call checks its arguments and returns invalid_argument with the name of the
/// offending one; batch calls include its index.
class Queries {
public:
    /// Used by World.
    explicit Queries(std::shared_ptr<const QuerySource> source);

    /// Returns World::step_count() of this state.
    std::uint64_t step() const;

    /// Returns queries on the listed shapes only, at the listed poses, for example at earlier poses
    /// for lag compensation. Destroyed shapes are skipped; a shape that is listed twice is present
    /// twice. Valid as long as this object's state. Costs about 0.5 ms per 1000 shapes.
    Result<Queries> with_shapes_at(std::vector<ShapePlacement> shapes) const;

    /// Returns the first hit along the ray; nullopt if there is none.
    Result<std::optional<RayHit>> cast_ray(const Ray& ray, const QueryFilter& filter = {}) const;
    /// Returns whether the ray hits any shape. Cheaper than cast_ray(): it stops at the first hit
    /// found.
    Result<bool> ray_hits_any(const Ray& ray, const QueryFilter& filter = {}) const;
    /// Returns the entry point into every shape along the ray, sorted by fraction, then by id.
    Result<std::vector<RayHit>> cast_ray_all(const Ray& ray, const QueryFilter& filter = {}) const;
    /// Casts several rays. Returns one result per ray, in order.
    Result<std::vector<std::optional<RayHit>>> cast_rays(std::span<const Ray> rays,
                                                         const QueryFilter& filter = {}) const;

    /// Returns the first contact of the moving shape; nullopt if there is none.
    Result<std::optional<ShapeCastHit>> cast_shape(const ShapeCast& cast,
                                                   const QueryFilter& filter = {}) const;
    /// Returns the first contact with every shape along the motion, sorted by fraction, then by id.
    Result<std::vector<ShapeCastHit>> cast_shape_all(const ShapeCast& cast,
                                                     const QueryFilter& filter = {}) const;
    /// Casts several shapes. Returns one result per cast, in order. Casts close to each other share
    /// one broad-phase query.
    Result<std::vector<std::optional<ShapeCastHit>>> cast_shapes(
        std::span<const ShapeCast> casts, const QueryFilter& filter = {}) const;

    /// Returns the shapes whose bounding boxes overlap the box, sorted by id. The shapes themselves
    /// may not overlap it.
    Result<std::vector<ShapeId>> overlap_box(const Aabb& box, const QueryFilter& filter = {}) const;
    /// Returns the shapes that overlap a convex shape, sorted by id.
    Result<std::vector<ShapeId>> overlap_shape(const Geometry& geometry, const Transform& pose,
                                               const QueryFilter& filter = {}) const;
    /// Returns the shapes that contain the point, sorted by id. Meshes and height fields are
    /// surfaces and contain no points.
    Result<std::vector<ShapeId>> shapes_at(Vec3 point, const QueryFilter& filter = {}) const;
    /// Returns the closest shape within max_distance (m, 0 to 1e7) of the point; nullopt if there
    /// is none.
    Result<std::optional<ClosestPoint>> closest_point(Vec3 point, double max_distance,
                                                      const QueryFilter& filter = {}) const;
    /// Finds the closest shape of several points. Returns one result per point, in order.
    Result<std::vector<std::optional<ClosestPoint>>> closest_points(
        std::span<const Vec3> points, double max_distance, const QueryFilter& filter = {}) const;

private:
    std::shared_ptr<const QuerySource> source_;
};

}  // namespace jostle::physics
