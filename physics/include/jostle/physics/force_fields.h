// SPDX-License-Identifier: MIT
//
// Force fields: forces on every dynamic body in a region, evaluated in every sub-step at the body's
// current position. Fields are part of the world's state: they are saved, hashed and restored. A
// field does not wake bodies by itself: bodies asleep in a steady wind stay asleep. Creating,
// changing or destroying a field wakes the bodies in its region. For other force laws, use
// StepListener::before_substep().
#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include "jostle/physics/aabb.h"
#include "jostle/physics/ids.h"

namespace jostle::physics {

/// A medium that flows past bodies, with quadratic drag: F = density / 2 * drag * area * |u| u,
/// where u is the velocity of the medium relative to the body's centre of mass. The area is the
/// projection of the body's shapes along the flow: exact for a convex shape, the sum for several
/// shapes. The change of speed within a sub-step is integrated exactly, so any drag is stable. Not
/// available in planar worlds.
struct UniformWind {
    Vec3 velocity = {};  ///< m/s, each component within 1e4
    Vec3 gust = {};      ///< m/s, each component within 1e4; added times sin(2 pi t / gust_period)
    double gust_period = 1;  ///< s, 1e-3 to 1e12
    double density = 1.2;    ///< kg/m^3, 0 to 1e6; the default is air
    double drag = 1;         ///< drag coefficient, 0 to 1e6: about 0.5 for a sphere, 1 for a box

    bool operator==(const UniformWind&) const = default;
};

/// A central force away from a point: F = strength / max(r, min_distance)^falloff. The strength is
/// in N, or in m/s^2 and multiplied by the mass if `per_mass` is set (at r = 1 m).
struct RadialField {
    Vec3 center = {};           ///< m, each component within 1e7
    double strength = 0;        ///< -1e12 to 1e12; > 0 pushes away, < 0 pulls
    int falloff = 2;            ///< exponent, 0 to 4
    double min_distance = 0.1;  ///< m, 1e-6 to 1e12; the force is constant within this radius
    bool per_mass = false;      ///< whether the strength is an acceleration

    bool operator==(const RadialField&) const = default;
};

/// A vortex about an axis, by the right-hand rule: the tangential force is strength / max(r,
/// min_distance)^falloff. `pull` and `lift` give the forces towards and along the axis by the same
/// law.
struct VortexField {
    Vec3 center = {};           ///< m, a point on the axis; each component within 1e7
    Vec3 axis = {0, 1, 0};      ///< unit vector
    double strength = 0;        ///< -1e12 to 1e12, of the tangential force
    double pull = 0;            ///< -1e12 to 1e12; > 0: towards the axis
    double lift = 0;            ///< -1e12 to 1e12; > 0: along the axis
    int falloff = 1;            ///< exponent, 0 to 4
    double min_distance = 0.1;  ///< m, 1e-6 to 1e12; the force is constant within this radius
    bool per_mass = false;      ///< whether the strengths are accelerations

    bool operator==(const VortexField&) const = default;
};

/// A fluid below a plane. Buoyancy is the weight of the displaced fluid and acts at the centre of
/// the displaced volume. The volume is exact for spheres, boxes and hulls, and accurate to 1e-6 of
/// the shape's volume for capsules, cylinders and cones. Drag acts on the submerged part: quadratic
/// drag with the projected area of the whole shape, and angular damping by `angular_drag`. Meshes,
/// height fields and planes displace nothing. Not available in planar worlds.
struct BuoyancyField {
    Vec3 normal = {0, 1, 0};  ///< unit vector out of the fluid
    double offset = 0;        ///< m, within 1e7: the surface is where dot(normal, p) == offset
    double density = 1000;    ///< kg/m^3, 0 to 1e6
    Vec3 flow = {};           ///< velocity of the fluid, m/s, each component within 1e4
    double drag = 1;          ///< drag coefficient, 0 to 1e6
    double angular_drag = 1;  ///< 1/s, 0 to 1e6, times the displaced mass over the body's mass

    bool operator==(const BuoyancyField&) const = default;
};

/// The force law of a field.
using ForceField = std::variant<UniformWind, RadialField, VortexField, BuoyancyField>;

/// Description of a force field for World::create_field().
struct FieldDef {
    ForceField force = UniformWind{};  ///< the force law
    /// The field acts on bodies whose centre of mass is in this box; if empty, everywhere. A body
    /// that an impact moves into the box is affected from the next step.
    std::optional<Aabb> region = {};
    /// The field acts on bodies with a shape whose category has a bit in this mask.
    std::uint32_t mask = 0xffffffff;
    std::uint64_t user_data = 0;  ///< stored, saved and returned, not interpreted
};

/// Effect of a field on matter of a module at a point.
struct FieldSample {
    Vec3 acceleration = {};  ///< m/s^2, of any mass
    Vec3 force = {};         ///< N, on each piece of matter, whatever its mass
    /// The medium at the point: its velocity in m/s, density in kg/m^3 and drag coefficient, for
    /// F = density / 2 * drag * area * |u| u. Density 0: no medium.
    Vec3 flow = {};
    double density = 0, drag = 0;
};

/// Evaluates a field at a point (m) and time (s), World::time(). Nothing outside of its region or,
/// for a fluid, above its surface. Masks are not applied. Thread-safe.
FieldSample sample(const FieldDef& field, Vec3 point, double time);

}  // namespace jostle::physics
