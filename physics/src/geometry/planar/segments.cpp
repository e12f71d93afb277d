// SPDX-License-Identifier: MIT
#include <utility>

#include "jostle/base/check.h"
#include "jostle/physics/planar.h"

namespace jostle::physics::planar {
namespace {

// Lexicographic order, which is monotonic along any line.
bool precedes(Vec2 a, Vec2 b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
}

double within(double x, double end, double other_end) {
    return clamp(x, minimum(end, other_end), maximum(end, other_end));
}

SegmentIntersection intersect_collinear(Segment a, Segment b) {
    if (precedes(a.to, a.from)) std::swap(a.from, a.to);
    if (precedes(b.to, b.from)) std::swap(b.from, b.to);
    const Vec2 first = precedes(a.from, b.from) ? b.from : a.from;
    const Vec2 last = precedes(a.to, b.to) ? a.to : b.to;
    if (precedes(last, first)) return {};
    return {first == last ? SegmentRelation::touching : SegmentRelation::overlapping, first, last};
}

// Precondition: the ends of each segment are on different sides of the other segment.
Vec2 crossing_point(Segment a, Segment b) {
    const double from = doubled_area(b.from, b.to, a.from), to = doubled_area(b.from, b.to, a.to);
    const double t = from / (from - to);
    ASSERT(t >= 0 && t <= 1);
    const Vec2 p = a.from + (a.to - a.from) * t;
    return {within(within(p.x, a.from.x, a.to.x), b.from.x, b.to.x),
            within(within(p.y, a.from.y, a.to.y), b.from.y, b.to.y)};
}

// Precondition: p is collinear with the segment.
bool in_box(Segment s, Vec2 p) {
    return p == Vec2{within(p.x, s.from.x, s.to.x), within(p.y, s.from.y, s.to.y)};
}

}  // namespace

bool on_segment(Segment segment, Vec2 p) {
    return in_box(segment, p) && orientation(segment.from, segment.to, p) == 0;
}

SegmentIntersection intersect(Segment a, Segment b) {
    const int b_from = orientation(a.from, a.to, b.from), b_to = orientation(a.from, a.to, b.to);
    const int a_from = orientation(b.from, b.to, a.from), a_to = orientation(b.from, b.to, a.to);
    // Includes degenerate segments and points collinear with a segment.
    if (b_from == 0 && b_to == 0 && a_from == 0 && a_to == 0) return intersect_collinear(a, b);
    if (b_from * b_to < 0 && a_from * a_to < 0) {
        const Vec2 p = crossing_point(a, b);
        return {SegmentRelation::crossing, p, p};
    }
    const auto touch = [](Vec2 p) { return SegmentIntersection{SegmentRelation::touching, p, p}; };
    if (b_from == 0 && in_box(a, b.from)) return touch(b.from);
    if (b_to == 0 && in_box(a, b.to)) return touch(b.to);
    if (a_from == 0 && in_box(b, a.from)) return touch(a.from);
    if (a_to == 0 && in_box(b, a.to)) return touch(a.to);
    return {};
}

}  // namespace jostle::physics::planar
