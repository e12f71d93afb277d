// SPDX-License-Identifier: MIT
//
// The limits of what callers may ask for: a call beyond them returns an Error that names them.
#pragma once

namespace jostle::physics::limits {

inline constexpr double max_coordinate = 1e7;  // m
inline constexpr double max_speed = 1e4;       // m/s and rad/s that a caller may set
inline constexpr double max_density = 1e6;     // kg/m^3
inline constexpr int max_substeps = 64;
inline constexpr int max_threads = 64;

}  // namespace jostle::physics::limits
