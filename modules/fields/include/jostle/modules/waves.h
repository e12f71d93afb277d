// SPDX-License-Identifier: MIT
//
// Water with waves: a surface of summed sinusoids over deep water (G. B. Airy, "Tides and waves",
// 1845), up is y. Of a component with wave number k = 2 pi / length the crests run with
// omega = sqrt(g k) along its direction:
//     height = level + sum a cos(k d.x - omega t + phase)
// Below the surface its pressure and its flow fade by exp(-k depth), with the depth counted from
// the surface itself (Wheeler, "Method for calculating forces produced by irregular waves", 1970),
// so that the pressure at the surface is zero.
#pragma once

#include <vector>

#include "jostle/physics/vec3.h"

namespace jostle::modules {

struct WaveComponent {
    double amplitude = 0.2;  // m, 0 to 100: half of what lies between trough and crest
    double length = 10;      // m, 0.1 to 1e4, from crest to crest
    double heading = 0;      // rad from x to z, within 1e3: where crests go
    double phase = 0;        // rad, within 1e3

    bool operator==(const WaveComponent&) const = default;
};
inline constexpr std::size_t wave_components_max = 8;

// A fluid that carries bodies. Pressure on each panel of a body's surface that is under water,
// clipped at the waterline: in still water the lift is the weight of what is displaced, exact for
// boxes and hulls of any size. Round shapes have 12 panels about their axis, which hold their exact
// volume: upright they float exactly, and lying within 1 % of their radius. Balls smaller than an
// eighth of the shortest wave are cut by the tangent plane of the surface, in closed form.
//
// Along waves panels are at most an eighth of the shortest wave long, or as many as `panels_max`
// allows. What the waves add to the force is then within 2 % of the most that they can do to the
// body; it grows with the square of the panels' length. Bodies make no waves of their own: no added
// mass, and nothing is in another's lee.
struct Waves {
    double level = 0;                            // m, of the surface at rest
    double density = 1000;                       // kg/m^3, 0 to 1e6
    std::vector<WaveComponent> components = {};  // at most wave_components_max
    physics::Vec3 flow = {};                     // m/s, of the water beside the waves' own
    // Quadratic, on the wetted projected area, for the way of the centre and for the spin, each
    // integrated exactly in the sub-step.
    double drag = 1;  // coefficient, 0 to 1e6
    // 1/s, 0 to 1e4, times the displaced mass over the body's: what a body loses to waves of its
    // own, of the motion against the water and of the spin.
    double damping = 0.2;

    bool operator==(const Waves&) const = default;
};
// Of one body.
inline constexpr std::size_t panels_max = 1024;

// The water at a place and time.
struct WaterSample {
    double height = 0;            // m, y of the surface over that place
    double head = 0;              // m of water: pressure / (density g); 0 above the surface
    physics::Vec3 velocity = {};  // m/s; 0 above the surface
};
// `gravity` in m/s^2, downwards, > 0.
WaterSample water_at(const Waves& waves, double gravity, physics::Vec3 point, double time);

}  // namespace jostle::modules
