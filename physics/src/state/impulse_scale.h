// SPDX-License-Identifier: MIT
//
// Impulses that warm-start the next sub-step are those of a sub-step of the same length. When that
// changes, because an island changes its tier or the user the length of the step, they follow it.
#pragma once

#include <array>

#include "physics/src/state/contact_constraints.h"

namespace jostle::physics {

// All that warm-starts a manifold.
void scale_warm_start(const ContactLaneRef& lane_ref, float scale);
// ... for sub-steps that are `scale` times as long. `even`: the points of a manifold share its
// load.
void scale_impulses(const ContactLaneRef& lane_ref, float scale, bool even);
// A contact that became stiffer before it had learned what it bears makes up for that with a mean
// impulse that pulls. It would rub as if it bore more, until it has learned better.
void clear_negative_mean_impulse(const ContactLaneRef& lane_ref);
// Those of the joints of a body, each joint once: at its first dynamic body.
void scale_joints(WorldState& world, std::uint32_t body, double scale);

// All of the awake set, for steps that are `scale` times as long. What sleeps follows when it
// wakes.
void scale_awake(WorldState& world, double scale);
// ... for sub-steps that are so many times as long, by index_of() of an island's colour set.
void scale_awake(WorldState& world, const std::array<double, solved_set_count>& scale);

}  // namespace jostle::physics
