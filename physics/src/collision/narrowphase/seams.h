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

#include "jostle/physics/aabb.h"
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

// The contact points of a piece with a shape along a neighbour's normal, relative to the common
// origin. There are none if no part of the piece lies flush with the neighbour below the shape.
Manifold contact_along(const Convex& piece, const Convex& shape, Vec3 normal, double margin);

// A contact of a shape with a convex piece that is `gap` metres away, in any common frame. Only
// pieces that are not further away cover it.
class SeamContact {
public:
    SeamContact(const Convex& shape, const Convex& piece, Vec3 normal, double gap);

    double reach() const { return reach_; }  // m: maximum distance of pieces that may cover it
    // Tests whether a neighbouring piece covers the contact.
    void test(const Convex& neighbour);
    // The same for a piece whose contact with the shape is known.
    void test(const Convex& neighbour, Vec3 normal, double gap);
    void test_plane(Vec3 normal, double offset);
    // The normal of the piece that covers the contact. Of several, the nearest one: the others may
    // be covered themselves.
    std::optional<Vec3> covering_normal() const { return covering_; }

private:
    void test(Vec3 normal, double offset, double rise, double gap);

    const Convex &shape_, &piece_;
    Vec3 normal_;
    double tolerance_, reach_;
    double height_;  // m: of the piece along the normal
    std::optional<Vec3> covering_;
    double covering_gap_ = 1e300;  // m
};

// The neighbours of the pieces that a convex shape touches.
class Seams {
public:
    // Contacts are given in a frame with these axes whose origin is the shape's position.
    Seams(const TransformedShape& shape, const Mat3& axes);

    // Adds a neighbour of any kind, in world coordinates.
    void add(const TransformedShape& neighbour);
    bool empty() const { return neighbours_.empty(); }

    // The normal of a neighbour that covers the contact of the shape with a piece.
    std::optional<Vec3> covering_normal(const Convex& piece, Vec3 normal, double gap) const;

private:
    Vec3 origin_;
    Mat3 axes_;
    TransformedShape local_;
    Convex shape_;
    Aabb box_;
    std::vector<TransformedShape> neighbours_;  // in the frame of the contacts
};

}  // namespace jostle::physics
