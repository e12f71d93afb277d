// SPDX-License-Identifier: MIT
//
// Questions to a world that runs on a server: what does a ray hit, what overlaps a shape, what is
// nearest. Each call blocks for up to 5 s. An error carries the server's message. Any thread.
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

using Point = std::array<double, 3>;  // m, world; also for directions

struct QueryOptions {
    std::uint32_t categories = 0xffffffff;  // shapes whose category has a bit in here are seen
    bool triggers = false;                  // whether triggers are seen
    std::uint32_t ignore = 0;               // an entity that is not seen; 0: all are
    // When the world was as it is asked about (Client::rendered_time()); nothing: now.
    std::optional<v1::ViewTime> view_time = {};
};

struct RayHit {
    std::uint32_t entity = 0;
    std::uint32_t shape = 0;  // which of the entity's shapes, from 0
    double fraction = 0;      // of the motion, 0 to 1
    Point point{};
    Point normal{};  // unit, out of what was hit
};

struct ClosestPointHit {
    std::uint32_t entity = 0;
    double distance = 0;  // m; negative: the point is inside
    Point point{};        // on the surface
    Point normal{};       // unit, out of the shape
};

template <class Value>
struct QueryResult {
    Value value{};
    std::uint32_t tick =
        0;  // of the state that was asked: at most a few ticks old, or as of `seen`
    bool view_time_clamped = false;  // `seen` was too long ago: the oldest that the server had
};

class QueryClient {
public:
    // `world`: id or name; empty: the server's first.
    explicit QueryClient(const std::string& target, std::string world = {}, Security security = {});
    ~QueryClient();

    // The first thing that the ray from `origin` to `origin + motion` meets, if any.
    Result<QueryResult<std::optional<RayHit>>> cast_ray(Point origin, Point motion,
                                                        const QueryOptions& options = {});
    // Entities that overlap a convex shape where it stands, or hold a point. In rising order.
    Result<QueryResult<std::vector<std::uint32_t>>> overlap(const v1::Shape& shape,
                                                            const QueryOptions& options = {});
    Result<QueryResult<std::vector<std::uint32_t>>> overlap(Point point,
                                                            const QueryOptions& options = {});
    // The nearest surface within `max_distance` (m) of the point, if any.
    Result<QueryResult<std::optional<ClosestPointHit>>> closest_point(
        Point point, double max_distance, const QueryOptions& options = {});

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace jostle::client
