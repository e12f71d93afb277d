// SPDX-License-Identifier: MIT
//
// What an explosion does to a world. By the thread that steps it, between steps.
//
//     explode(world, {.center = {0, 1, 0}, .strength = 2000}).value();
#pragma once

#include <cstddef>
#include <vector>

#include "jostle/modules/explosion.h"
#include "jostle/physics/world.h"

namespace jostle::modules {

struct BlastImpulse {
    physics::BodyId body = {};
    physics::Vec3 center = {};           // of mass, m
    physics::Vec3 impulse = {};          // N s
    physics::Vec3 angular_impulse = {};  // N m s about the centre of mass
    double area = 0;                     // m^2 of projected area that sees the centre
    double occluded_area = 0;            // m^2 that would, were nothing in the way
};

// Who would get what; by id, hidden ones with zero. Changes nothing. Of the dynamic bodies
// within the radius, awake or asleep. Costs a ray for each point that faces the centre. With many
// shapes each has fewer points; after blast_rays_max rays those that are furthest get nothing.
physics::Result<std::vector<BlastImpulse>> compute_blast(const physics::World& world,
                                                         const Explosion& explosion);
inline constexpr std::size_t blast_rays_max = 20000;

// Applies it, and says what it did. Wakes whom it pushes.
physics::Result<std::vector<BlastImpulse>> explode(physics::World& world,
                                                   const Explosion& explosion);

}  // namespace jostle::modules
