// SPDX-License-Identifier: MIT
//
// Tools of the plane: orientation, segments, convex hulls, bounding circles and boxes, Minkowski
// sums. Polygons that are not convex: polygon.h.
//
// Coordinates are metres. Which side a point is on, and with it every question of yes or no here,
// is answered exactly, not to rounding. The same input gives the same bits on every machine.
//
// Functions that take sets of points want 1 to max_planar_points of them, finite and within
// +-limits::max_coordinate, and return an Error that names the point that is not. The others take
// any finite coordinates that are 0 or from 1e-130 to 1e130 in size; beyond that they end, but are
// no longer exact.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "jostle/physics/result.h"
#include "jostle/physics/vec2.h"

namespace jostle::physics::planar {

inline constexpr std::size_t max_planar_points = 1000000;

// 1: c is to the left of the line from a to b (a, b, c turn counter-clockwise), -1: to the right,
// 0: on it. Exact. A filter of one rounded determinant decides nearly all; the rest is summed
// without any error (Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust
// Geometric Predicates", 1997; his two stages in between are left out).
int orientation(Vec2 a, Vec2 b, Vec2 c);

// m^2: twice the signed area of the triangle, with the exact sign and a relative error of 1e-15.
// Two to three times as slow as orientation().
double doubled_area(Vec2 a, Vec2 b, Vec2 c);

// May be a point: then both ends are equal.
struct Segment {
    Vec2 from, to;
};

// Its ends belong to a segment. Exact.
bool on_segment(Segment segment, Vec2 p);

enum class SegmentRelation : std::uint8_t {
    apart,        // no common point
    touching,     // one common point, which is an end of at least one of them
    crossing,     // one common point, which is an end of neither
    overlapping,  // in one line, with more than one common point
};

struct SegmentIntersection {
    SegmentRelation relation = SegmentRelation::apart;
    // What they share. Touching: the end, bit for bit, twice. Overlapping: two of the four ends.
    // Crossing: the point to rounding, inside the boxes of both, twice. Apart: zeros.
    Vec2 first, last;
};

// The relation is exact. Parallel, collinear and degenerate segments are no special cases to the
// caller: a point on a segment touches it, two equal points touch.
SegmentIntersection intersect(Segment a, Segment b);

// The corners of the convex hull, counter-clockwise, from the leftmost (of those the lowest).
// Points inside, on sides and repeated ones are dropped. One corner when all points are equal, two
// when all lie in one line. Exact.
//
// Andrew's monotone chain ("Another efficient algorithm for convex hulls in two dimensions", 1979):
// O(n log n).
Result<std::vector<Vec2>> convex_hull(std::span<const Vec2> points);
// The same corners by gift wrapping (Jarvis, "On the identification of the convex hull of a finite
// set of points in the plane", 1973): O(n h) for h corners, nothing is sorted. Faster when h is
// small against log n.
Result<std::vector<Vec2>> hull_by_gift_wrapping(std::span<const Vec2> points);

struct Circle {
    Vec2 center;
    double radius = 0;  // m
};

// The smallest circle around the points, within 1e-12 of its size: no point is farther from the
// centre than the radius. Welzl's algorithm ("Smallest enclosing disks (balls and ellipsoids)",
// 1991), without recursion, on the corners of the hull in an order that is mixed by a fixed
// generator: O(n log n) for the hull, and expected O(h).
Result<Circle> smallest_circle(std::span<const Vec2> points);

struct OrientedBox {
    Vec2 center;
    Vec2 axis{1, 0};                         // unit, along half_length, x > 0 or (0, 1)
    double half_length = 0, half_width = 0;  // m; along the axis, and across it
};

// The box along the principal axes of the points (the eigenvectors of their covariance). O(n). It
// depends on how the points are spread, and is not the smallest. Where no axis is principal (all
// points equal, or as spread one way as any other) it stands along x.
Result<OrientedBox> pca_box(std::span<const Vec2> points);
// The box of the smallest area, by rotating calipers (Toussaint, "Solving geometric problems with
// the rotating calipers", 1983): one of its sides lies on one of the hull's (Freeman and Shapira,
// "Determining the minimum-area encasing rectangle for an arbitrary closed curve", 1975). The
// half length is not the smaller one. O(n log n).
Result<OrientedBox> smallest_box(std::span<const Vec2> points);

// The corners of the set of all a + b, for a in the convex hull of the one and b in that of the
// other. Sides are merged by direction: O(n log n) for the hulls, and O(h). Coordinates are
// rounded once.
Result<std::vector<Vec2>> minkowski_sum(std::span<const Vec2> a, std::span<const Vec2> b);
// All a - b: it holds the origin where the two hulls meet (the "configuration space obstacle").
Result<std::vector<Vec2>> minkowski_difference(std::span<const Vec2> a, std::span<const Vec2> b);

struct Separation {
    double distance = 0;  // m between two hulls; negative: how far b must move to touch at most
    Vec2 direction;       // unit, from a to b, of the shortest such way; (1, 0) where none is
};

// From the Minkowski difference. Within rounding of the coordinates. O(n log n).
Result<Separation> separation(std::span<const Vec2> a, std::span<const Vec2> b);

}  // namespace jostle::physics::planar
