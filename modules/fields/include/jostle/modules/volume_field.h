// SPDX-License-Identifier: MIT
//
// A field of the module: which law, where, on whom. And charges.
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

// Towards a body, or a point that stays: F = strength / max(r, nearest)^falloff, N; times the mass
// if `per_mass`, m/s^2. The body that attracts is not pulled itself, and where it goes wakes those
// that it pulls noticeably (by more than 0.05 m/s^2) each 0.25 m.
struct Central {
    physics::BodyId body = {};  // null: the point. One that is destroyed attracts no more.
    physics::Vec3 point = {};   // m; of a body: from its centre of mass, world axes
    double strength = 100;      // within 1e12; < 0 pushes away
    std::uint32_t falloff = 2;  // 0 to 4
    double nearest = 0.5;       // m, 1e-6 to 1e6
    bool per_mass = false;

    bool operator==(const Central&) const = default;
};

using FieldLaw = std::variant<Central, Turbulence, UserField, Waves>;

struct VolumeField {
    FieldLaw law = Turbulence{};
    Volume volume = Everywhere{};
    // Bodies one of whose shapes has a category with a bit in the mask.
    std::uint32_t mask = 0xffffffff;

    bool operator==(const VolumeField&) const = default;
};

struct Charge {
    double time = 0;  // s, of the world: goes off before the first step that begins then or later
    Explosion explosion = {};

    bool operator==(const Charge&) const = default;
};

// Names a field of a module; never used twice.
struct FieldKey {
    std::uint32_t number = 0;

    auto operator<=>(const FieldKey&) const = default;
};

}  // namespace jostle::modules
