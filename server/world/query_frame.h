// SPDX-License-Identifier: MIT
//
// A copy of a world that questions are answered from, on any thread, while the world ticks on.
// Made by the world's thread while somebody asks (host/query_broker), with only those parts that
// were asked for.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "server/world/frame.h"

namespace jostle::server {

// Bits: what of a world is copied.
using CopyLayers = std::uint32_t;
inline constexpr CopyLayers copy_shapes = 1;  // what rays, casts, overlaps and distances need
inline constexpr CopyLayers copy_contacts = 2, copy_islands = 4, copy_bounds = 8, copy_joints = 16,
                            copy_broad_phase = 32;
inline constexpr int copy_layer_count = 6;

inline constexpr std::size_t debug_items_max = 20000;  // of a kind

struct DebugContact {
    physics::Vec3 point, normal;
    double gap = 0, impulse = 0;  // m, N s
    bool touching = false;
};
struct DebugIsland {
    std::vector<EntityId> entities;  // rising
    bool asleep = false;
};
struct DebugJoint {
    EntityId entity_a = 0, entity_b = 0;
    physics::Vec3 anchor_a, anchor_b;  // m, world
    const char* kind = "";
};

// Which entity a shape belongs to, and which of its shapes it is.
struct ShapeOwner {
    EntityId entity = 0;
    std::uint32_t number = 0;
};
using ShapeOwners = std::vector<ShapeOwner>;  // by index of the shape

struct QueryFrame {
    std::uint32_t tick = 0;
    CopyLayers layers = 0;
    std::shared_ptr<const EntityList> entity_list;
    std::shared_ptr<const ShapeOwners> shape_owners;  // shared like the entity list, and as long
    std::optional<physics::Queries> queries;          // with copy_shapes

    std::vector<DebugContact> contacts;
    std::vector<DebugIsland> islands;
    std::vector<physics::Aabb> bounds, cells;
    std::vector<DebugJoint> joints;
    CopyLayers truncated = 0;  // of which kinds there was more than debug_items_max

    ShapeOwner owner_of(physics::ShapeId shape) const { return (*shape_owners)[shape.index]; }
    // A null id when there is no such entity.
    physics::BodyId body_of(EntityId entity) const;
};

using QueryFramePtr = std::shared_ptr<const QueryFrame>;

ShapeOwners shape_owners_in(const EntityList& entity_list);

// Fills what the parts ask for; entity list and places are set. `entity_of_body`: by index of the
// body.
void copy_layers(QueryFrame& frame, const physics::World& world,
                 const std::vector<EntityId>& entity_of_body);

}  // namespace jostle::server
