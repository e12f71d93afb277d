// SPDX-License-Identifier: MIT
//
// Seams between neighbouring pieces of a floor: flush boxes and tiles, children of a compound,
// meshes that were cut, triangles without a common edge. A shape that slides from one piece onto
// the next one must not be stopped by the side of that piece, and a ball that rolls towards it must
// not be lifted by its edge.
//
// Let a shape touch or approach two pieces F and G along the normals f and g, which point to the
// shape. G covers the contact with F if
// 1. G rises above the plane of the contact with F, so that f points into G, and
// 2. F does not rise above the plane of the contact with G.
// The shape lies above the plane of its contact with G, except for their overlap. By 2 the shape
// then lies above F, too: g separates them, and F acts along g if it acts at all. Of two pieces at
// most one is covered by the other, so no contact is lost.
#pragma once

#include <optional>
#include <vector>

#include "physics/src/collision/narrowphase/manifold.h"
#include "physics/src/geometry/support.h"
#include "physics/src/geometry/transformed_shape.h"

namespace jostle::physics {

// The shapes next to one or both shapes of a pair that the respective other one may touch.
struct SeamNeighbours {
    std::vector<TransformedShape> of_a, of_b;

    bool empty() const { return of_a.empty() && of_b.empty(); }
};

// Changes the contact points of two shapes, neither of them composite, if a neighbour covers them;
// returns whether one does.
bool apply_seams(Manifold& manifold, const TransformedShape& a, const TransformedShape& b,
                 const SeamNeighbours& neighbours, double margin);

// Returns whether neighbours cover the contact of a shape of any kind with another one, `floor`, at
// a point within `margin` metres of both. `normal` points from the floor to the shape.
bool is_covered(const TransformedShape& floor, const TransformedShape& shape, Vec3 point,
                Vec3 normal, const std::vector<TransformedShape>& neighbours, double margin);

// A contact of a shape with a convex piece, in any common frame. Only pieces that the shape may
// touch within `margin` metres cover it.
class SeamContact {
public:
    SeamContact(const Convex& shape, const Convex& piece, Vec3 normal, double margin);

    // Tests whether a neighbouring piece covers the contact.
    void test(const Convex& neighbour);
    void test_plane(Vec3 normal, double offset);
    // The normal of the piece that covers the contact. Of several, the nearest one: the others may
    // be covered themselves.
    std::optional<Vec3> covering_normal() const { return covering_; }

private:
    void test(Vec3 normal, double offset, double rise, double gap);

    const Convex &shape_, &piece_;
    Vec3 normal_;
    double margin_, tolerance_;
    double height_;  // m: of the piece along the normal
    std::optional<Vec3> covering_;
    double covering_gap_ = 1e300;  // m
};

// The neighbours of the pieces that a convex shape touches.
class Seams {
public:
    // Contacts are given in a frame with these axes whose origin is the shape's position.
    Seams(const TransformedShape& shape, const Mat3& axes, double margin);

    // Adds a neighbour of any kind, in world coordinates.
    void add(const TransformedShape& neighbour);
    bool empty() const { return neighbours_.empty(); }

    // The normal of a neighbour that covers the contact of the shape with a piece. `own` is the
    // geometry of that piece, which does not cover itself; null if it is not among the neighbours.
    std::optional<Vec3> covering_normal(const Convex& piece, Vec3 normal,
                                        const Geometry* own) const;

private:
    Vec3 origin_;
    Mat3 axes_;
    TransformedShape local_;
    Convex shape_;
    double margin_;
    std::vector<TransformedShape> neighbours_;  // in the frame of the contacts
};

}  // namespace jostle::physics
