// SPDX-License-Identifier: MIT
//
// Where faces of two convex solids lie on each other.
#pragma once

#include <vector>

#include "modules/destruction/src/convex_cell.h"

namespace jostle::modules::destruction_detail {

// Of the size: faces that are so near and so parallel lie on each other.
inline constexpr double face_contact_tolerance_ratio = 1e-6;

struct FaceContact {
    physics::Vec3 normal;               // unit, from a to b
    std::vector<physics::Vec3> points;  // what both faces cover, in order about the normal
};

std::vector<FaceContact> face_contacts(const ConvexCell& a, const ConvexCell& b, double near);

}  // namespace jostle::modules::destruction_detail
