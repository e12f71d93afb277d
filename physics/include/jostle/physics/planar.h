// SPDX-License-Identifier: MIT
//
// Two-dimensional computational geometry: orientation, segment intersection, convex hulls, bounding
// circles and boxes, Minkowski sums. Non-convex polygons are in polygon.h.
//
// Coordinates are in metres. All predicates are exact, not subject to rounding. The same input
// gives the same bits on every machine.
//
// Functions that take point sets accept 1 to max_planar_points points, finite and within
// +-limits::max_coordinate; otherwise they return invalid_argument and name the offending point.
// The other functions accept any finite coordinates that are 0 or between 1e-130 and 1e130 in
// magnitude. Beyond that range they terminate but are no longer exact.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "jostle/physics/result.h"
#include "jostle/physics/vec2.h"

namespace jostle::physics::planar {

/// Maximum number of points in a set.
inline constexpr std::size_t max_planar_points = 1000000;

/// Returns the orientation of the triangle a, b, c: 1 if c is to the left of the line from a to b
/// (counter-clockwise), -1 if it is to the right, 0 if it is on the line. Exact.
///
/// A filter evaluates one rounded determinant, which decides almost all inputs. The remaining ones
/// are summed without error (Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast
/// Robust Geometric Predicates", 1997, without the two intermediate stages).
int orientation(Vec2 a, Vec2 b, Vec2 c);

/// Returns twice the signed area of a triangle, in m^2. The sign is exact, the relative error is
/// 1e-15. Two to three times slower than orientation().
double doubled_area(Vec2 a, Vec2 b, Vec2 c);

/// A line segment. A segment with equal ends is a point.
struct Segment {
    Vec2 from, to;  ///< m
};

/// Returns true if p lies on the segment, ends included. Exact.
bool on_segment(Segment segment, Vec2 p);

/// The relation of two segments.
enum class SegmentRelation : std::uint8_t {
    apart,        ///< no common point
    touching,     ///< one common point, which is an end of at least one segment
    crossing,     ///< one common point, which is an end of neither segment
    overlapping,  ///< collinear, with more than one common point
};

/// The intersection of two segments.
struct SegmentIntersection {
    SegmentRelation relation = SegmentRelation::apart;  ///< how the segments intersect
    /// The common points. Touching: the end point, bit-identical, in both fields. Overlapping: two
    /// of the four ends. Crossing: the rounded point, inside the bounding boxes of both segments,
    /// in both fields. Apart: zeros.
    Vec2 first, last;
};

/// Intersects two segments. The relation is exact. Parallel, collinear and degenerate segments need
/// no special treatment by the caller: a point on a segment touches it, and two equal points touch.
SegmentIntersection intersect(Segment a, Segment b);

/// Returns the corners of the convex hull, counter-clockwise from the leftmost (of several, the
/// lowest). Interior points, points on sides and duplicates are dropped. The result has one corner
/// if all points are equal, and two if all points are collinear. Exact.
///
/// Andrew's monotone chain ("Another efficient algorithm for convex hulls in two dimensions",
/// 1979): O(n log n).
Result<std::vector<Vec2>> convex_hull(std::span<const Vec2> points);
/// Returns the same corners by gift wrapping (Jarvis, "On the identification of the convex hull of
/// a finite set of points in the plane", 1973): O(n h) for h corners, without sorting. Faster if h
/// is small compared with log n.
Result<std::vector<Vec2>> hull_by_gift_wrapping(std::span<const Vec2> points);

/// A circle.
struct Circle {
    Vec2 center;        ///< m
    double radius = 0;  // m
};

/// Returns the smallest enclosing circle, within a relative error of 1e-12. No point is farther
/// from the centre than the radius.
///
/// Welzl's algorithm ("Smallest enclosing disks (balls and ellipsoids)", 1991), iterative, on the
/// corners of the convex hull, shuffled by a generator with a fixed seed: O(n log n) for the hull
/// and expected O(h).
Result<Circle> smallest_circle(std::span<const Vec2> points);

/// An oriented rectangle.
struct OrientedBox {
    Vec2 center;                             ///< m
    Vec2 axis{1, 0};                         ///< unit vector along half_length; x > 0, or (0, 1)
    double half_length = 0, half_width = 0;  ///< m, along the axis and perpendicular to it
};

/// Returns the bounding box along the principal axes of the points (eigenvectors of their
/// covariance). O(n). The box depends on the distribution of the points and is not the smallest
/// one. If no axis is principal (all points are equal, or their covariance is isotropic), the box
/// is aligned with x.
Result<OrientedBox> pca_box(std::span<const Vec2> points);
/// Returns the bounding box of the smallest area, by rotating calipers (Toussaint, "Solving
/// geometric problems with the rotating calipers", 1983): one of its sides lies on a side of the
/// hull (Freeman and Shapira, "Determining the minimum-area encasing rectangle for an arbitrary
/// closed curve", 1975). half_length >= half_width. O(n log n).
Result<OrientedBox> smallest_box(std::span<const Vec2> points);

/// Returns the corners of the Minkowski sum of the convex hulls of a and b: the set of all sums of
/// a point of each hull. Sides are merged by direction: O(n log n) for the hulls and O(h) for the
/// merge. Coordinates are rounded once.
Result<std::vector<Vec2>> minkowski_sum(std::span<const Vec2> a, std::span<const Vec2> b);
/// Returns the corners of the Minkowski difference: the set of all a - b. It contains the origin if
/// the two hulls intersect (the "configuration space obstacle").
Result<std::vector<Vec2>> minkowski_difference(std::span<const Vec2> a, std::span<const Vec2> b);

/// The separation of two convex hulls.
struct Separation {
    /// Distance of the hulls in m. If negative, the length of the shortest translation of b after
    /// which they only touch.
    double distance = 0;
    Vec2 direction;  ///< unit vector from a to b along that distance; (1, 0) if it is undefined
};

/// Returns the separation of the convex hulls of a and b, from their Minkowski difference. Accurate
/// to the rounding of the coordinates. O(n log n).
Result<Separation> separation(std::span<const Vec2> a, std::span<const Vec2> b);

}  // namespace jostle::physics::planar
