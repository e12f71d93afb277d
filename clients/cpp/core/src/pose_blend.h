// SPDX-License-Identifier: MIT
//
// Interpolation of poses.
#pragma once

#include <cmath>

#include "jostle/snapshot/quantize.h"

namespace jostle::client {

inline constexpr double teleport_speed_m_s = 100;
inline constexpr double extrapolation_max_us = 50'000;  // rendered beyond the newest frame

inline double distance(const snapshot::Pose& a, const snapshot::Pose& b) {
    return std::hypot(b.position[0] - a.position[0], b.position[1] - a.position[1],
                      b.position[2] - a.position[2]);
}

// Whether the distance is too large for continuous motion.
inline bool is_teleport(const snapshot::Pose& a, const snapshot::Pose& b, double width_us) {
    return distance(a, b) * 1e6 > teleport_speed_m_s * width_us;
}

// Interpolates for t in 0..1 and extrapolates beyond 1.
inline snapshot::Pose blend(const snapshot::Pose& a, const snapshot::Pose& b, double t) {
    snapshot::Pose out;
    double dot = 0, norm = 0;
    for (std::size_t k = 0; k < 3; k++)
        out.position[k] = a.position[k] + t * (b.position[k] - a.position[k]);
    for (std::size_t k = 0; k < 4; k++) dot += a.rotation[k] * b.rotation[k];
    // Normalized linear interpolation along the shorter arc, sufficient for small steps.
    for (std::size_t k = 0; k < 4; k++) {
        const double to = dot < 0 ? -b.rotation[k] : b.rotation[k];
        out.rotation[k] = a.rotation[k] + t * (to - a.rotation[k]);
        norm += out.rotation[k] * out.rotation[k];
    }
    for (double& c : out.rotation) c /= std::sqrt(norm);
    return out;
}

}  // namespace jostle::client
