// SPDX-License-Identifier: MIT
//
// Queries of a character about its surroundings: contacts around a capsule, sweeps of it, and the
// floor behind an edge. They ignore its own body and triggers.
#pragma once

#include <optional>
#include <vector>

#include "modules/character/src/character_data.h"

namespace jostle::modules::character_detail {

// A planar contact with a shape near a capsule.
struct Contact {
    physics::Vec3 normal;  // unit, towards the capsule
    double gap = 0;        // m from the capsule, along the normal; negative: overlap
    physics::Vec3 point;   // m, world
    physics::BodyId body;
    physics::ShapeId shape;
    physics::Vec3 velocity;  // m/s of the body at the point, including its surface velocity
    bool dynamic = false;
    bool pushed = false;  // in this step
};

struct EnvironmentQuery {
    const physics::World& world;
    physics::QueryFilter filter;

    // Returns all contacts within `reach` of an upright capsule, nearest first.
    std::vector<Contact> contacts(const physics::Capsule& capsule, physics::Vec3 center,
                                  double reach) const;
    // Returns the first hit.
    std::optional<physics::ShapeCastHit> sweep(const physics::Capsule& capsule,
                                               physics::Vec3 center, physics::Vec3 motion) const;
    // The same, ignoring one body.
    std::optional<physics::ShapeCastHit> sweep_ignoring(const physics::Capsule& capsule,
                                                        physics::Vec3 center, physics::Vec3 motion,
                                                        physics::BodyId body) const;
    // Converts the hit of a sweep to a contact with the given gap.
    Contact contact_at(const physics::ShapeCastHit& hit, double gap) const;
    bool is_free(const physics::Capsule& capsule, physics::Vec3 center) const;
    std::optional<physics::RayHit> cast_ray(physics::Vec3 from, physics::Vec3 motion) const;
    // Returns the normal of the floor that ends at an edge, measured slightly behind the edge.
    std::optional<physics::Vec3> floor_behind(physics::Vec3 edge, physics::Vec3 normal) const;
};

EnvironmentQuery make_environment_query(const physics::World& world, const CharacterData& record);

// Velocity of a point of a body, m/s, including the surface velocity of the shape (conveyor belt).
physics::Vec3 surface_velocity(const physics::World& world, physics::BodyId body,
                               physics::ShapeId shape, physics::Vec3 point);

}  // namespace jostle::modules::character_detail
