// SPDX-License-Identifier: MIT
//
// Computes and applies the impulses of an explosion. Call on the thread that steps the world,
// between steps.
//
//     explode(world, {.center = {0, 1, 0}, .strength = 2000}).value();
#pragma once

#include <cstddef>
#include <vector>

#include "jostle/modules/explosion.h"
#include "jostle/physics/world.h"

namespace jostle::modules {

/// Effect of an explosion on one body.
struct BlastImpulse {
    physics::BodyId body = {};
    physics::Vec3 center = {};           ///< m, centre of mass
    physics::Vec3 impulse = {};          ///< N s
    physics::Vec3 angular_impulse = {};  ///< N m s about the centre of mass
    double area = 0;                     ///< m^2, projected area visible from the centre
    double occluded_area = 0;  ///< m^2, projected area that other shapes hide from the centre
};

/// Computes the impulses of an explosion on all dynamic bodies within its radius, awake or asleep,
/// without changing the world. The result is sorted by id. Bodies that are completely hidden are
/// included with a zero impulse.
///
/// Costs one ray per surface point that faces the centre. With many bodies in range, each shape has
/// fewer points. After blast_rays_max rays the most distant bodies are skipped.
///
/// Returns invalid_argument if a field of the explosion is out of range; the error names it.
physics::Result<std::vector<BlastImpulse>> compute_blast(const physics::World& world,
                                                         const Explosion& explosion);
/// Maximum number of rays of one explosion.
inline constexpr std::size_t blast_rays_max = 20000;

/// Computes the impulses, applies them, and returns them. Wakes the bodies that it pushes. Also
/// pushes the ropes, cloths and particles of the world. Errors are those of compute_blast().
physics::Result<std::vector<BlastImpulse>> explode(physics::World& world,
                                                   const Explosion& explosion);
/// Pushes the matter of modules that is visible from the centre, in cells of a 16th of the radius:
/// ropes, cloths and particles (deformables.h). Bodies are not affected. Errors are those of
/// compute_blast().
physics::Status push_deformables(physics::World& world, const Explosion& explosion);

}  // namespace jostle::modules
