// SPDX-License-Identifier: MIT
//
// The moment of an impact against the slab oracle (support/convex_oracle.h): up to it the shapes
// are apart wherever one looks, then they are within the gap; who never meets is apart throughout.
#include "physics/src/collision/narrowphase/time_of_impact.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/convex_oracle.h"
#include "tests/support/random_shapes.h"

namespace jostle::test {
namespace {
using namespace physics;

constexpr double gap = 1e-3;  // m

struct Mover {
    Geometry geometry;
    SweptShape swept;

    Transform pose(double fraction) const {
        const Vec3 center = center_at(swept.sweep, fraction);
        const Quat rotation = rotation_at(swept.sweep, fraction);
        return {center + rotate(rotation, swept.offset), rotation};
    }
};

// A shape off its body's centre, which goes and turns at random: up to `turn` rad in the step.
Mover random_mover(const Geometry& geometry, Vec3 center, Vec3 motion, double turn,
                   Random& random) {
    Mover m{geometry, {}};
    m.swept.offset = random.vector(0.3);
    m.swept.axes = to_matrix(Quat{});
    double furthest = 0;
    for (int k = 0; k < 600; k++)
        furthest = std::max(furthest, support(m.geometry, {}, random.direction()));
    m.swept.radius = 1.05 * furthest + length(m.swept.offset);
    m.swept.sweep = {0, center, random_rotation(random), motion, random.direction() * turn};
    return m;
}

TEST(TimeOfImpact, is_the_first_time_within_the_target_distance) {
    Random random(11);
    const ShapeKind kinds[] = {ShapeKind::sphere,   ShapeKind::capsule, ShapeKind::box,
                               ShapeKind::cylinder, ShapeKind::cone,    ShapeKind::hull};
    int met = 0, passed = 0;
    double worst_early = 0;  // m
    for (int round = 0; round < 72; round++) {
        const double turns[] = {0, 0.3, 3, 12};
        const Vec3 place = random.direction() * random.in(3, 6);
        // One after the other: compilers evaluate arguments in orders of their own.
        const auto mover = [&](int kind, Vec3 center, Vec3 motion, double spread) {
            const Geometry geometry = random_geometry(kinds[kind], random);
            const Vec3 way = motion + random.vector(spread);
            const double turn = turns[random.below(4)];
            return random_mover(geometry, center, way, turn, random);
        };
        Mover a = mover(round % 6, {}, {}, 1), b = mover(round / 6 % 6, place, place * -1.5, 2);
        a.swept.geometry = &a.geometry;
        b.swept.geometry = &b.geometry;
        const auto distance_at = [&](double fraction) {
            return separation(a.geometry, a.pose(fraction), b.geometry, b.pose(fraction)).distance;
        };
        const Impact hit = time_of_impact(a.swept, b.swept, 0, gap);
        if (hit.at_start) continue;
        const bool meets = hit.fraction <= 1;
        (meets ? met : passed)++;
        const int samples = 24;
        for (int k = 0; k < samples; k++) {
            const double fraction = (meets ? hit.fraction : 1.0) * k / samples;
            ASSERT_GT(distance_at(fraction), 0.9 * gap) << "round " << round << ", at " << fraction;
        }
        if (!meets) continue;
        // The oracle's search ends short of the top now and then; along the normal it need not
        // search.
        const double there = std::max(distance_at(hit.fraction),
                                      slab_gap(a.geometry, a.pose(hit.fraction), b.geometry,
                                               b.pose(hit.fraction), hit.normal));
        EXPECT_GT(there, 0.9 * gap) << "round " << round;
        worst_early = std::max(worst_early, there);
    }
    RecordProperty("met", met);
    RecordProperty("passed", passed);
    EXPECT_GT(met, 20);
    EXPECT_GT(passed, 20);
    EXPECT_LT(worst_early, 2.2 * gap);
}

// Thin things that tumble past each other near by, most of which the rods around them part: what is
// said to pass by keeps its distance wherever the oracle looks.
TEST(TimeOfImpact, tumbling_past_reports_no_hit) {
    Random random(12);
    const auto thin = [&](int kind) -> Geometry {
        const double length = random.in(0.3, 0.6), width = random.in(0.03, 0.06);
        if (kind == 0) return Box{{width, length, random.in(0.03, 0.06)}};
        if (kind == 1) return Cylinder{width, length};
        if (kind == 2) return Capsule{width, length};
        return random_geometry(ShapeKind::hull, random);
    };
    int never = 0;
    for (int round = 0; round < 400; round++) {
        const double turns[] = {0, 0.1, 0.5, 2};
        const Vec3 place = random.direction() * random.in(0.3, 0.9);
        Mover a = random_mover(thin(round % 4), {}, random.vector(0.4), turns[random.below(4)],
                               random),
              b = random_mover(thin(round / 4 % 3), place, random.vector(0.4),
                               turns[random.below(4)], random);
        a.swept.geometry = &a.geometry;
        b.swept.geometry = &b.geometry;
        const Impact hit = time_of_impact(a.swept, b.swept, 0, gap);
        if (hit.at_start || hit.fraction <= 1) continue;
        never++;
        for (int k = 0; k <= 24; k++) {
            const double fraction = k / 24.0;
            ASSERT_TRUE(
                farther_apart_than(gap, a.geometry, a.pose(fraction), b.geometry, b.pose(fraction)))
                << "round " << round << ", at " << fraction;
        }
    }
    RecordProperty("never", never);
    EXPECT_GT(never, 100);
    EXPECT_LT(never, 350) << "many do meet";
}

}  // namespace
}  // namespace jostle::test
