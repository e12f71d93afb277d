// SPDX-License-Identifier: MIT
//
// Contact events of impacts between sub-steps, which have no manifold: their impulses, and a
// contact that begins with the bounce and ends in the next step. Part of solve_continuous.
// Single-threaded.
#pragma once

#include <cstdint>
#include <vector>

#include "physics/src/constraints/impact.h"
#include "physics/src/state/world_state.h"

namespace jostle::physics {

// Adds a bounce of two shapes, with the normal from the first to the second. Ignored if they
// already touch, because their contact then continues.
void note_bounce(const WorldState& world, std::uint32_t shape, std::uint32_t other,
                 const HardestPoint& hit, std::vector<ContactBegin>& bounces);
// Reports the impulse of an impact for shapes with report_stays. publish_events sums the impulses
// of a pair over the step.
void report_impulse(WorldState& world, std::uint32_t shape, std::uint32_t other,
                    const HardestPoint& hit);
// Reports bounces. If two shapes bounce several times in a step, only the first bounce is reported.
void report_bounces(EventStore& events, std::vector<ContactBegin>& bounces);

}  // namespace jostle::physics
