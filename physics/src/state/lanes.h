// SPDX-License-Identifier: MIT
//
// Takes and gives back lanes of the manifold store, and keeps colours, lane counts and hot indices
// of the bodies in step. Called serially, in an order that does not depend on threads: lane order
// decides the bits of a solve.
#pragma once

#include "state/lane_rows.h"
#include "state/world_state.h"

namespace jostle::physics {

// Which store its lane belongs to: its islands', or that of what is frozen.
ColourSetKey set_of_contact(const WorldState& world, const Contact& contact);

// Gives the contact a lane in the lowest colour of that store that both moving bodies have
// free. Both bodies are awake (or fixed). The lane is empty: constraints/write_manifold.h fills it,
// with one point if `single`.
void take_lane(WorldState& world, std::uint32_t contact, bool single);

// After a manifold was rebuilt: whether it is among the blocks of its number of points, ...
bool is_settled(const WorldState& world, const Contact& contact);
// ... and goes there.
void settle_lane(WorldState& world, std::uint32_t contact);

// The last lane of the colour moves into the hole.
void release_lane(WorldState& world, std::uint32_t contact);

// Whether most lanes of the colour lie in the order of their bodies, and brings them there: each
// thread then has the same bodies in all colours. Colours of a store at the same time, but for
// overflow lists.
bool in_order(const Colour& colour);
void sort_lanes(WorldState& world, Colour& colour, int number);

// A lane's content outside the solver and back again.
SavedManifold save_lane(const WorldState& world, std::uint32_t contact);
void restore_lane(WorldState& world, const SavedManifold& saved);  // takes a lane first

// Writes the hot indices of the contact's bodies into its lane: after a lane was taken or a body
// moved in the awake set.
void write_body_indices(WorldState& world, const Contact& contact);

// Adds an empty block at the end of a colour.
void add_block(Colour& colour);

struct LanePlace {
    Colour* colour;
    ContactConstraintWide* block;
    ContactConstraintWideMeta* meta;
    RollingWide* rolling;
    int lane;
};
LanePlace place_of(WorldState& world, const Contact& contact);
inline bool reports_stays(const WorldState& world, const Contact& contact) {
    return world.shapes.shapes[contact.shape_a].report_stays ||
           world.shapes.shapes[contact.shape_b].report_stays;
}
inline Vec3 normal_of(const LanePlace& place) {
    return get_lane(place.block->normal, place.lane);
}

// Row `row` of a block's lane as one float; rows 0 and 1 hold the body indices.
inline float* lane_float(ContactConstraintWide& block, int row, int lane) {
    return reinterpret_cast<float*>(&block) + row * 8 + lane;
}
inline float* lane_float(RollingWide& rolling, int row, int lane) {
    return reinterpret_cast<float*>(&rolling) + row * 8 + lane;
}

}  // namespace jostle::physics
