// SPDX-License-Identifier: MIT
//
// A field of the Fields module: law, volume and mask. Also charges.
#pragma once

#include <compare>
#include <cstdint>
#include <variant>

#include "jostle/modules/explosion.h"
#include "jostle/modules/turbulence.h"
#include "jostle/modules/user_field.h"
#include "jostle/modules/volume.h"
#include "jostle/modules/waves.h"
#include "jostle/physics/ids.h"

namespace jostle::modules {

/// Attraction to a body or to a fixed point. The force is F = strength / max(r,
/// min_distance)^falloff, in N, or an acceleration in m/s^2 if per_mass is set. There is no
/// reaction on the attracting body. When it has moved 0.25 m, it wakes the bodies that it
/// accelerates noticeably (by more than 0.05 m/s^2).
struct Central {
    physics::BodyId body = {};  ///< null attracts to `point`; a destroyed body has no effect
    physics::Vec3 point = {};   ///< m; with a body, an offset from its centre of mass in world axes
    double strength = 100;      ///< within 1e12; negative repels
    std::uint32_t falloff = 2;  ///< exponent of the decay with distance, 0 to 4
    double min_distance = 0.5;  ///< m, 1e-6 to 1e6: the force is constant within this distance
    bool per_mass = false;      ///< if true, the law gives an acceleration, m/s^2

    bool operator==(const Central&) const = default;
};

/// A force law.
using FieldLaw = std::variant<Central, Turbulence, UserField, Waves>;

/// A force law in a volume.
struct VolumeField {
    FieldLaw law = Turbulence{};
    Volume volume = Everywhere{};
    /// Acts on bodies with a shape that has a category in the mask.
    std::uint32_t mask = 0xffffffff;

    bool operator==(const VolumeField&) const = default;
};

/// An explosion at a set time.
struct Charge {
    /// s, world time, 0 to 1e12: explodes before the first step that begins at or after it
    double time = 0;
    Explosion explosion = {};

    bool operator==(const Charge&) const = default;
};

/// Identifies a field of a module. Keys are never reused.
struct FieldKey {
    std::uint32_t number = 0;

    auto operator<=>(const FieldKey&) const = default;
};

}  // namespace jostle::modules
