// SPDX-License-Identifier: MIT
//
// Emitters of particles. A particle is identified by its number in the stream of its emitter; its
// place, velocity and lifetime are functions of that number and the seed, so anyone who knows the
// emitter can compute them.
#pragma once

#include <cstdint>

#include "jostle/physics/vec3.h"

namespace jostle::modules {

/// Shape of the region in which particles start. Disc and box are centred at the position; the
/// normal of the disc is the direction.
enum class EmitterShape : std::uint8_t { point, disc, box, sphere };

/// Emits particles at a constant rate, in bursts, or both. Particles start at any time within a
/// step, not only at its ends.
struct Emitter {
    EmitterShape shape = EmitterShape::point;
    physics::Vec3 position = {};             ///< m, each component within 1e7
    physics::Vec3 direction = {0, 1, 0};     ///< mean direction of the velocity; any length but 0
    double radius = 0.1;                     ///< m, of the disc and of the sphere, 0 to 1e4
    physics::Vec3 half_extents = {1, 1, 1};  ///< m, of the box, each 0 to 1e4; axis-aligned
    double rate = 0;                         ///< particles per second, 0 to 1e6
    std::uint32_t burst = 0;                 ///< particles per burst, 0 to 1e5
    double burst_period = 0;  ///< s, 0 to 1e6: time between bursts; 0: one burst at the start
    double start = 0;         ///< s, world time, 0 to 1e12
    double duration = 0;      ///< s, 0 to 1e12; 0: unlimited
    double speed = 1;         ///< m/s, 0 to 1e4
    double speed_spread = 0;  ///< 0 to 1: speeds are even in speed * (1 - spread .. 1 + spread)
    double cone = 0;  ///< rad, 0 to pi: half angle of the cone of directions, even in solid angle
    double lifetime = 2;         ///< s, 1e-3 to 1e6
    double lifetime_spread = 0;  ///< 0 to 1, as speed_spread
    std::uint32_t seed = 1;

    bool operator==(const Emitter&) const = default;
};

}  // namespace jostle::modules
