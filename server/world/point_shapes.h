// SPDX-License-Identifier: MIT
//
// Point objects as shapes, so that queries and aims find ropes, hair and cloth, now or at a time in
// the past: links of strands are capsules, grids and triangles are surfaces. Loose points and
// heights have no shape. Any thread.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "jostle/physics/queries.h"
#include "server/world/point_objects.h"

namespace jostle::server {

// The points of an object that has a shape.
struct PlacedPoints {
    std::shared_ptr<const PointObjectDescription> object;
    std::vector<physics::Vec3> positions;  // m, world
};

// The pose of an entity; nothing: it does not exist.
using PoseOfEntity = std::function<std::optional<physics::Transform>(EntityId)>;

bool has_shape(const PointObjectDescription& object);

// Objects with shapes whose spheres pass the filter, at the positions that clients receive.
using SphereFilter = std::function<bool(physics::Vec3 center, double radius)>;
std::vector<PlacedPoints> place_points(const PointObjects& objects, const PoseOfEntity& pose_of,
                                       const SphereFilter& filter);

// Moves the points towards those of a later state, as clients interpolate them. Objects that ended
// or changed their number of points stay.
void interpolate_points(std::vector<PlacedPoints>& points, const std::vector<PlacedPoints>& later,
                        double fraction);

// The first intersection of a ray with points.
struct PointHit {
    std::shared_ptr<const PointObjectDescription> object;
    std::size_t element = 0;        // the nearest point of the object
    physics::Vec3 element_at = {};  // m, its position
    double fraction = 0;            // of the motion of the ray
};
std::optional<PointHit> cast_ray(const std::vector<PlacedPoints>& points, const physics::Ray& ray);

// Queries on shapes of points.
class PointShapes {
public:
    explicit PointShapes(const std::vector<PlacedPoints>& points);

    const physics::Queries& queries() const { return *queries_; }
    // The id of the point object.
    std::uint32_t object_of(physics::ShapeId shape) const;

private:
    std::optional<physics::Queries> queries_;
    std::vector<std::uint32_t> object_of_;  // by index of the shape
};

// Shapes that are built when they are first needed. Copies start without.
class LazyPointShapes {
public:
    LazyPointShapes() = default;
    LazyPointShapes(const LazyPointShapes&) {}
    LazyPointShapes& operator=(const LazyPointShapes&) = delete;

    template <class Build>
    const std::shared_ptr<const PointShapes>& get(Build&& build) const {
        std::call_once(once_, [&] { shapes_ = build(); });
        return shapes_;
    }

private:
    mutable std::once_flag once_;
    mutable std::shared_ptr<const PointShapes> shapes_;
};

}  // namespace jostle::server
