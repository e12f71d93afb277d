// SPDX-License-Identifier: MIT
//
// Collision of two convex shapes with the method that fits their cores: closed forms for points and
// segments, separating axes for polyhedra, GJK and EPA for round cores.
#pragma once

#include <optional>

#include "physics/src/collision/narrowphase/clip.h"
#include "physics/src/collision/narrowphase/sat.h"

namespace jostle::physics {

// Cache of a pair of shapes across steps. Part of the world's state.
struct PairCache {
    AxisCode axis = 0;  // the separating axis used last
    Vec3 direction;     // from a to b, of the last closest points; zero if there is none
};

// The signed distance of the cores and the points at that distance. Beyond a distance of `enough`
// between the surfaces, a lower bound suffices.
Witness find_witness(const Convex& a, const Convex& b, double enough, PairCache& cache);

// Same as collide_convex() for two polyhedra without radius that are `distance` metres apart along
// a normal. Returns nullopt if they touch.
std::optional<Manifold> collide_apart(const Convex& a, const Convex& b, Vec3 normal,
                                      double distance, double margin);

// Contact points with a gap of at most `margin`, relative to the same origin as the shapes.
Manifold collide_convex(const Convex& a, const Convex& b, double margin, PairCache& cache);

}  // namespace jostle::physics
