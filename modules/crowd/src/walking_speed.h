// SPDX-License-Identifier: MIT
//
// Speed of pedestrians in a crowd. Source: U. Weidmann, "Transporttechnik der Fussgänger", IVT ETH
// Zürich, 1993: the fundamental diagram
//     v = 1.34 m/s * (1 - exp(-1.913 / m^2 * (1 / density - 1 / (5.4 / m^2)))).
//
// Each walker applies it to the density that it sees ahead, like the density-dependent filter of
// A. Best, S. Narang, S. Curtis, D. Manocha, "DenseSense: interactive crowd simulation using
// density-dependent filters", SCA 2014.
#pragma once

#include <span>

#include "jostle/physics/vec2.h"
#include "modules/crowd/src/wall_tree.h"

namespace jostle::modules::crowd_detail {

// Returns the speed relative to the free speed, 0.02 to 1. density: persons per m^2.
double relative_walking_speed(double density);

// Density, 1/m^2, ahead of a walker, in the half disc that just contains its farthest neighbour.
// `radius`: its radius, m; `ahead`: number of neighbours in it, of which one on the border counts
// half. Parts behind walls do not count.
double density_ahead(double radius, double ahead, std::span<const NearWall> walls);

}  // namespace jostle::modules::crowd_detail
