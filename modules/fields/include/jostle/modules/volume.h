// SPDX-License-Identifier: MIT
//
// Where a field acts: bodies whose centre of mass is in the volume.
#pragma once

#include <variant>

#include "jostle/physics/transform.h"

namespace jostle::modules {

struct Everywhere {
    bool operator==(const Everywhere&) const = default;
};
struct BoxVolume {
    physics::Transform pose = {};
    physics::Vec3 half_extents = {1, 1, 1};  // m, each 1e-3 to 1e7

    bool operator==(const BoxVolume&) const = default;
};
struct SphereVolume {
    physics::Vec3 center = {};
    double radius = 1;  // m, 1e-3 to 1e7

    bool operator==(const SphereVolume&) const = default;
};
// What is no further than the radius from the segment.
struct CapsuleVolume {
    physics::Vec3 from = {}, to = {0, 1, 0};
    double radius = 1;  // m, 1e-3 to 1e7

    bool operator==(const CapsuleVolume&) const = default;
};

using Volume = std::variant<Everywhere, BoxVolume, SphereVolume, CapsuleVolume>;

bool contains(const Volume& volume, physics::Vec3 point);

}  // namespace jostle::modules
