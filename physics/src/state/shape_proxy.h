// SPDX-License-Identifier: MIT
//
// Broad-phase proxies of shapes: the boxes that find pairs, and when they must be updated.
#pragma once

#include "physics/src/state/world_state.h"

namespace jostle::physics {

// Recomputes the data derived from the shape's pose in its body.
void derive_shape_pose(const BodyCold& cold, ShapeRecord& shape);
// Adds a shape to its tree (or the plane list) and requests its pairs.
void create_proxy(ShapedBodies& stores, std::uint32_t shape);
// Removes the shape from its tree. Appends the pairs of triggers and shapes that end to `left`.
void destroy_proxy(ShapedBodies& stores, std::uint32_t shape, std::vector<TriggerEvent>& left);
// Requests the pairs of the shape in the next step.
void buffer_move(ShapeStore& shapes, TriggerStore& triggers, std::uint32_t shape);
// Computes the new fat box of the shape, extended along the body's velocity, without updating the
// trees. Thread-safe for different bodies.
void enlarge_aabb(BodyStore& bodies, ShapeStore& shapes, std::uint32_t shape, const BodyWarm& warm,
                  double dt);
// Same, updates the trees and requests the pairs.
void enlarge_proxy(ShapedBodies& stores, std::uint32_t shape, const BodyWarm& warm, double dt);
// Distance of the shape from the faces of its fat box, m; negative if it is outside. `radius`: of
// its body.
struct AabbMargin {
    double now;
    double next;  // after the next step at the current velocity
};
AabbMargin margin_in_fat_aabb(const ShapeRecord& shape, const BodyWarm& warm, double radius,
                              double dt);
// Returns whether the shape is inside its fat box now and after the next step, so that pairs are
// found before it moves.
bool fits_fat_aabb(const ShapeRecord& shape, const BodyWarm& warm, double radius, double dt);
// Returns whether any corner of the box is below the plane.
bool reaches_plane(const BodySets& sets, const ShapeRecord& plane, const Aabb& box);
// Updates the bound on the motion of the body's points in a step of dt.
void update_motion_bound(WorldState& world, std::uint32_t body, double dt);

}  // namespace jostle::physics
