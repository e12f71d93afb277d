// SPDX-License-Identifier: MIT
//
// A copy of a world for queries on any thread while the world continues to tick. The tick thread
// makes it on request (world/query_broker), with the requested layers only.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "jostle/base/check.h"
#include "server/world/frame.h"
#include "server/world/point_shapes.h"

namespace jostle::server {

// The parts of a world in a copy, as bits.
using CopyLayers = std::uint32_t;
inline constexpr CopyLayers copy_shapes = 1;  // for ray casts, shape casts, overlaps and distances
inline constexpr CopyLayers copy_contacts = 2, copy_islands = 4, copy_bounds = 8, copy_joints = 16,
                            copy_broad_phase = 32;
inline constexpr CopyLayers copy_points =
    64;  // point objects, for queries that find ropes and cloth
inline constexpr int copy_layer_count = 7;

inline constexpr std::size_t debug_items_max = 20000;  // per layer

struct DebugContact {
    physics::Vec3 point, normal;
    double gap = 0, impulse = 0;  // m, N s
    bool touching = false;
};
struct DebugIsland {
    std::vector<EntityId> entities;  // ascending
    bool asleep = false;
};
struct DebugJoint {
    EntityId entity_a = 0, entity_b = 0;
    physics::Vec3 anchor_a, anchor_b;  // m, world
    const char* kind = "";
};

// The entity of a shape and the shape's index within the entity.
struct ShapeOwner {
    EntityId entity = 0;
    std::uint32_t number = 0;
};
using ShapeOwners = std::vector<ShapeOwner>;  // by index of the shape

struct QueryFrame {
    std::uint32_t tick = 0;
    CopyLayers layers = 0;
    std::shared_ptr<const EntityList> entity_list;
    std::shared_ptr<const ShapeOwners> shape_owners;  // of entity_list
    std::optional<physics::Queries> queries;          // with copy_shapes
    std::shared_ptr<const PointObjects> points;       // with copy_points
    std::vector<EntityPose> carriers;                 // of the points, ascending

    std::vector<DebugContact> contacts;
    std::vector<DebugIsland> islands;
    std::vector<physics::Aabb> bounds, cells;
    std::vector<DebugJoint> joints;
    CopyLayers truncated = 0;  // layers with more than debug_items_max items

    ShapeOwner owner_of(physics::ShapeId shape) const {
        ASSERT(shape.index < shape_owners->size());
        return (*shape_owners)[shape.index];
    }
    // A null id if the entity does not exist.
    physics::BodyId body_of(EntityId entity) const;
    // The shapes of `points`, built by the first call. Any thread.
    const std::shared_ptr<const PointShapes>& point_shapes() const;

private:
    LazyPointShapes point_shapes_;
};

using QueryFramePtr = std::shared_ptr<const QueryFrame>;

ShapeOwners shape_owners_in(const EntityList& entity_list);

// Fills `frame.layers`; the entity list and the shape owners must be set. `entity_of_body` is
// indexed by body index.
void copy_layers(QueryFrame& frame, const physics::World& world,
                 const std::vector<EntityId>& entity_of_body);

}  // namespace jostle::server
