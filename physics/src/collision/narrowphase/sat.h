// SPDX-License-Identifier: MIT
//
// The separating axis of two polyhedra: the direction with the largest separation, or with the
// least overlap. Candidates are the face normals of both and the cross products of edges that form
// faces of the Minkowski difference (Gregorius, "The separating axis test between convex
// polyhedra", GDC 2013).
#pragma once

#include <cstdint>

#include "physics/src/collision/narrowphase/polyhedron.h"

namespace jostle::physics {

// Code of the axis that a pair used last: 0 for none, otherwise kind, first index and second index.
using AxisCode = std::uint32_t;

// The code of the axis of a face of the first shape, for callers that can guess the face.
AxisCode axis_of_face(std::uint32_t face);

// Whether the axis is perpendicular to two edges.
bool is_edge_pair(AxisCode code);

struct Separation {
    double distance = -1e300;  // m along the normal; negative for overlap
    Vec3 normal;               // unit, from a to b, in the frame of a and b
    AxisCode code = 0;
    Vec3 on_a, on_b;  // points of the two shapes at that separation
};

// `cached`: the axis of the previous call. It is tested first and retained if it is as good as the
// best one up to the tolerance. The search stops early if an axis separates by more than `enough`.
Separation separate(const Convex& a, const Convex& b, AxisCode cached, double enough);

// The separation along the cached axis; the lowest value if there is none.
Separation separate_again(const Convex& a, const Convex& b, AxisCode cached);

// The separation along the face normals closest to `direction` (from a to b, unit, world). Returns
// the better of the two.
Separation separate_by_face(const Convex& a, const Convex& b, Vec3 direction);

// A segment against a polyhedron.
Separation separate_segment(const Convex& polyhedron, const Convex& segment);

}  // namespace jostle::physics
