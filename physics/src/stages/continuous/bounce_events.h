// SPDX-License-Identifier: MIT
//
// Contact events of impacts between sub-steps, which have no manifold: how hard they pressed; and a
// bounce begins a contact that ends with the next step. Part of solve_continuous. One thread.
#pragma once

#include <cstdint>
#include <vector>

#include "physics/src/constraints/impact.h"
#include "physics/src/state/world_state.h"

namespace jostle::physics {

// Adds a bounce of two shapes, with the normal from the first to the second; unless they touch as
// it is, so that their contact goes on.
void note_bounce(const WorldState& world, std::uint32_t shape, std::uint32_t other,
                 const HardestPoint& hit, std::vector<ContactBegin>& bounces);
// Tells those who asked for stays of the impulse of an impact. publish_events adds up what a pair
// did to each other in the step.
void report_impulse(WorldState& world, std::uint32_t shape, std::uint32_t other,
                    const HardestPoint& hit);
// Reports bounces; of several bounces of two shapes in one step the first.
void report_bounces(EventStore& events, std::vector<ContactBegin>& bounces);

}  // namespace jostle::physics
