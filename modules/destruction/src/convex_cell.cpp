// SPDX-License-Identifier: MIT
#include "modules/destruction/src/convex_cell.h"

#include <algorithm>

namespace jostle::modules::destruction_detail {

using namespace physics;

namespace {

// Intersection of an edge with the plane. Both faces of an edge call it in the order inside,
// outside, so their results are bit-identical.
Vec3 crossing(Vec3 inside, Vec3 outside, double below, double above) {
    return inside + (outside - inside) * (below / (below - above));
}

void note(std::vector<Vec3>& rim, Vec3 point) {
    if (std::find(rim.begin(), rim.end(), point) == rim.end()) rim.push_back(point);
}

// Returns the part of a face below the plane. Points on the plane are added to the rim.
CellFace clipped_face(const CellFace& face, Vec3 normal, double offset, double plane_tolerance,
                      std::vector<Vec3>& rim) {
    CellFace below{.normal = face.normal, .neighbour = face.neighbour, .points = {}};
    const std::size_t count = face.points.size();
    std::vector<double> height(count);
    for (std::size_t k = 0; k < count; k++) {
        const double h = dot(normal, face.points[k]) - offset;
        height[k] = absolute(h) <= plane_tolerance ? 0 : h;
    }
    for (std::size_t k = 0; k < count; k++) {
        const std::size_t next = k + 1 == count ? 0 : k + 1;
        const Vec3 p = face.points[k], q = face.points[next];
        const double hp = height[k], hq = height[next];
        if (hp <= 0) below.points.push_back(p);
        if (hp == 0) note(rim, p);
        if (!((hp < 0 && hq > 0) || (hp > 0 && hq < 0))) continue;
        const Vec3 cut = hp < 0 ? crossing(p, q, hp, hq) : crossing(q, p, hq, hp);
        below.points.push_back(cut);
        note(rim, cut);
    }
    return below;
}

// Returns true for a face that lies in the plane.
bool is_flat(const CellFace& face, Vec3 normal, double offset, double plane_tolerance) {
    return std::all_of(face.points.begin(), face.points.end(), [&](Vec3 p) {
        return absolute(dot(normal, p) - offset) <= plane_tolerance;
    });
}

// Sorts the points of a convex face about its normal.
void sort_about(std::vector<Vec3>& points, Vec3 normal) {
    Vec3 middle;
    for (const Vec3 p : points) middle += p * (1 / static_cast<double>(points.size()));
    Vec3 x = points[0] - middle;
    x = normalized(x - normal * dot(normal, x));
    const Vec3 y = cross(normal, x);
    std::vector<std::pair<double, Vec3>> turned;
    for (const Vec3 p : points)
        turned.emplace_back(arc_tangent(dot(p - middle, y), dot(p - middle, x)), p);
    std::stable_sort(turned.begin(), turned.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t k = 0; k < points.size(); k++) points[k] = turned[k].second;
}

}  // namespace

namespace {

// Relative to the size: maximum distance of corners from the plane of a flat face, due to rounding.
constexpr double flatness_tolerance = 1e-13;
// Relative to the size, and as a cosine: planes that differ by less count as one.
constexpr double same_plane_tolerance = 1e-9, same_direction = 1 - 1e-9;

bool is_flat(const ConvexHull& hull, const HullFace& face, double size) {
    const auto corners = hull.vertices_of(face);
    return std::all_of(corners.begin(), corners.end(), [&](std::uint16_t v) {
        return face.offset - dot(face.normal, hull.vertices[v]) <= flatness_tolerance * size;
    });
}

// Returns true if all faces are flat and no two are coplanar.
bool has_clean_faces(const ConvexHull& hull) {
    const double size = length(hull.bounds.high - hull.bounds.low);
    return std::all_of(hull.faces.begin(), hull.faces.end(),
                       [&](const HullFace& face) { return is_flat(hull, face, size); }) &&
           std::all_of(hull.edges.begin(), hull.edges.end(), [&](const HullEdge& edge) {
               return dot(hull.faces[edge.left].normal, hull.faces[edge.right].normal) <
                      same_direction;
           });
}

// Intersection of the half spaces of all faces, without duplicate planes.
ConvexCell below_faces(const ConvexHull& hull) {
    const Vec3 middle = (hull.bounds.low + hull.bounds.high) * 0.5;
    const Vec3 half = hull.bounds.high - hull.bounds.low;
    ConvexCell cell = cell_of_box(half);
    for (CellFace& face : cell.faces)
        for (Vec3& p : face.points) p += middle;
    for (const HullFace& face : hull.faces)
        cell = clipped(cell, face.normal, face.offset, outer_face,
                       same_plane_tolerance * length(half));
    return cell;
}

}  // namespace

// Faces of a hull may deviate from a plane by a millionth of its size, or several triangles may be
// coplanar. Clipped cells would then have corners too close together to build a hull.
ConvexCell cell_of(const ConvexHull& hull) {
    if (!has_clean_faces(hull)) return below_faces(hull);
    ConvexCell cell;
    for (const HullFace& face : hull.faces) {
        CellFace& made = cell.faces.emplace_back();
        made.normal = face.normal;
        for (const std::uint16_t v : hull.vertices_of(face))
            made.points.push_back(hull.vertices[v]);
    }
    return cell;
}

ConvexCell cell_of_box(Vec3 e) {
    ConvexCell cell;
    for (int axis = 0; axis < 3; axis++) {
        for (const double side : {-1.0, 1.0}) {
            CellFace& face = cell.faces.emplace_back();
            face.normal[axis] = side;
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            constexpr double corners[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
            for (const auto& corner : corners) {
                Vec3 p;
                p[axis] = side * e[axis];
                p[u] = side * corner[0] * e[u];
                p[v] = corner[1] * e[v];
                face.points.push_back(p);
            }
        }
    }
    return cell;
}

ConvexCell clipped(const ConvexCell& cell, Vec3 normal, double offset, std::uint32_t neighbour,
                   double plane_tolerance) {
    bool below = false, above = false;
    for (const CellFace& face : cell.faces)
        for (const Vec3 p : face.points) {
            const double h = dot(normal, p) - offset;
            below = below || h < -plane_tolerance;
            above = above || h > plane_tolerance;
        }
    if (!above) return cell;
    if (!below) return {};
    ConvexCell result;
    std::vector<Vec3> rim;
    for (const CellFace& face : cell.faces) {
        CellFace part = clipped_face(face, normal, offset, plane_tolerance, rim);
        if (part.points.size() >= 3 && !is_flat(part, normal, offset, plane_tolerance))
            result.faces.push_back(std::move(part));
    }
    if (rim.size() >= 3) {
        sort_about(rim, normal);
        result.faces.push_back({normal, neighbour, std::move(rim)});
    }
    return result;
}

// Sums tetrahedra from one corner. For a tetrahedron with corners p_i about the origin: integral of
// x_j x_k dV = volume / 20 (sum p_j p_k + (sum p_j) (sum p_k)).
CellMass mass_of(const ConvexCell& cell) {
    CellMass mass;
    if (cell.empty()) return mass;
    const Vec3 origin = cell.faces[0].points[0];
    Vec3 first;
    Mat3 second = diagonal({0, 0, 0});
    for (const CellFace& face : cell.faces)
        for (std::size_t k = 2; k < face.points.size(); k++) {
            const Vec3 p[3] = {face.points[0] - origin, face.points[k - 1] - origin,
                               face.points[k] - origin};
            const double volume = dot(p[0], cross(p[1], p[2])) / 6;
            const Vec3 sum = p[0] + p[1] + p[2];
            mass.volume += volume;
            first += sum * (volume / 4);
            for (const Vec3 q : {p[0], p[1], p[2], sum})
                second = second + Mat3{q * q.x, q * q.y, q * q.z} * (volume / 20);
        }
    if (!(mass.volume > 0)) return {};
    const Vec3 c = first / mass.volume;
    mass.center = origin + c;
    second = second - Mat3{c * c.x, c * c.y, c * c.z} * mass.volume;
    const double trace = second.x.x + second.y.y + second.z.z;
    mass.inertia = diagonal({trace, trace, trace}) - second;
    return mass;
}

Aabb bounds_of(const ConvexCell& cell) {
    Aabb bounds{cell.faces[0].points[0], cell.faces[0].points[0]};
    for (const CellFace& face : cell.faces)
        for (const Vec3 p : face.points) bounds = {min(bounds.low, p), max(bounds.high, p)};
    return bounds;
}

bool are_near(const Aabb& a, const Aabb& b, double apart) {
    for (int k = 0; k < 3; k++)
        if (a.low[k] > b.high[k] + apart || b.low[k] > a.high[k] + apart) return false;
    return true;
}

double furthest_squared(const ConvexCell& cell, Vec3 from) {
    double most = 0;
    for (const CellFace& face : cell.faces)
        for (const Vec3 p : face.points) most = maximum(most, length_squared(p - from));
    return most;
}

}  // namespace jostle::modules::destruction_detail
