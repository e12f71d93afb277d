// SPDX-License-Identifier: MIT
//
// Limits that many calls share. A call beyond one returns an Error that names it. The range of any
// other argument stands beside it.
#pragma once

namespace jostle::physics::limits {

inline constexpr double max_coordinate = 1e7;  // m, of each component of a position
inline constexpr double max_speed = 1e4;       // m/s or rad/s, of each component that a caller sets
inline constexpr double max_density = 1e6;     // kg/m^3
// kg, of a mass that is given: with less an inertia may have no inverse that floats hold.
inline constexpr double min_mass = 1e-9, max_mass = 1e15;
inline constexpr int max_substeps = 64;
inline constexpr int max_threads = 64;

}  // namespace jostle::physics::limits
