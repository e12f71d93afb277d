// SPDX-License-Identifier: MIT
//
// Turbulent air: a divergence-free flow with evolving eddies, computed as the curl of a noise
// potential (R. Bridson, J. Hourihan, M. Nordenstam, "Curl-noise for procedural fluid flow",
// SIGGRAPH 2007).
#pragma once

#include <cstdint>

#include "jostle/physics/vec3.h"

namespace jostle::modules {

/// Drags bodies with the force F = density / 2 * drag * area * |u| u, where u is the flow velocity
/// relative to the body's centre. The area is the projected area of the body's shapes along the
/// flow. The velocity change within a sub-step is integrated exactly, so any drag coefficient is
/// stable.
struct Turbulence {
    physics::Vec3 wind = {};  ///< m/s, mean flow
    double speed = 4;         ///< m/s, root mean square of the turbulent part, 0 to 1e3
    double scale = 5;         ///< m, size of the largest eddies, 0.01 to 1e6
    double rate = 0.5;  ///< 1/s, rate at which the largest eddies change, 0 to 1e3; 0 freezes them
    /// 1 to 8; each octave has half the size and is weaker by 2^(1/3) (Kolmogorov)
    std::uint32_t octaves = 3;
    std::uint32_t seed = 1;  ///< selects the random flow
    double density = 1.2;    ///< kg/m^3, 0 to 1e6; the default is air
    double drag = 1;         ///< drag coefficient, 0 to 1e6: about 0.5 for a sphere, 1 for a box

    bool operator==(const Turbulence&) const = default;
};

/// Returns the velocity of the flow at a point (m) and time (s), including the wind, m/s.
physics::Vec3 flow_at(const Turbulence& turbulence, physics::Vec3 point, double time);

}  // namespace jostle::modules
