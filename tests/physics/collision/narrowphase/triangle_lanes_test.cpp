// SPDX-License-Identifier: MIT
//
// The single-precision filter of triangles against exact distances (GJK) of random shapes of every
// convex kind.
#include "physics/src/collision/narrowphase/triangle_lanes.h"

#include <gtest/gtest.h>

#include "physics/src/collision/narrowphase/gjk.h"
#include "physics/src/geometry/transformed_shape.h"
#include "tests/support/random_shapes.h"

namespace jostle::test {
namespace {
using namespace physics;

constexpr ShapeKind filtered_kinds[] = {ShapeKind::sphere,   ShapeKind::capsule, ShapeKind::box,
                                        ShapeKind::cylinder, ShapeKind::cone,    ShapeKind::hull};
constexpr double filter_reach = 0.1;  // m, from the core

// Calls visit(passes, triangle, shape) for random triangles around random shapes.
template <class Visit>
void for_each_filtered(double spread, const MotionLimit* motion, Visit&& visit) {
    for (const ShapeKind kind : filtered_kinds)
        for (std::uint64_t seed = 0; seed < 50; seed++) {
            Random random(31000 + 97 * seed + static_cast<std::uint64_t>(kind));
            const Geometry geometry = random_geometry(kind, random);
            const Vec3 origin = random.vector(100);  // of the shape, in the surface's frame
            const Convex shape =
                convex_of(transformed_shape(geometry, Transform{{}, random_rotation(random)}), {});
            TriangleFilter filter(shape, filter_reach);
            if (motion != nullptr) filter.limit(*motion, shape);
            SurfaceTriangle triangles[4];
            for (std::uint32_t k = 0; k < 4; k++) {
                const Vec3 at = origin + random.vector(spread);
                triangles[k] = {{at, at + random.vector(1), at + random.vector(1)}, k};
                filter.put(triangles[k], origin);
            }
            bool passes[4] = {};
            filter.flush([&](const SurfaceTriangle& t) { passes[t.index] = true; });
            for (int k = 0; k < 4; k++) {
                SurfaceTriangle t = triangles[k];
                for (Vec3& corner : t.corner) corner -= origin;
                visit(passes[k], triangle_convex(t.corner, {}, {}), shape);
            }
        }
}

TEST(TriangleLanes, triangles_within_reach_pass) {
    int within = 0;
    for_each_filtered(1, nullptr, [&](bool passes, const Convex& triangle, const Convex& shape) {
        if (gjk(triangle, shape, {}).distance > filter_reach) return;
        within++;
        EXPECT_TRUE(passes);
    });
    EXPECT_GT(within, 300);
}

TEST(TriangleLanes, distant_triangles_are_rejected) {
    int far = 0, rejected = 0;
    for_each_filtered(4, nullptr, [&](bool passes, const Convex& triangle, const Convex& shape) {
        if (gjk(triangle, shape, {}).distance < filter_reach + 0.5) return;
        far++;
        rejected += passes ? 0 : 1;
    });
    EXPECT_GT(far, 500);
    EXPECT_GT(rejected, 0.98 * far);
}

TEST(TriangleLanes, a_shape_that_leaves_does_not_reach_what_is_behind_it) {
    // Moves by 1 m along x, without rotation: triangles more than 0.01 m behind it are out of
    // reach.
    const MotionLimit motion{{{}, {1, 0, 0}}, {}, {}, 0.01, 10};
    int behind = 0;
    for_each_filtered(1, &motion, [&](bool passes, const Convex& triangle, const Convex& shape) {
        const GjkResult g = gjk(triangle, shape, {});
        const double left = g.distance - shape.radius - 0.01 + minimum(0, g.normal.x);
        if (g.distance > 0 && left > 0) return;  // may be rejected
        if (g.distance > filter_reach) return;
        behind++;
        EXPECT_TRUE(passes);
    });
    EXPECT_GT(behind, 200);
}

}  // namespace
}  // namespace jostle::test
