// SPDX-License-Identifier: MIT
//
// An instantaneous explosion: pressure on every surface that is visible from its centre. Each
// convex shape is covered with points that represent equal areas. A ray from the centre to each
// point finds occluders. A visible point receives the impulse
//     strength * (core / max(r, core))^falloff * fade * area * cos,
// away from the centre, at the point. cos is the cosine of the angle between the surface normal and
// the direction to the centre. An occluder therefore receives the impulse that it shields from the
// bodies behind it.
//
// With falloff 2 and without fade, each shape receives an impulse proportional to the solid angle
// that it covers. The impulses on surroundings that enclose the explosion completely sum to zero.
//
//     // On the world thread, between steps:
//     explode(world, {.center = {0, 1, 0}, .strength = 2000}).expect();
#pragma once

#include <cstdint>

#include "jostle/physics/vec3.h"

namespace jostle::modules {

/// Parameters of an explosion.
struct Explosion {
    /// m, within the coordinate range of the world.
    physics::Vec3 center = {};
    double radius = 10;         ///< m, 1e-3 to 1e4; the effect is zero beyond it
    double strength = 1000;     ///< N s/m^2, 0 to 1e9: overpressure times duration within the core
    double core = 1;            ///< m, 1e-3 to 1e4: the strength is constant within this distance
    std::uint32_t falloff = 2;  ///< exponent of the decay with distance, 0 to 4
    /// Multiplies by 1 - r / radius, so that the effect ends smoothly at the radius.
    bool fade = true;
    /// Minimum distance of the centre from surfaces, m, 0 to 100. A centre that is nearer to a
    /// surface, such as a clicked point, is moved away from it first. With 0, a solid that contains
    /// the centre hides nothing, and the pressure on its surface from inside does not move it.
    double standoff = 0;
    std::uint32_t points = 64;  ///< approximate number of surface points per shape, 6 to 1024
    /// Affects bodies with a shape that has a category in the mask.
    std::uint32_t mask = 0xffffffff;
    /// Maximum velocity change of a body, m/s, 0 to 1e4; 0 means 1e4.
    double max_speed = 0;

    bool operator==(const Explosion&) const = default;
};

}  // namespace jostle::modules
