// SPDX-License-Identifier: MIT
//
// Contact events of bounces, which have no manifold: a bounce begins a contact that ends with the
// next step. Part of solve_continuous. One thread.
#pragma once

#include <cstdint>
#include <vector>

#include "constraints/impact.h"
#include "state/world_state.h"

namespace jostle::physics {

// Adds a bounce of two shapes, with the normal from the first to the second; unless they touch as
// it is, so that their contact goes on.
void note_bounce(const WorldState& world, std::uint32_t shape, std::uint32_t other,
                 const HardestPoint& hit, std::vector<ContactBegin>& bounces);
// Reports them; of several bounces of two shapes in one step the first.
void report_bounces(EventStore& events, std::vector<ContactBegin>& bounces);

}  // namespace jostle::physics
