// SPDX-License-Identifier: MIT
//
// Limits shared by many calls. A call that exceeds a limit returns an Error that names it. Limits
// of a single argument are documented with that argument.
#pragma once

namespace jostle::physics::limits {

inline constexpr double max_coordinate = 1e7;  ///< m, each component of a position
inline constexpr double max_speed = 1e4;       ///< m/s or rad/s, each component that a caller sets
inline constexpr double max_density = 1e6;     ///< kg/m^3
/// Range of an explicit mass, in kg. Below the minimum, an inertia may have no inverse that a float
/// can represent.
inline constexpr double min_mass = 1e-9, max_mass = 1e15;
inline constexpr int max_substeps = 64;              ///< WorldDef::substeps
inline constexpr int max_threads = 64;               ///< WorldDef::threads
inline constexpr int max_pairs_per_shape = 1000000;  ///< WorldDef::max_pairs_per_shape

}  // namespace jostle::physics::limits
