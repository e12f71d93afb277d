// SPDX-License-Identifier: MIT
//
// Any two convex shapes, by the method that fits their cores: closed forms for points and segments,
// separating axes for polyhedra, GJK and EPA for what is round.
#pragma once

#include <optional>

#include "physics/src/collision/narrowphase/clip.h"
#include "physics/src/collision/narrowphase/sat.h"

namespace jostle::physics {

// What a pair of shapes remembers from step to step. Part of the world's state.
struct PairCache {
    AxisCode axis = 0;  // the separating axis used last
    Vec3 direction;     // from a to b, of the last closest points; zero: none
};

// The cores' signed distance and where it is attained. `enough`: beyond this distance between the
// surfaces a lower bound will do.
Witness find_witness(const Convex& a, const Convex& b, double enough, PairCache& cache);

// As collide_convex(), of two polyhedra without radius that are known to be apart by `distance`
// along a normal, m. Nothing when they touch after all.
std::optional<Manifold> collide_apart(const Convex& a, const Convex& b, Vec3 normal,
                                      double distance, double margin);

// Points with a gap of at most `margin`, relative to the same origin as the shapes.
Manifold collide_convex(const Convex& a, const Convex& b, double margin, PairCache& cache);

}  // namespace jostle::physics
