// SPDX-License-Identifier: MIT
#include "jostle/modules/volume.h"

namespace jostle::modules {

using namespace physics;

namespace {

struct ContainsPoint {
    Vec3 point;

    bool operator()(const Everywhere&) const { return true; }
    bool operator()(const BoxVolume& box) const {
        const Vec3 p = abs(apply_inverse(box.pose, point)), h = box.half_extents;
        return p.x <= h.x && p.y <= h.y && p.z <= h.z;
    }
    bool operator()(const SphereVolume& sphere) const {
        return length_squared(point - sphere.center) <= sphere.radius * sphere.radius;
    }
    bool operator()(const CapsuleVolume& capsule) const {
        const Vec3 along = capsule.to - capsule.from, from = point - capsule.from;
        const double squared_length = length_squared(along);
        const double share =
            squared_length > 0 ? clamp(dot(from, along) / squared_length, 0, 1) : 0;
        return length_squared(from - along * share) <= capsule.radius * capsule.radius;
    }
};

}  // namespace

bool contains(const Volume& volume, Vec3 point) {
    return std::visit(ContainsPoint{point}, volume);
}

}  // namespace jostle::modules
