// SPDX-License-Identifier: MIT
//
// The medium that carries particles: a mean wind and divergence-free eddies that follow walls. The
// potential A of the eddies (curl_noise.h) is multiplied by a ramp a of the distance to each wall,
//     u = curl(a A) = a curl A + grad a x A,
// so the divergence stays zero, and at a wall, where a = 0 and grad a is normal to it, the normal
// velocity is zero (R. Bridson et al., "Curl-noise for procedural fluid flow", SIGGRAPH 2007).
#pragma once

#include <cstdint>
#include <vector>

#include "jostle/physics/vec3.h"

namespace jostle::modules {

/// A wall: a plane, or the surface of a ball. There are no eddies behind it.
struct FlowWall {
    physics::Vec3 point = {};  ///< m, on the plane, or the centre of the ball
    /// Normal of the plane into the medium; any length but 0. Not used for a ball.
    physics::Vec3 normal = {0, 1, 0};
    double radius = 0;    ///< m, 0 to 1e6; 0: a plane
    bool inside = false;  ///< whether the medium is inside the ball

    bool operator==(const FlowWall&) const = default;
};

/// A moving medium.
struct ParticleFlow {
    /// Maximum number of walls.
    static constexpr std::size_t walls_max = 8;

    physics::Vec3 wind = {};  ///< m/s, mean velocity, each component within 1e4; ignores walls
    double speed = 0;   ///< m/s, root mean square of the eddies far from walls, 0 to 1e3; 0: none
    double scale = 1;   ///< m, size of the largest eddies, 0.01 to 1e6
    double rate = 0.5;  ///< 1/s, rate at which the largest eddies change, 0 to 1e3; 0 freezes them
    std::uint32_t octaves = 2;  ///< 1 to 8; each has half the size and is weaker by 2^(1/3)
    std::uint32_t seed = 1;     ///< selects the random flow
    double ramp = 0.5;          ///< m, distance from a wall at which its effect ends, 1e-3 to 1e6
    std::vector<FlowWall> walls = {};  ///< at most walls_max

    bool operator==(const ParticleFlow&) const = default;
};

/// Returns the velocity of the medium at a point (m) and time (s), m/s. If `planar` is set, the
/// eddies are in the xy plane and have no divergence in it. Thread-safe.
physics::Vec3 flow_at(const ParticleFlow& flow, physics::Vec3 point, double time,
                      bool planar = false);

}  // namespace jostle::modules
