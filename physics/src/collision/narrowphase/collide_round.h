// SPDX-License-Identifier: MIT
//
// Spheres and capsules against each other and against boxes: closed forms.
#pragma once

#include <optional>

#include "physics/src/collision/narrowphase/manifold.h"
#include "physics/src/geometry/transformed_shape.h"

namespace jostle::physics {

Manifold collide_spheres(const Placed& a, const Placed& b, double margin);
Manifold collide_sphere_capsule(const Placed& a, const Placed& b, double margin);
Manifold collide_capsules(const Placed& a, const Placed& b, double margin);
Manifold collide_box_sphere(const Placed& a, const Placed& b, double margin);
// Nothing when the capsule's segment enters the box, or lies over the rim of a face: that is not a
// closed form's work.
std::optional<Manifold> collide_box_capsule(const Placed& a, const Placed& b, double margin);

}  // namespace jostle::physics
