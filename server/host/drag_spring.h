// SPDX-License-Identifier: MIT
//
// A hand that holds a body by a point: a critically damped spring between the point and a target,
// stepped implicitly, so that no mass, stiffness or rate makes it unstable.
#pragma once

#include "jostle/physics/world.h"

namespace jostle::server {

struct DragSpring {
    physics::BodyId body;
    physics::Vec3 anchor;  // of the held point, in the body's frame
    physics::Vec3 target;  // world, m
};

// Applies one tick's impulse. An error means that the body is gone.
Status pull(physics::World& world, const DragSpring& spring, double dt);

}  // namespace jostle::server
