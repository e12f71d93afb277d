// SPDX-License-Identifier: MIT
//
// A flow without sources from hashed lattice noise: the curl of a vector potential A. About each
// corner c of a lattice stands A_c = b_c x (p - c) / 2, the potential of an even flow b_c, hashed;
// between corners they are blended with weights W of Perlin's quintic (K. Perlin, "Improving
// noise", SIGGRAPH 2002). Then
//     u = curl A = sum over corners of grad W x A_c + W b_c,
// in closed form, of which the divergence is zero (R. Bridson et al., "Curl-noise for procedural
// fluid flow", SIGGRAPH 2007), and u(c) = b_c. In time, lattices follow one another with the
// weights cos and sin, whose squares sum to one: the flow is as strong between as at them.
#pragma once

#include <cstdint>

#include "jostle/physics/vec3.h"

namespace jostle::modules::fields_detail {

struct CurlNoise {
    std::uint32_t seed = 1;
    std::uint32_t octaves = 3;  // each of half the size and 2^(2/3) the rate, weaker by 2^(1/3)
    // Corners after which the lattice of the first octave comes again, a power of two; 0: never.
    std::uint32_t period = 0;
};

// Root mean square 1, mean 0. `point` in sizes of the largest eddies, within 1e15; `time` in those
// of their lives.
physics::Vec3 curl_noise(const CurlNoise& noise, physics::Vec3 point, double time);

}  // namespace jostle::modules::fields_detail
