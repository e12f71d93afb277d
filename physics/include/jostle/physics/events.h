// SPDX-License-Identifier: MIT
//
// What happened in the last step, as arrays to read until the next one. Sorted by the ids they
// name, so the order does not depend on threads. No user code runs inside a step.
#pragma once

#include <span>

#include "jostle/physics/ids.h"
#include "jostle/physics/vec3.h"

namespace jostle::physics {

// Two shapes began to press on each other.
struct ContactBegin {
    ShapeId shape_a, shape_b;
    BodyId body_a, body_b;
    Vec3 point;           // m, world
    Vec3 normal;          // unit, from a to b
    double approach = 0;  // m/s at the start of the step, >= 0
};

// They parted, or one of them was destroyed (its id is then no longer valid).
struct ContactEnd {
    ShapeId shape_a, shape_b;
    BodyId body_a, body_b;
};

struct Events {
    std::span<const ContactBegin> contacts_began;
    std::span<const ContactEnd> contacts_ended;
    std::span<const BodyId> fell_asleep;
    std::span<const BodyId> woke;
    // Bodies whose state stopped being a number: they were put back to their last good pose, at
    // rest.
    std::span<const BodyId> quarantined;
};

}  // namespace jostle::physics
