// SPDX-License-Identifier: MIT
//
// Where shapes are and how far they may go: the boxes by which pairs are found, and when they must
// be made anew.
#pragma once

#include "physics/src/state/world_state.h"

namespace jostle::physics {

// Recomputes what is derived from the shape's pose in its body.
void derive_shape_pose(const BodyCold& cold, ShapeRecord& shape);
// Puts a new shape into its tree (or the plane list) and asks for its pairs.
void create_proxy(WorldState& world, std::uint32_t shape);
void destroy_proxy(WorldState& world, std::uint32_t shape);
// Its pairs are checked for in the next step.
void buffer_move(WorldState& world, std::uint32_t shape);
// The shape's new fat box, which looks ahead along the body's velocity, without telling the trees:
// for many threads.
void enlarge_aabb(WorldState& world, std::uint32_t shape, const BodyWarm& warm, double dt);
// ... with telling them, and asks for its pairs.
void enlarge_proxy(WorldState& world, std::uint32_t shape, const BodyWarm& warm, double dt);
// How far inside its fat box the shape is, m; negative: outside by that. `radius`: of its body.
struct AabbMargin {
    double now;
    double next;  // when the body's velocity has taken it through the next step
};
AabbMargin margin_in_fat_aabb(const ShapeRecord& shape, const BodyWarm& warm, double radius,
                              double dt);
// Whether the shape is in its fat box now and after the next step: pairs are found before it moves.
bool fits_fat_aabb(const ShapeRecord& shape, const BodyWarm& warm, double radius, double dt);
// Whether any corner of the box is below the plane.
bool reaches_plane(const WorldState& world, const ShapeRecord& plane, const Aabb& box);
// How far the body's points may go in a step of dt.
void update_motion_bound(WorldState& world, std::uint32_t body, double dt);

}  // namespace jostle::physics
