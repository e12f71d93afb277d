// SPDX-License-Identifier: MIT
#include "modules/convex_decomposition/src/cut_mesh.h"

#include <algorithm>

#include "jostle/physics/scalar.h"

namespace jostle::modules::convex_decomposition {
namespace {

using namespace physics;

// A polygon of the surface inside the box.
using Polygon = std::vector<Vec3>;

double& component(Vec3& v, int axis) {
    return axis == 0 ? v.x : (axis == 1 ? v.y : v.z);
}

// Sutherland-Hodgman clipping: the part below (sign 1) or above (-1) an axis-aligned plane.
void clip(Polygon& polygon, Polygon& scratch, int axis, double sign, double limit) {
    scratch.clear();
    const auto outside = [&](Vec3 p) { return sign * (p[axis] - limit); };
    for (std::size_t k = 0; k < polygon.size(); k++) {
        const Vec3 p = polygon[k], q = polygon[k + 1 < polygon.size() ? k + 1 : 0];
        const double op = outside(p), oq = outside(q);
        if (op <= 0) scratch.push_back(p);
        if ((op < 0 && oq > 0) || (op > 0 && oq < 0)) {
            Vec3 cut = p + (q - p) * (op / (op - oq));
            component(cut, axis) = limit;  // exact, so that neighbours meet there
            scratch.push_back(cut);
        }
    }
    polygon.swap(scratch);
}

// Returns true if the polygon lies in a wall of the box and the solid is on the other side.
bool is_back_facing(const Triangle& triangle, const Polygon& polygon, const Aabb& box) {
    const Vec3 out = cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
    for (int axis = 0; axis < 3; axis++)
        for (const bool high : {false, true}) {
            const double wall = high ? box.high[axis] : box.low[axis];
            const bool in_wall = std::all_of(polygon.begin(), polygon.end(),
                                             [&](Vec3 p) { return p[axis] == wall; });
            if (in_wall && (out[axis] > 0) != high) return true;
        }
    return false;
}

Polygon within(const Triangle& triangle, const Aabb& box, Polygon& scratch) {
    Polygon polygon(triangle.begin(), triangle.end());
    for (int axis = 0; axis < 3 && polygon.size() > 2; axis++) {
        clip(polygon, scratch, axis, 1, box.high[axis]);
        if (polygon.size() > 2) clip(polygon, scratch, axis, -1, box.low[axis]);
    }
    if (polygon.size() < 3 || is_back_facing(triangle, polygon, box)) polygon.clear();
    return polygon;
}

Vec3 corner_of(const Aabb& box, int k) {
    return {(k & 1) != 0 ? box.high.x : box.low.x, (k & 2) != 0 ? box.high.y : box.low.y,
            (k & 4) != 0 ? box.high.z : box.low.z};
}

// Projects each surface point along -x onto the low wall of the box, with the length limited to the
// depth of the box. Surfaces that face -x count negatively. The sum is the volume inside the box
// (divergence theorem for a field along x), so walls need no closing faces.
double shadow_volume(const Triangle& triangle, const Aabb& box, Polygon& scratch) {
    Polygon polygon(triangle.begin(), triangle.end());
    for (int axis = 1; axis < 3 && polygon.size() > 2; axis++) {
        clip(polygon, scratch, axis, 1, box.high[axis]);
        if (polygon.size() > 2) clip(polygon, scratch, axis, -1, box.low[axis]);
    }
    if (polygon.size() < 3) return 0;
    const double depth = box.high.x - box.low.x;
    // Below the low wall the length is 0, inside the box the distance to the wall, beyond the box
    // its depth.
    const auto sum = [&](const Polygon& part, bool full_depth) {
        double volume = 0;
        for (std::size_t k = 1; k + 1 < part.size(); k++) {
            const Vec3 a = part[0], b = part[k], c = part[k + 1];
            const double area = 0.5 * ((b.y - a.y) * (c.z - a.z) - (b.z - a.z) * (c.y - a.y));
            const double height = full_depth ? depth : (a.x + b.x + c.x) / 3 - box.low.x;
            volume += area * height;
        }
        return volume;
    };
    double volume = 0;
    Polygon part = polygon;
    clip(part, scratch, 0, 1, box.high.x);
    if (part.size() > 2) clip(part, scratch, 0, -1, box.low.x);
    if (part.size() > 2) volume += sum(part, false);
    // A polygon in the wall is counted above.
    const bool reaches_beyond =
        std::any_of(polygon.begin(), polygon.end(), [&](Vec3 p) { return p.x > box.high.x; });
    if (!reaches_beyond) return volume;
    part = polygon;
    clip(part, scratch, 0, -1, box.high.x);
    return volume + (part.size() > 2 ? sum(part, true) : 0);
}

bool is_in_ray_shadow(const Triangle& t, const Aabb& box) {
    const Vec3 low = min(t[0], min(t[1], t[2])), high = max(t[0], max(t[1], t[2]));
    return low.y <= box.high.y && high.y >= box.low.y && low.z <= box.high.z &&
           high.z >= box.low.z && high.x >= box.low.x;
}

}  // namespace

std::vector<Triangle> triangles_for_box(const std::vector<Triangle>& surface, const Aabb& box) {
    std::vector<Triangle> relevant;
    for (const Triangle& triangle : surface)
        if (is_in_ray_shadow(triangle, box)) relevant.push_back(triangle);
    return relevant;
}

Piece cut_piece(const std::vector<Triangle>& surface, const Aabb& box) {
    Piece piece;
    Polygon scratch;
    for (const Triangle& triangle : surface) {
        if (!is_in_ray_shadow(triangle, box)) continue;
        piece.volume += shadow_volume(triangle, box, scratch);
        const Polygon part = within(triangle, box, scratch);
        piece.points.insert(piece.points.end(), part.begin(), part.end());
    }
    // A solid that touches the corner from outside does not contain it.
    const Vec3 inwards = (box.high - box.low) * 1e-9;
    const Aabb inner{box.low + inwards, box.high - inwards};
    for (int k = 0; k < 8; k++)
        if (is_inside(surface, corner_of(inner, k))) piece.points.push_back(corner_of(box, k));
    if (piece.points.empty()) return piece;
    piece.bounds = {piece.points[0], piece.points[0]};
    for (const Vec3 p : piece.points)
        piece.bounds = {min(piece.bounds.low, p), max(piece.bounds.high, p)};
    return piece;
}

}  // namespace jostle::modules::convex_decomposition
