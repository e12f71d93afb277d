// SPDX-License-Identifier: MIT
//
// The bounds of a moving shape, compared with the shape at random poses of its motion.
#include "physics/src/collision/narrowphase/shape_motion.h"

#include <gtest/gtest.h>

#include "tests/support/random_shapes.h"

namespace jostle::test {
namespace {
using namespace physics;

// A box of 2 x 1 x 0.6 m that turns about its end and moves by up to 1 m, near a surface at rest.
struct Moving {
    Geometry geometry = Box{{1, 0.5, 0.3}};
    Geometry ground = Plane{};
    TransformedShape surface, box;
    Convex shape;
    SurfaceMotion motion;

    explicit Moving(Random& random)
        : surface(transformed_shape(ground, {random.vector(3), random_rotation(random)})),
          box(transformed_shape(geometry, {random.vector(3), random_rotation(random)})),
          shape(convex_of({&geometry, {}, transpose(surface.axes) * box.axes}, {})),
          motion{random.vector(1), random.vector(1), random.vector(1),
                 box.position + box.axes * Vec3{1, 0, 0}, 0.1} {}

    ShapeMotion bounds() const { return {motion, surface, box, shape}; }
    // The box at a pose of the motion, in the surface's frame and relative to its current position.
    Convex at(double part, double turned) const {
        const Vec3 shift = motion.to_start + (motion.to_end - motion.to_start) * part;
        const Mat3 turn = to_matrix(from_rotation_vector(motion.turn * turned));
        const Vec3 center = motion.center + shift + turn * (box.position - motion.center);
        const Vec3 moved = transposed_times(surface.axes, center - box.position);
        Convex moving = convex_of({&geometry, {}, transpose(surface.axes) * turn * box.axes}, {});
        moving.position = moving.position + moved;
        return moving;
    }
};

TEST(ShapeMotion, box_contains_all_poses) {
    for (std::uint64_t seed = 0; seed < 200; seed++) {
        Random random(4700 + seed);
        const Moving moving(random);
        const Aabb reach = moving.bounds().reach(
            bounds_of({&moving.geometry, {}, transpose(moving.surface.axes) * moving.box.axes}));
        for (int k = 0; k < 10; k++) {
            const Convex pose = moving.at(random.in(0, 1), random.in(-1, 1));
            for (int axis = 0; axis < 3; axis++) {
                Vec3 d;
                d[axis] = 1;
                EXPECT_LE(support(pose, d)[axis] + 0.1, reach.high[axis] + 1e-9) << seed;
                EXPECT_GE(support(pose, -d)[axis] - 0.1, reach.low[axis] - 1e-9) << seed;
            }
        }
    }
}

TEST(ShapeMotion, planes_out_of_reach_are_never_reached) {
    int out_of_reach = 0;
    for (std::uint64_t seed = 0; seed < 2000; seed++) {
        Random random(4800 + seed);
        const Moving moving(random);
        const Vec3 n = normalized(random.vector(1));
        const double distance = random.in(0, 4);
        if (!moving.bounds().exceeds_reach(distance, n, moving.shape)) continue;
        out_of_reach++;
        // The plane is `distance` from the current pose, against n.
        const double plane = dot(support(moving.shape, -n), n) - distance;
        for (int k = 0; k < 10; k++) {
            const Convex pose = moving.at(random.in(0, 1), random.in(-1, 1));
            EXPECT_GT(dot(support(pose, -n), n), plane + moving.motion.near - 1e-9) << seed;
        }
    }
    EXPECT_GT(out_of_reach, 500);
}

}  // namespace
}  // namespace jostle::test
