// SPDX-License-Identifier: MIT
//
// A blast at a moment: pressure on what sees its centre. Each convex shape is covered with points
// that stand for equal areas; a ray from the centre to each finds what is in the way. A point that
// is seen takes
//     impulse = strength * (core / max(r, core))^falloff * fade * area * cos,
// away from the centre and at the point, with cos that of the angle between its normal and the way
// to the centre. So what a wall takes is what those behind it do not get. With falloff 2 and no
// fade each shape takes in proportion to the solid angle that it fills, and all that surrounds a
// blast takes nothing in sum.
//
//     world thread, between steps: explode(world, {.center = {0, 1, 0}, .strength =
//     2000}).expect();
#pragma once

#include <cstdint>

#include "jostle/physics/vec3.h"

namespace jostle::modules {

struct Explosion {
    physics::Vec3 center = {};
    double radius = 10;         // m, 1e-3 to 1e4: nothing beyond
    double strength = 1000;     // N s/m^2, 0 to 1e9: overpressure times its duration, at the core
    double core = 1;            // m, 1e-3 to 1e4: no stronger nearer than that
    std::uint32_t falloff = 2;  // 0 to 4
    bool fade = true;           // times 1 - r / radius, so that it ends softly
    // m, 0 to 100: a centre that lies nearer to a surface, as one that was clicked at, is moved so
    // far out of it first. Without: a solid that holds the centre hides nothing, and what pushes
    // its surface from inside does not move it.
    double standoff = 0;
    std::uint32_t points = 64;        // of each shape, about; 6 to 1024
    std::uint32_t mask = 0xffffffff;  // pushes bodies one of whose shapes has a category in it
    // m/s that it may give a body, 0 to 1e4; 0: 1e4.
    double most_speed = 0;

    bool operator==(const Explosion&) const = default;
};

}  // namespace jostle::modules
