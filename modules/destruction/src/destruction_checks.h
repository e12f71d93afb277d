// SPDX-License-Identifier: MIT
//
// Validity checks for shapes, definitions and limits of destructibles.
#pragma once

#include "jostle/modules/destruction.h"

namespace jostle::modules::destruction_detail {

inline constexpr std::size_t destructibles_max = 10000;
inline constexpr std::size_t bonds_max = 16 * chunks_max;

// Ranges of values in definitions and saved state.
inline constexpr double coordinate_max = 1e5;               // m, in the frame of a destructible
inline constexpr double area_min = 1e-12, area_max = 1e10;  // m^2
inline constexpr double second_moment_min = 1e-26, second_moment_max = 1e20;  // m^4
inline constexpr double mass_min = 1e-12, mass_max = 1e15;                    // kg
inline constexpr double inertia_max = 1e22;                                   // kg m^2

physics::Status check_limits(const DestructionLimits& limits);
physics::Status check_shape(const FracturedShape& shape);
physics::Status check_def(const DestructibleDef& def);

}  // namespace jostle::modules::destruction_detail
