// SPDX-License-Identifier: MIT
//
// What a character asks the world about what is near: contacts around a capsule, sweeps of it, and
// what floor an edge belongs to. Sees neither its own body nor triggers.
#pragma once

#include <optional>
#include <vector>

#include "modules/character/src/character_data.h"

namespace jostle::modules::character_detail {

// One flat piece of something near a capsule.
struct Contact {
    physics::Vec3 normal;  // unit, towards the capsule
    double gap = 0;        // m from the capsule, along the normal; negative: overlap
    physics::Vec3 point;   // m, world
    physics::BodyId body;
    physics::ShapeId shape;
    physics::Vec3 velocity;  // m/s of the body at the point, its surface included
    bool dynamic = false;
    bool pushed = false;  // in this step
};

struct EnvironmentQuery {
    const physics::World& world;
    physics::QueryFilter filter;

    // All within `reach` of an upright capsule, the nearest first.
    std::vector<Contact> contacts(const physics::Capsule& capsule, physics::Vec3 center,
                                  double reach) const;
    // The first thing in the way.
    std::optional<physics::ShapeCastHit> sweep(const physics::Capsule& capsule,
                                               physics::Vec3 center, physics::Vec3 motion) const;
    // ... that is no part of the body.
    std::optional<physics::ShapeCastHit> sweep_ignoring(const physics::Capsule& capsule,
                                                        physics::Vec3 center, physics::Vec3 motion,
                                                        physics::BodyId body) const;
    // What a sweep met, at so far a gap.
    Contact contact_at(const physics::ShapeCastHit& hit, double gap) const;
    bool is_free(const physics::Capsule& capsule, physics::Vec3 center) const;
    std::optional<physics::RayHit> cast_ray(physics::Vec3 from, physics::Vec3 motion) const;
    // The normal of the floor that ends at an edge: that of what is a little way behind it.
    std::optional<physics::Vec3> floor_behind(physics::Vec3 edge, physics::Vec3 normal) const;
};

EnvironmentQuery make_environment_query(const physics::World& world, const CharacterData& record);

// m/s of a body's point, and of the belt that the shape is there.
physics::Vec3 surface_velocity(const physics::World& world, physics::BodyId body,
                               physics::ShapeId shape, physics::Vec3 point);

}  // namespace jostle::modules::character_detail
