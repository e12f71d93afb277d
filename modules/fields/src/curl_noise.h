// SPDX-License-Identifier: MIT
//
// Divergence-free flow from hashed lattice noise, as the curl of a vector potential A. Each lattice
// corner c has the potential A_c = b_c x (p - c) / 2 of a uniform flow b_c, which is hashed.
// Between corners, potentials are blended with the weights W of Perlin's quintic (K. Perlin,
// "Improving noise", SIGGRAPH 2002). In closed form,
//     u = curl A = sum over corners of grad W x A_c + W b_c,
// whose divergence is zero (R. Bridson et al., "Curl-noise for procedural fluid flow", SIGGRAPH
// 2007), and u(c) = b_c. In time, consecutive lattices are blended with the weights cos and sin,
// whose squares sum to 1, so the strength of the flow is constant in time.
#pragma once

#include <cstdint>

#include "jostle/physics/vec3.h"

namespace jostle::modules::fields_detail {

struct CurlNoise {
    std::uint32_t seed = 1;  // each of half the size and 2^(2/3) times the rate, weaker by 2^(1/3)
    std::uint32_t octaves = 3;  // each of half the size and 2^(2/3) the rate, weaker by 2^(1/3)
    // Number of corners after which the lattice of the first octave repeats, a power of two; 0
    // means never.
    std::uint32_t period = 0;
};

// Returns a flow with mean 0 and root mean square 1. `point` is in units of the size of the largest
// eddies, within 1e15; `time` in units of their lifetime.
physics::Vec3 curl_noise(const CurlNoise& noise, physics::Vec3 point, double time);

}  // namespace jostle::modules::fields_detail
