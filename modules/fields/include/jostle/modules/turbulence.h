// SPDX-License-Identifier: MIT
//
// Turbulent air: a flow without sources whose eddies come and go, as the curl of a noise (R.
// Bridson, J. Hourihan, M. Nordenstam, "Curl-noise for procedural fluid flow", SIGGRAPH 2007).
#pragma once

#include <cstdint>

#include "jostle/physics/vec3.h"

namespace jostle::modules {

// Drags bodies along: F = density / 2 * drag * area * |u| u, with u the flow's velocity at the
// body's centre against it. The area is what its shapes show to the flow. The change of speed
// within a sub-step is integrated exactly, so no drag is too strong.
struct Turbulence {
    physics::Vec3 wind = {};    // m/s, the mean
    double speed = 4;           // m/s, root mean square of what is added to it, 0 to 1e3
    double scale = 5;           // m, of the largest eddies, 0.01 to 1e6
    double rate = 0.5;          // 1/s: how often the largest are others, 0 to 1e3; 0: they stay
    std::uint32_t octaves = 3;  // 1 to 8; each half as large, weaker by 2^(1/3) (Kolmogorov)
    std::uint32_t seed = 1;
    double density = 1.2;  // kg/m^3, 0 to 1e6: air
    double drag = 1;       // coefficient, 0 to 1e6: sphere about 0.5, box about 1

    bool operator==(const Turbulence&) const = default;
};

// m/s, the wind included.
physics::Vec3 flow_at(const Turbulence& turbulence, physics::Vec3 point, double time);

}  // namespace jostle::modules
