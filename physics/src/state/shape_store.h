// SPDX-License-Identifier: MIT
//
// Shapes and their broad-phase trees. One tree contains static shapes, the other one all moving
// shapes; planes are infinite and have a separate list.
#pragma once

#include <cstdint>
#include <vector>

#include "jostle/physics/defs.h"
#include "jostle/physics/ids.h"
#include "physics/src/collision/broadphase/broad_phase.h"
#include "physics/src/foundation/id_pool.h"
#include "physics/src/geometry/transformed_shape.h"
#include "physics/src/state/body_store.h"

namespace jostle::physics {

struct ShapeRecord {
    Geometry geometry;
    Transform pose;  // in the body's local frame
    Material material;
    double density = 0;  // kg/m^3
    double mass = 0;     // kg; replaces the density if above 0
    Filter filter;
    bool trigger = false;
    bool report_stays = false;
    std::uint64_t user_data = 0;
    std::uint32_t body = none;
    std::uint32_t next = none;  // next shape of the same body
    Aabb fat;                   // bounds plus margin; unused by planes
    bool moved = false;         // in ShapeStore::moved: its pairs are requested

    // Derived, not saved.
    Vec3 offset;             // of the shape's origin from the centre of mass, body axes
    Mat3 axes;               // to_matrix(pose.rotation)
    bool aligned = true;     // axes is the identity
    std::int32_t leaf = -1;  // proxy in its broad phase
};

struct ShapeStore {
    IdPool ids;
    std::vector<ShapeRecord> shapes;  // by index
    std::vector<std::uint32_t>
        moved;  // shapes that are new or left their fat box, in order of index after sorting
    std::vector<std::uint32_t> planes;    // indices, ascending; derived
    std::vector<std::uint32_t> triggers;  // indices, ascending; derived
    std::uint32_t reporters = 0;          // shapes with report_stays; derived
    // Broad phases of static and of moving shapes. Derived.
    OwnedBroadPhase statics = make_broad_phase(BroadPhase::dynamic_tree),
                    moving = make_broad_phase(BroadPhase::dynamic_tree);
};

inline ShapeId shape_id(const ShapeStore& shapes, std::uint32_t shape) {
    return {shape, shapes.ids.generation(shape)};
}

inline bool is_plane(const ShapeRecord& shape) {
    return kind_of(shape.geometry) == ShapeKind::plane;
}

// The shape with its world pose.
inline TransformedShape transformed_shape(const ShapeRecord& shape, const BodyWarm& warm) {
    return {&shape.geometry, warm.center + warm.axes * shape.offset,
            shape.aligned ? warm.axes : warm.axes * shape.axes};
}

}  // namespace jostle::physics
