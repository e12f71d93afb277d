// SPDX-License-Identifier: MIT
#include "modules/destruction/src/fracture_cells.h"

namespace jostle::modules::destruction_detail {

using namespace physics;

namespace {

constexpr double parallel = 1 - 1e-9;  // cosine

// The part of a flat polygon with dot(side, x) <= offset.
std::vector<Vec3> cut_off(const std::vector<Vec3>& points, Vec3 side, double offset) {
    std::vector<Vec3> clipped;
    for (std::size_t k = 0; k < points.size(); k++) {
        const Vec3 p = points[k], q = points[k + 1 == points.size() ? 0 : k + 1];
        const double hp = dot(side, p) - offset, hq = dot(side, q) - offset;
        if (hp <= 0) clipped.push_back(p);
        if ((hp < 0 && hq > 0) || (hp > 0 && hq < 0))
            clipped.push_back(p + (q - p) * (hp / (hp - hq)));
    }
    return clipped;
}

// The part of face a that face b covers: clips by each edge of b.
std::vector<Vec3> covered(const CellFace& a, const CellFace& b) {
    std::vector<Vec3> points = a.points;
    for (std::size_t k = 0; k < b.points.size() && points.size() >= 3; k++) {
        const Vec3 from = b.points[k], to = b.points[k + 1 == b.points.size() ? 0 : k + 1];
        const Vec3 out = cross(to - from, b.normal);
        points = cut_off(points, out, dot(out, from));
    }
    return points;
}

}  // namespace

std::vector<FaceContact> face_contacts(const ConvexCell& a, const ConvexCell& b, double near) {
    std::vector<FaceContact> contacts;
    for (const CellFace& face : a.faces) {
        if (face.neighbour != outer_face) continue;
        for (const CellFace& other : b.faces) {
            if (other.neighbour != outer_face || dot(face.normal, other.normal) > -parallel)
                continue;
            if (absolute(dot(face.normal, other.points[0] - face.points[0])) > near) continue;
            std::vector<Vec3> points = covered(face, other);
            if (points.size() >= 3) contacts.push_back({face.normal, std::move(points)});
        }
    }
    return contacts;
}

}  // namespace jostle::modules::destruction_detail
