// SPDX-License-Identifier: MIT
//
// The bound of the relative motion of two bodies, compared with points that both contain.
#include "physics/src/stages/relative_displacement.h"

#include <random>

#include <gtest/gtest.h>

#include "jostle/physics/quat.h"

namespace jostle::test {
namespace {
using namespace physics;

// Where a point of the body is after its motion.
Vec3 moved(const BodyDisplacement& body, Vec3 point) {
    return body.center + body.translation +
           rotate(from_rotation_vector(body.rotation_vector), point - body.center);
}

TEST(RelativeDisplacement, bounds_the_motion_of_all_common_points) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto vector = [&](double size) {
        return Vec3{unit(random), unit(random), unit(random)} * size;
    };
    double tightest = 0;
    for (int k = 0; k < 20'000; k++) {
        const double radius_b = k % 2 == 0 ? 0.5 : 20;
        BodyDisplacement a{{}, vector(0.3), vector(0.4), 0.3},
            b{vector(radius_b), vector(0.3), vector(0.4), radius_b};
        const double bound = max_relative_displacement(a, b);
        for (int p = 0; p < 8; p++) {
            const Vec3 point = vector(0.3);
            if (length(point) > a.radius || length(point - b.center) > b.radius) continue;
            const double exact = length(moved(a, point) - moved(b, point));
            ASSERT_LE(exact, bound * (1 + 1e-12)) << k;
            tightest = maximum(tightest, exact / bound);
        }
    }
    EXPECT_GT(tightest, 0.7);
}

// Bodies that turn with a drum hardly move relative to it, however fast it turns.
TEST(RelativeDisplacement, large_rotating_body_counts_with_its_motion_nearby) {
    const Vec3 turn{0, 0, 0.03}, at{4, 3, 0};
    const BodyDisplacement drum{{}, {}, turn, 6}, cube{at, cross(turn, at), turn, 0.2};
    EXPECT_LT(max_relative_displacement(cube, drum), 0.003);
    EXPECT_LT(max_relative_displacement(drum, cube), 0.003);
    const BodyDisplacement still{at, {}, {}, 0.2};
    EXPECT_NEAR(max_relative_displacement(still, drum), 0.15 + 0.006, 0.003);
}

TEST(RelativeDisplacement, static_planes_have_an_infinite_radius) {
    const BodyDisplacement plane{{}, {}, {}, displaced_radius({.type = BodyType::static_body})},
        ball{{0, 1, 0}, {0, -0.1, 0}, {0.2, 0, 0}, 0.5};
    EXPECT_NEAR(max_relative_displacement(ball, plane), 0.2, 1e-12);
    EXPECT_NEAR(max_relative_displacement(plane, ball), 0.2, 1e-12);
}

}  // namespace
}  // namespace jostle::test
