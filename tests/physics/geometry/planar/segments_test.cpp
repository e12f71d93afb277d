// SPDX-License-Identifier: MIT
//
// Every pair of segments on a grid, points among them, against integers; and the cases by name.
#include <gtest/gtest.h>

#include "jostle/physics/planar.h"
#include "tests/support/grid_oracle.h"

namespace jostle::test {
namespace {
using namespace physics;
using namespace physics::planar;

SegmentRelation relation_of(Shared what) {
    if (what.inner) return SegmentRelation::crossing;
    return what.count == 0   ? SegmentRelation::apart
           : what.count == 1 ? SegmentRelation::touching
                             : SegmentRelation::overlapping;
}

void compare(GridPoint2 a, GridPoint2 b, GridPoint2 c, GridPoint2 d) {
    const Segment first{a.real(), b.real()}, second{c.real(), d.real()};
    const SegmentIntersection meeting = intersect(first, second);
    const SegmentRelation expected = relation_of(shared(a, b, c, d));
    ASSERT_EQ(meeting.relation, expected) << a.x << "," << a.y << " " << b.x << "," << b.y << " "
                                          << c.x << "," << c.y << " " << d.x << "," << d.y;
    ASSERT_EQ(intersect(second, first).relation, expected);
    if (expected == SegmentRelation::touching || expected == SegmentRelation::overlapping)
        for (const Vec2 p : {meeting.first, meeting.last}) {
            const GridPoint2 end = grid(p);
            ASSERT_TRUE(end == a || end == b || end == c || end == d);
            ASSERT_TRUE(lies_on(a, b, end) && lies_on(c, d, end));
        }
    ASSERT_EQ(meeting.first == meeting.last, expected != SegmentRelation::overlapping);
    if (expected != SegmentRelation::crossing) return;
    const auto det = static_cast<double>(cross(b - a, d - c));
    const Vec2 exact = a.real() + (b - a).real() * (static_cast<double>(cross(c - a, d - c)) / det);
    ASSERT_LE(length(meeting.first - exact), 1e-14);
}

// 65,536 pairs: every way in which two segments can lie.
TEST(Segments, match_integer_arithmetic_for_all_pairs_on_a_4x4_grid) {
    const auto point = [](int k) { return GridPoint2{k % 4, k / 4}; };
    for (int a = 0; a < 16; a++)
        for (int b = 0; b < 16; b++)
            for (int c = 0; c < 16; c++)
                for (int d = 0; d < 16; d++) compare(point(a), point(b), point(c), point(d));
}

TEST(Segments, match_integer_arithmetic_on_a_wide_grid) {
    Random random(5);
    for (int k = 0; k < 50000; k++) {
        const std::uint64_t side = k % 2 == 0 ? 9 : 1000;
        const GridPoint2 a = random_point(random, side), b = random_point(random, side);
        compare(a, b, random_point(random, side), random_point(random, side));
        ASSERT_EQ(on_segment({a.real(), b.real()}, {4, 4}), lies_on(a, b, {4, 4}));
    }
}

TEST(Segments, handle_named_cases) {
    const auto of = [](Segment a, Segment b) { return intersect(a, b).relation; };
    using enum SegmentRelation;
    EXPECT_EQ(of({{0, 0}, {2, 2}}, {{0, 2}, {2, 0}}), crossing);
    EXPECT_EQ(of({{0, 0}, {2, 0}}, {{0, 1}, {2, 1}}), apart) << "parallel";
    EXPECT_EQ(of({{0, 0}, {1, 0}}, {{2, 0}, {3, 0}}), apart) << "in one line";
    EXPECT_EQ(of({{0, 0}, {1, 0}}, {{1, 0}, {3, 0}}), touching) << "end to end in one line";
    EXPECT_EQ(of({{0, 0}, {2, 0}}, {{1, 0}, {3, 0}}), overlapping);
    EXPECT_EQ(of({{0, 0}, {3, 0}}, {{2, 0}, {1, 0}}), overlapping) << "one in the other";
    EXPECT_EQ(of({{0, 0}, {2, 2}}, {{2, 2}, {0, 0}}), overlapping) << "the same, turned round";
    EXPECT_EQ(of({{0, 0}, {2, 0}}, {{0, 0}, {0, 2}}), touching) << "a corner";
    EXPECT_EQ(of({{0, 0}, {2, 0}}, {{1, 0}, {1, 2}}), touching) << "a T";
    EXPECT_EQ(of({{1, 1}, {1, 1}}, {{0, 0}, {2, 2}}), touching) << "a point on a segment";
    EXPECT_EQ(of({{3, 3}, {3, 3}}, {{0, 0}, {2, 2}}), apart) << "a point in its line";
    EXPECT_EQ(of({{1, 0}, {1, 0}}, {{0, 0}, {2, 2}}), apart) << "a point beside it";
    EXPECT_EQ(of({{1, 1}, {1, 1}}, {{1, 1}, {1, 1}}), touching) << "equal points";
    EXPECT_EQ(of({{1, 1}, {1, 1}}, {{1, 2}, {1, 2}}), apart) << "two points";
    const SegmentIntersection part = intersect({{0, 0}, {2, 0}}, {{3, 0}, {1, 0}});
    EXPECT_EQ(part.first, (Vec2{1, 0}));
    EXPECT_EQ(part.last, (Vec2{2, 0}));
}

// Nearly parallel: the point is far from well known along the lines, but it is on both.
TEST(Segments, crossing_point_of_nearly_parallel_segments_lies_on_both) {
    Random random(6);
    int crossings = 0;
    for (int k = 0; k < 20000; k++) {
        const auto some = [&](double size) {
            return Vec2{random.in(-size, size), random.in(-size, size)};
        };
        const Segment a{some(1), some(1)};
        const Segment b{a.from + some(1e-12), a.to + some(1e-12)};
        const SegmentIntersection meeting = intersect(a, b);
        if (meeting.relation != SegmentRelation::crossing) continue;
        crossings++;
        for (const Segment& s : {a, b})
            ASSERT_LE(absolute(doubled_area(s.from, s.to, meeting.first)),
                      1e-15 * (1 + length(s.to - s.from)));
    }
    EXPECT_GT(crossings, 3000);
}

}  // namespace
}  // namespace jostle::test
