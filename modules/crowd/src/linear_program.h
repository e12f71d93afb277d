// SPDX-License-Identifier: MIT
//
// Chooses a velocity under linear constraints: the velocity nearest to the wish that satisfies all
// half-planes, or, if there is none, the one that violates them least. Single precision: the error
// is below 1e-5 m/s at walking speed, and keep_apart() corrects overlaps afterwards.
//
// Source: J. van den Berg, S. Guy, M. Lin, D. Manocha, "Reciprocal n-Body Collision Avoidance"
// (ISRR 2009, Springer 2011), sections 5.1 and 5.3; incremental linear programming in M. de Berg et
// al., "Computational Geometry", chapter 4.
#pragma once

#include <cstddef>
#include <span>

namespace jostle::modules::crowd_detail {

struct Velocity2 {
    float x = 0, y = 0;  // m/s
};

// Permits the velocities v with x * v.x + y * v.y >= offset.
struct HalfPlane {
    float x = 0, y = 0;  // normal, unit
    float offset = 0;    // m/s
};

// Maximum number of half-planes of one agent: neighbours and walls.
inline constexpr std::size_t half_planes_max = 32;

// Returns the permitted velocity nearest to `wish`, at most `max_speed` long. The first `hard`
// planes are obeyed if any velocity does so; if the others cannot be satisfied together, their
// largest violation is minimized. planes.size() must be at most half_planes_max.
Velocity2 nearest_permitted_velocity(std::span<const HalfPlane> planes, std::size_t hard,
                                     Velocity2 wish, float max_speed);

}  // namespace jostle::modules::crowd_detail
