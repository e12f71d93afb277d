// SPDX-License-Identifier: MIT
//
// Queries of a world on a server: ray casts, overlaps, closest points and inspections. Each call
// blocks for up to 5 s. Errors contain the server's message. Any thread.
//
//     client::QueryClient queries("localhost:50051", "sandbox");
//     const auto hit = queries.cast_ray({0, 10, 0}, {0, -20, 0});
//     if (hit.ok() && hit->value) std::printf("entity %u\n", hit->value->entity);
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "jostle/base/result.h"
#include "jostle/client/security.h"
#include "jostle/v1/query.pb.h"

namespace jostle::client {

using Point = std::array<double, 3>;  ///< m, world; also for directions

/// Options of a query.
struct QueryOptions {
    std::uint32_t categories = 0xffffffff;  ///< finds shapes whose category has a bit in this mask
    bool triggers = false;                  ///< also finds triggers
    bool deformables = false;               ///< also finds ropes and cloth
    std::uint32_t ignore = 0;               ///< an entity to skip; 0: none
    /// Lag compensation: evaluates the query against the poses of this time
    /// (Client::rendered_time()). Absent: the current state.
    std::optional<v1::ViewTime> view_time = {};
};

/// A hit of a ray.
struct RayHit {
    std::uint32_t entity = 0;  ///< 0: a rope or cloth was hit
    std::uint32_t object = 0;  ///< PointObject.id of the rope or cloth; 0: an entity was hit
    std::uint32_t shape = 0;   ///< index among the entity's shapes
    double fraction = 0;       ///< of the motion, 0 to 1
    Point point{};
    Point normal{};  ///< unit, pointing out of the shape
};

/// The objects that overlap a shape or contain a point.
struct Overlaps {
    std::vector<std::uint32_t> entities;  ///< ascending
    std::vector<std::uint32_t> objects;   ///< ropes and cloths (PointObject.id), ascending
};

/// The closest surface point.
struct ClosestPointHit {
    std::uint32_t entity = 0;  ///< 0: of a rope or cloth
    std::uint32_t object = 0;  ///< PointObject.id of the rope or cloth; 0: of an entity
    double distance = 0;       ///< m; negative: the point is inside
    Point point{};             ///< on the surface
    Point normal{};            ///< unit, pointing out of the shape
};

/// The value of a query and the state that it refers to.
template <class Value>
struct QueryResult {
    Value value{};
    /// Tick of the evaluated state: at most a few ticks old, or of the view time.
    std::uint32_t tick = 0;
    /// the view time was too old; the oldest stored frame was used
    bool view_time_clamped = false;
};

/// Blocking client of QueryService for one world.
class QueryClient {
public:
    /// `target`: host:port of the gRPC listener. `world`: id or name; empty: the first world of the
    /// server.
    explicit QueryClient(const std::string& target, std::string world = {}, Security security = {});
    ~QueryClient();

    /// Returns the closest hit of the ray from `origin` to `origin + motion`, if any.
    Result<QueryResult<std::optional<RayHit>>> cast_ray(Point origin, Point motion,
                                                        const QueryOptions& options = {});
    /// Returns what overlaps a convex shape, posed in the world.
    Result<QueryResult<Overlaps>> overlap(const v1::Shape& shape, const QueryOptions& options = {});
    /// Returns what contains a point.
    Result<QueryResult<Overlaps>> overlap(Point point, const QueryOptions& options = {});
    /// Returns the closest surface point within `max_distance` (m), if any.
    Result<QueryResult<std::optional<ClosestPointHit>>> closest_point(
        Point point, double max_distance, const QueryOptions& options = {});
    /// Returns the complete state of an entity.
    Result<QueryResult<v1::InspectedBody>> inspect_entity(std::uint32_t entity);
    /// Returns the complete state of a joint (JointInfo.id).
    Result<QueryResult<v1::InspectedJoint>> inspect_joint(std::uint32_t joint);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace jostle::client
