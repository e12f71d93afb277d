// SPDX-License-Identifier: MIT
//
// The passes over bodies. One 8-wide operation updates a whole body.
#pragma once

#include "physics/src/constraints/kernels.h"
#include "physics/src/math/wide.h"

namespace jostle::physics::JOSTLE_ISA {

// Applies forces and damping of one sub-step and warm-starts contacts: the velocity change from
// contacts in the previous sub-step is applied again.
template <bool kFirst>
void accelerate_range(const BodyRange& range) {
    for (int k = range.begin; k < range.end; k++) {
        SolverBody& hot = range.bodies[range.indices[k]];
        const ExternalChange& external = range.external[range.indices[k]];
        const Wide now = load(hot.v);
        const Wide free = fma(now, load(external.retained), load(external.push));
        Wide warm = free;
        if constexpr (!kFirst) {
            Wide pushed = now - load(hot.free);
            pushed[6] = pushed[7] = 0;  // mass and spin
            warm = free + pushed;
        }
        store(hot.free, free);
        store(hot.v, warm);
    }
}

inline void advance_range(const BodyRange& range, float h) {
    Wide pace = splat(h);
    pace[6] = pace[7] = 0;
    for (int k = range.begin; k < range.end; k++) {
        SolverBody& hot = range.bodies[range.indices[k]];
        store(hot.dp, fma(load(hot.v), pace, load(hot.dp)));
    }
}

}  // namespace jostle::physics::JOSTLE_ISA
