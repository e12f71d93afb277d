// SPDX-License-Identifier: MIT
//
// Divergence-free flow from hashed lattice noise, as the curl of a vector potential A. Each lattice
// corner c has the potential A_c = b_c x (p - c) / 2 of a uniform flow b_c, which is hashed.
// Between corners, potentials are blended with the weights W of Perlin's quintic (K. Perlin,
// "Improving noise", SIGGRAPH 2002). In closed form,
//     u = curl A = sum over corners of grad W x A_c + W b_c,
// whose divergence is zero (R. Bridson et al., "Curl-noise for procedural fluid flow", SIGGRAPH
// 2007), and u(c) = b_c. In time, consecutive lattices are blended with the weights cos and sin,
// whose squares sum to 1, so the strength of the flow is constant in time. All derivatives are
// analytic.
//
// In all functions, `point` is in units of the size of the largest eddies, each component within
// 1e15, and `time` in units of their lifetime. Thread-safe; the same bits on every machine.
#pragma once

#include <cstdint>

#include "jostle/physics/mat3.h"

namespace jostle::modules {

/// Selects a noise.
struct CurlNoise {
    std::uint32_t seed = 1;  ///< selects the random flow
    /// Number of octaves, each of half the size and 2^(2/3) times the rate of the previous one, and
    /// weaker by 2^(1/3) (Kolmogorov).
    std::uint32_t octaves = 3;
    /// Number of corners after which the lattice of the first octave repeats, a power of two; 0
    /// means never.
    std::uint32_t period = 0;
};

/// The noise at a point.
struct CurlNoiseSample {
    physics::Vec3 potential;  ///< A; its curl is the flow
    physics::Vec3 flow;       ///< mean 0, root mean square 1
};

/// Returns a flow with mean 0 and root mean square 1.
physics::Vec3 curl_noise(const CurlNoise& noise, physics::Vec3 point, double time);

/// Returns the flow of curl_noise() and its potential, for flows that are blended with other
/// potentials.
CurlNoiseSample curl_noise_sample(const CurlNoise& noise, physics::Vec3 point, double time);

/// Returns the derivatives of curl_noise() along x, y and z, as columns. The trace, which is the
/// divergence, is zero up to rounding.
physics::Mat3 curl_noise_gradient(const CurlNoise& noise, physics::Vec3 point, double time);

/// Returns a flow in the xy plane: the potential is along z and taken at z = 0, so the flow has no
/// divergence in the plane.
CurlNoiseSample planar_curl_noise(const CurlNoise& noise, physics::Vec3 point, double time);

}  // namespace jostle::modules
