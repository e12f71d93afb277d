// SPDX-License-Identifier: MIT
//
// Shapes over triangles, compared with the general clipping of clip.h.
#include "physics/src/collision/narrowphase/face_clip.h"

#include <gtest/gtest.h>

#include "physics/src/geometry/transformed_shape.h"
#include "tests/support/random_shapes.h"

namespace jostle::test {
namespace {
using namespace physics;

constexpr double clip_margin = 0.5;  // m

TEST(FaceClip, points_equal_those_of_the_general_clipping) {
    int points = 0;
    for (const ShapeKind kind : {ShapeKind::capsule, ShapeKind::box, ShapeKind::cylinder,
                                 ShapeKind::cone, ShapeKind::hull})
        for (std::uint64_t seed = 0; seed < 100; seed++) {
            SCOPED_TRACE(testing::Message()
                         << "kind " << static_cast<int>(kind) << " seed " << seed);
            Random random(52000 + 101 * seed + static_cast<std::uint64_t>(kind));
            const Geometry geometry = random_geometry(kind, random);
            const Convex shape = convex_of(
                transformed_shape(geometry, Transform{random.vector(0.5), random_rotation(random)}),
                {});
            FaceClip clip(shape, clip_margin);
            for (int k = 0; k < 4; k++) {
                const Vec3 corner[3] = {random.vector(1), random.vector(1), random.vector(1)};
                const Vec3 face = normalized(cross(corner[1] - corner[0], corner[2] - corner[0]));
                Vec3 outward[3];
                for (int e = 0; e < 3; e++)
                    outward[e] = cross(corner[(e + 1) % 3] - corner[e], face);
                const auto found = clip.over(corner, face, outward);
                const ContactPoints expected =
                    points_over_face(triangle_convex(corner, {}, {}), shape, face, clip_margin);
                ASSERT_EQ(static_cast<int>(found.size()), expected.count);
                for (int p = 0; p < expected.count; p++) {
                    points++;
                    const GapPoint at = found[static_cast<std::size_t>(p)];
                    EXPECT_NEAR(at.gap, expected.gap[p], 1e-9);
                    EXPECT_LT(length(at.point - expected.point[p]), 1e-9);
                }
            }
        }
    EXPECT_GT(points, 1000);
}

}  // namespace
}  // namespace jostle::test
