// SPDX-License-Identifier: MIT
//
// The pressure of an explosion and the lines of sight from its centre.
#pragma once

#include <optional>
#include <vector>

#include "jostle/modules/explosion.h"
#include "jostle/physics/queries.h"
#include "modules/fields/src/blast_points.h"

namespace jostle::modules::fields_detail {

// Impulse per area that faces the centre at a distance from it, N s/m^2.
double strength_at(const Explosion& explosion, double distance);
// Moves the centre out of surfaces that are too near; in a corner, out of one after the other.
physics::Vec3 offset_center(const physics::Queries& queries, const Explosion& explosion);

// Line-of-sight tests from the centre of an explosion.
class BlastVisibility {
public:
    BlastVisibility(const physics::Queries& queries, physics::Vec3 center);

    // Whether no shape is between the centre and a point.
    bool is_visible(physics::Vec3 point) const;
    // The same for a surface point. A convex shape does not hide its own surface that faces the
    // centre. Children of a compound may hide each other.
    bool is_visible(const BlastPoint& point, physics::ShapeId shape, bool is_compound) const;

private:
    std::optional<physics::RayHit> first_hit(physics::Vec3 point) const;

    const physics::Queries& queries_;
    physics::Vec3 center_;
    std::vector<physics::ShapeId> enclosing_shapes_;  // shapes that contain the centre
};

}  // namespace jostle::modules::fields_detail
