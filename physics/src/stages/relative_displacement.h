// SPDX-License-Identifier: MIT
//
// How far two bodies move relative to each other in a step, where they may touch.
#pragma once

#include "jostle/physics/scalar.h"
#include "jostle/physics/vec3.h"
#include "physics/src/state/body_store.h"

namespace jostle::physics {

// The motion of a body in a step, or in the rest of one.
struct BodyDisplacement {
    Vec3 center;           // m, of mass, at the start
    Vec3 translation;      // m, of the centre
    Vec3 rotation_vector;  // rad
    double radius = 0;     // m: distance of the furthest point from the centre
};
// The radius for the above. Planes are larger than their bodies.
inline double displaced_radius(const BodyCold& cold) {
    constexpr double infinite = 1e300;
    return cold.type == BodyType::static_body ? infinite : cold.radius;
}

inline double turning_of(const BodyDisplacement& body) {
    if (body.rotation_vector == Vec3{}) return 0;  // planes have an infinite radius
    return length(body.rotation_vector) * body.radius;
}

// An upper bound of the relative displacement of any two points, m.
inline double displacement_anywhere(const BodyDisplacement& a, const BodyDisplacement& b) {
    return length(a.translation - b.translation) + turning_of(a) + turning_of(b);
}

// The same for points that may touch. They lie within the radius of the smaller body, so a large
// body that rotates, such as a drum, counts only with its motion there: the relative displacement
// at the centre of the smaller body, and the relative rotation about that centre. Rotations by
// finite angles add terms of second order.
inline double max_relative_displacement(const BodyDisplacement& a, const BodyDisplacement& b) {
    const double anywhere = displacement_anywhere(a, b);
    const BodyDisplacement &small = a.radius <= b.radius ? a : b,
                           &large = a.radius <= b.radius ? b : a;
    if (large.rotation_vector == Vec3{}) return anywhere;
    const Vec3 apart = small.center - large.center;
    const double second_order =
        0.5 * (length_squared(small.rotation_vector) * small.radius +
               length_squared(large.rotation_vector) * (length(apart) + small.radius));
    const double near =
        length(small.translation - large.translation - cross(large.rotation_vector, apart)) +
        length(small.rotation_vector - large.rotation_vector) * small.radius + second_order;
    return minimum(anywhere, near);
}

}  // namespace jostle::physics
