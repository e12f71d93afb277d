// SPDX-License-Identifier: MIT
//
// The separating axis of two polyhedra: the direction along which they are furthest apart, or
// overlap least. Face normals of both and cross products of edges, of which only those that are
// faces of the Minkowski difference are checked at (Gregorius, "The separating axis test between
// convex polyhedra", GDC 2013).
#pragma once

#include <cstdint>

#include "physics/src/collision/narrowphase/polyhedron.h"

namespace jostle::physics {

// Which axis a pair used last, as a number to keep: 0 none, else kind, first and second index.
using AxisCode = std::uint32_t;

// The axis of a face of the first shape, for who knows which it may be.
AxisCode axis_of_face(std::uint32_t face);

struct Separation {
    double distance = -1e300;  // m along the normal; negative: overlap
    Vec3 normal;               // unit, from a to b, in the frame that a and b are given in
    AxisCode code = 0;
    Vec3 on_a, on_b;  // points of the two shapes where it is attained
};

// `cached`: the axis of the last time: tried first, and kept when it is as good up to the
// tolerance. Stops early when an axis shows more than `enough`.
Separation separate(const Convex& a, const Convex& b, AxisCode cached, double enough);

// What the axis of the last time shows now; less than anything where it is none.
Separation separate_again(const Convex& a, const Convex& b, AxisCode cached);

// What the faces show that look most along a direction from a to b, unit, world: the better one.
Separation separate_by_face(const Convex& a, const Convex& b, Vec3 direction);

// A segment against a polyhedron.
Separation separate_segment(const Convex& polyhedron, const Convex& segment);

}  // namespace jostle::physics
