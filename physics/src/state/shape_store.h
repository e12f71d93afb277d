// SPDX-License-Identifier: MIT
//
// Shapes and the trees that find them. One tree holds what never moves, the other all else; planes
// are infinite and stand in a list of their own.
#pragma once

#include <cstdint>
#include <vector>

#include "jostle/physics/defs.h"
#include "physics/src/collision/broadphase/broad_phase.h"
#include "physics/src/foundation/id_pool.h"
#include "physics/src/geometry/transformed_shape.h"
#include "physics/src/state/body_store.h"

namespace jostle::physics {

struct ShapeRecord {
    Geometry geometry;
    Transform pose;  // in the body, as the user gave it
    Material material;
    double density = 0;  // kg/m^3
    double mass = 0;     // kg; above 0 it replaces the density
    Filter filter;
    bool trigger = false;
    bool report_stays = false;
    std::uint64_t user_data = 0;
    std::uint32_t body = none;
    std::uint32_t next = none;  // shape of the same body
    Aabb fat;                   // bounds plus margin; unused by planes
    bool moved = false;         // on ShapeStore::moved: its pairs are to be checked for

    // Derived, not saved.
    Vec3 offset;             // of the shape's origin from the centre of mass, body axes
    Mat3 axes;               // to_matrix(pose.rotation)
    bool aligned = true;     // axes is the identity
    std::int32_t leaf = -1;  // in its broad phase
};

struct ShapeStore {
    IdPool ids;
    std::vector<ShapeRecord> shapes;  // by index
    std::vector<std::uint32_t>
        moved;  // shapes that are new or left their fat box, in order of index after sorting
    std::vector<std::uint32_t> planes;    // indices, rising; derived
    std::vector<std::uint32_t> triggers;  // indices, rising; derived
    std::uint32_t reporters = 0;          // shapes with report_stays; derived
    // Where boxes are found: what never moves apart from all else. Derived.
    OwnedBroadPhase statics = make_broad_phase(BroadPhase::dynamic_tree),
                    moving = make_broad_phase(BroadPhase::dynamic_tree);
};

inline bool is_plane(const ShapeRecord& shape) {
    return kind_of(shape.geometry) == ShapeKind::plane;
}

// The shape in the world.
inline TransformedShape transformed_shape(const ShapeRecord& shape, const BodyWarm& warm) {
    return {&shape.geometry, warm.center + warm.axes * shape.offset,
            shape.aligned ? warm.axes : warm.axes * shape.axes};
}

}  // namespace jostle::physics
