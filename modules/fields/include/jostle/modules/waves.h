// SPDX-License-Identifier: MIT
//
// Water with waves: a surface of summed sinusoids over deep water (G. B. Airy, "Tides and waves",
// 1845). Up is +y. A component with wave number k = 2 pi / length travels along its direction d
// with omega = sqrt(g k):
//     height = level + sum a cos(k d.x - omega t + phase)
// Below the surface, its pressure and flow decay by exp(-k depth). The depth is measured from the
// moving surface (J. D. Wheeler, "Method for calculating forces produced by irregular waves",
// 1970), so the pressure at the surface is zero.
#pragma once

#include <vector>

#include "jostle/physics/vec3.h"

namespace jostle::modules {

/// One sinusoidal wave.
struct WaveComponent {
    double amplitude = 0.2;  ///< m, 0 to 100: half the height from trough to crest
    double length = 10;      ///< m, 0.1 to 1e4: distance between crests
    double heading = 0;      ///< rad from x towards z, within 1e3: direction of travel
    double phase = 0;        ///< rad, within 1e3

    bool operator==(const WaveComponent&) const = default;
};
/// Maximum number of components of one water.
inline constexpr std::size_t wave_components_max = 8;

/// A fluid that floats bodies. The pressure acts on each panel of a body's surface that is under
/// water, clipped at the waterline. In still water, the buoyancy equals the weight of the displaced
/// fluid, exactly for boxes and hulls of any size. Round shapes have 12 panels around their axis
/// and keep their exact volume: they float exactly when upright, and within 1 % of their radius
/// when lying. Balls smaller than an eighth of the shortest wave are clipped by the tangent plane
/// of the surface, in closed form.
///
/// Along waves, panels are at most an eighth of the shortest wave long, limited by `panels_max`.
/// The error of the wave force is within 2 % of the largest wave force on the body and grows with
/// the square of the panel length. Bodies generate no waves: there is no added mass and no
/// sheltering.
struct Waves {
    double level = 0;                            ///< m, y of the surface at rest
    double density = 1000;                       ///< kg/m^3, 0 to 1e6
    std::vector<WaveComponent> components = {};  ///< at most wave_components_max
    physics::Vec3 flow = {};  ///< m/s, current in addition to the flow of the waves
    /// Coefficient of quadratic drag on the wetted projected area, 0 to 1e6. It acts on the motion
    /// of the centre of mass and on the rotation, each integrated exactly in the sub-step.
    double drag = 1;
    /// Wave-making loss, 1/s, 0 to 1e4, scaled by the displaced mass over the body's mass. It damps
    /// motion relative to the water and rotation.
    double damping = 0.2;

    bool operator==(const Waves&) const = default;
};
/// Maximum number of panels of one body.
inline constexpr std::size_t panels_max = 1024;

/// State of the water at a position and time.
struct WaterSample {
    double height = 0;            ///< m, y of the surface above or below the position
    double head = 0;              ///< m of water, pressure / (density g); 0 above the surface
    physics::Vec3 velocity = {};  ///< m/s; 0 above the surface
};
/// Evaluates the water at a point (m) and time (s). `gravity` is downwards, m/s^2, > 0.
WaterSample water_at(const Waves& waves, double gravity, physics::Vec3 point, double time);

}  // namespace jostle::modules
