// SPDX-License-Identifier: MIT
//
// Force fields: what acts on every dynamic body in a region, evaluated in every sub-step where the
// body then is. Part of the world's state: saved, hashed, restored. A field wakes nobody by itself:
// what sleeps in a steady wind sleeps on. To create, change or destroy one wakes what is in its
// region. A force law of your own: StepListener::before_substep.
#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include "jostle/physics/aabb.h"
#include "jostle/physics/ids.h"

namespace jostle::physics {

// A medium that flows past bodies: quadratic drag, F = density / 2 * drag * area * |u| u, with u
// the medium's velocity against the body's centre. The area is what the body's shapes show to the
// flow: exact for a convex shape; of several the sum. The change of speed within a sub-step is
// integrated exactly, so no drag is too strong.
struct UniformWind {
    Vec3 velocity = {};      // m/s
    Vec3 gust = {};          // m/s, added times sin(2 pi t / gust_period)
    double gust_period = 1;  // s, > 0
    double density = 1.2;    // kg/m^3, >= 0: air
    double drag = 1;         // coefficient, >= 0: sphere about 0.5, box about 1

    bool operator==(const UniformWind&) const = default;
};

// Away from a point, or towards it: F = strength / max(r, nearest)^falloff, N; times the mass if
// `per_mass`, m/s^2.
struct RadialField {
    Vec3 center = {};      // m
    double strength = 0;   // > 0 pushes away, < 0 pulls
    int falloff = 2;       // 0 to 4
    double nearest = 0.1;  // m, > 0
    bool per_mass = false;

    bool operator==(const RadialField&) const = default;
};

// Around an axis, by the right hand: F = strength / max(r, nearest)^falloff along the tangent, and
// likewise towards the axis and along it.
struct VortexField {
    Vec3 center = {};       // m, on the axis
    Vec3 axis = {0, 1, 0};  // unit
    double strength = 0;    // of the tangential part
    double pull = 0;        // > 0: towards the axis
    double lift = 0;        // > 0: along the axis
    int falloff = 1;        // 0 to 4
    double nearest = 0.1;   // m, > 0
    bool per_mass = false;

    bool operator==(const VortexField&) const = default;
};

// A fluid below a plane. Lift is the weight of what the body displaces, at its centre: the volume
// below the surface is exact for spheres, boxes and hulls, and to 1e-6 of the volume for capsules,
// cylinders and cones. Drag acts on what is submerged, at its centre: quadratic with the area that
// the whole shape shows to the flow, and on the spin by `angular_drag`. Meshes, height fields and
// planes displace nothing.
struct BuoyancyField {
    Vec3 normal = {0, 1, 0};  // unit, out of the fluid
    double offset = 0;        // m: the surface is where dot(normal, p) == offset
    double density = 1000;    // kg/m^3, >= 0
    Vec3 flow = {};           // m/s
    double drag = 1;          // coefficient, >= 0
    double angular_drag = 1;  // 1/s, >= 0, times the displaced mass over the body's

    bool operator==(const BuoyancyField&) const = default;
};

using ForceField = std::variant<UniformWind, RadialField, VortexField, BuoyancyField>;

struct FieldDef {
    ForceField force = UniformWind{};
    // Bodies whose centre of mass is in the box; absent: everywhere. One that an impact throws into
    // it feels the field from the next step on.
    std::optional<Aabb> region = {};
    // Bodies one of whose shapes has a category with a bit in the mask.
    std::uint32_t mask = 0xffffffff;
    std::uint64_t user_data = 0;  // kept, saved and returned, never read
};

}  // namespace jostle::physics
