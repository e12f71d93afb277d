// SPDX-License-Identifier: MIT
//
// Convex shapes and rotations for differential tests: general ones, and those at which the branches
// of a narrow phase change.
#pragma once

#include <vector>

#include "jostle/physics/geometry.h"
#include "jostle/physics/hull.h"
#include "tests/support/random.h"
#include "tests/support/world_builder.h"

namespace jostle::test {

inline physics::Geometry random_geometry(physics::ShapeKind kind, Random& random) {
    using namespace physics;
    switch (kind) {
        case ShapeKind::sphere:
            return Sphere{random.in(0.1, 1)};
        case ShapeKind::capsule:
            return Capsule{random.in(0.05, 0.5), random.in(0.1, 1)};
        case ShapeKind::box:
            return Box{{random.in(0.1, 1), random.in(0.1, 1), random.in(0.1, 1)}};
        case ShapeKind::plane:
            return Plane{random.direction()};
        case ShapeKind::cylinder:
            return Cylinder{random.in(0.1, 1), random.in(0.1, 1)};
        case ShapeKind::cone:
            return Cone{random.in(0.1, 1), random.in(0.1, 1)};
        case ShapeKind::hull: {
            std::vector<Vec3> points;
            const auto count = 4 + random.below(20);
            const Vec3 stretch{random.in(0.3, 1), random.in(0.3, 1), random.in(0.3, 1)};
            while (points.size() < count) {
                const Vec3 p = random.vector(1);
                points.push_back({p.x * stretch.x, p.y * stretch.y, p.z * stretch.z});
            }
            return Hull{must(build_hull(points))};
        }
        default:
            break;
    }
    return Sphere{};
}

// General rotations, right angles and almost right angles. The branches of a narrow phase change at
// the latter.
inline physics::Quat random_rotation(Random& random) {
    using namespace physics;
    const auto style = random.below(3);
    if (style == 0) return random.rotation();
    Quat q;
    for (int axis = 0; axis < 3; axis++) {
        Vec3 turn;
        turn[axis] = pi / 2 * static_cast<double>(random.below(4));
        q = q * from_rotation_vector(turn);
    }
    if (style == 2) q = from_rotation_vector(random.vector(1e-4)) * q;
    return normalized(q);
}

}  // namespace jostle::test
