// SPDX-License-Identifier: MIT
//
// Finds coplanar contact areas between faces of two convex solids.
#pragma once

#include <vector>

#include "modules/destruction/src/convex_cell.h"

namespace jostle::modules::destruction_detail {

// Relative to the size: faces within this distance and angle are in contact.
inline constexpr double face_contact_tolerance_ratio = 1e-6;

struct FaceContact {
    physics::Vec3 normal;               // unit, from a to b
    std::vector<physics::Vec3> points;  // common area of both faces, in order about the normal
};

std::vector<FaceContact> face_contacts(const ConvexCell& a, const ConvexCell& b, double near);

}  // namespace jostle::modules::destruction_detail
