// SPDX-License-Identifier: MIT
//
// Spheres and capsules against each other and against boxes: closed forms.
#pragma once

#include <optional>

#include "physics/src/collision/narrowphase/manifold.h"
#include "physics/src/geometry/transformed_shape.h"

namespace jostle::physics {

Manifold collide_spheres(const TransformedShape& a, const TransformedShape& b, double margin);
Manifold collide_sphere_capsule(const TransformedShape& a, const TransformedShape& b,
                                double margin);
Manifold collide_capsules(const TransformedShape& a, const TransformedShape& b, double margin);
Manifold collide_box_sphere(const TransformedShape& a, const TransformedShape& b, double margin);
// Returns nullopt if the capsule's segment enters the box or lies above the rim of a face. These
// cases have no closed form.
std::optional<Manifold> collide_box_capsule(const TransformedShape& a, const TransformedShape& b,
                                            double margin);

}  // namespace jostle::physics
