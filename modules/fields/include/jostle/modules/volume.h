// SPDX-License-Identifier: MIT
//
// Volumes of fields. A field acts on bodies whose centre of mass is in its volume.
#pragma once

#include <variant>

#include "jostle/physics/transform.h"

namespace jostle::modules {

/// All of space.
struct Everywhere {
    bool operator==(const Everywhere&) const = default;
};
/// A box.
struct BoxVolume {
    /// Centre and orientation; a unit quaternion.
    physics::Transform pose = {};
    physics::Vec3 half_extents = {1, 1, 1};  ///< m, each 1e-3 to 1e7

    bool operator==(const BoxVolume&) const = default;
};
/// A ball.
struct SphereVolume {
    /// m.
    physics::Vec3 center = {};
    double radius = 1;  ///< m, 1e-3 to 1e7

    bool operator==(const SphereVolume&) const = default;
};
/// All points within `radius` of a segment.
struct CapsuleVolume {
    /// End points of the segment, m.
    physics::Vec3 from = {}, to = {0, 1, 0};
    double radius = 1;  ///< m, 1e-3 to 1e7

    bool operator==(const CapsuleVolume&) const = default;
};

/// A volume of a field.
using Volume = std::variant<Everywhere, BoxVolume, SphereVolume, CapsuleVolume>;

/// Returns true if the point (m) is in the volume.
bool contains(const Volume& volume, physics::Vec3 point);

}  // namespace jostle::modules
