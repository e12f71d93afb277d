// SPDX-License-Identifier: MIT
//
// Which pairs are swept. Two stages must agree: update_contacts leaves the impact of such a pair to
// stop_fast_bodies.
#pragma once

#include "jostle/physics/tuning.h"
#include "state/world_state.h"

namespace jostle::physics {

// Whether a body was held by a manifold when the step began.
inline bool was_held(const WorldState& world, const BodyCold& cold) {
    const auto& held = world.scratch.held;
    return cold.set == BodySet::sleeping || (cold.at < held.size() && held[cold.at] != 0);
}

// How far a body may move against another in a step without a sweep, m. In a crowd, where one of
// the two already leans on others, their sizes count together: impacts there come in chains, which
// the contact solver resolves all at once and sweeps only one after the other.
inline double way_without_sweep(const WorldState& world, const BodyCold& mover,
                                const BodyCold& other) {
    double size = mover.inner_radius;
    if (other.type == BodyType::dynamic && (was_held(world, mover) || was_held(world, other)))
        size += other.inner_radius;
    return tuning::sweep_fraction * size;
}

}  // namespace jostle::physics
