// SPDX-License-Identifier: MIT
//
// Corrects the velocities of discs, or of balls, so that no two of them overlap after the step: the
// smallest change, weighted by mass, for which no pair closes more than its gap.
//
// Distance is a convex function of the positions, so the linear constraint
//     gap + dt * dot(n, v_b - v_a) >= 0,  n: unit vector from a to b,
// is sufficient: the discs are apart after the step at any speed. Source: B. Maury, J. Venel, "A
// discrete contact model for crowd motion", ESAIM: M2AN 45 (2011). Solved by projected Gauss-Seidel
// iteration in order of the contacts.
#pragma once

#include <cstdint>
#include <span>

#include "jostle/physics/vec3.h"

namespace jostle::modules::crowd_detail {

struct DiscContact {
    std::uint32_t a = 0, b = 0;
    physics::Vec3 normal;  // unit, from a to b
    double gap = 0;        // m, negative if the discs overlap
    double share = 0.5;    // part of the correction that a takes; 0 to 1
    double impulse = 0;    // m/s, of the correction so far
};

struct WallContact {
    std::uint32_t agent = 0;
    physics::Vec3 normal;  // unit, away from the wall
    double gap = 0;        // m
    double impulse = 0;    // m/s
};

struct KeepApartResult {
    int iterations = 0;
    double overlap = 0;  // m, largest violation that is left
};

// Corrects the velocities until no constraint is violated by more than `tolerance` m, at most
// `iterations_max` times.
KeepApartResult keep_apart(std::span<physics::Vec3> velocities, std::span<DiscContact> discs,
                           std::span<WallContact> walls, double dt, double tolerance,
                           int iterations_max);

}  // namespace jostle::modules::crowd_detail
