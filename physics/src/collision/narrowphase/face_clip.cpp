// SPDX-License-Identifier: MIT
#include "physics/src/collision/narrowphase/face_clip.h"

#include "jostle/base/check.h"
#include "physics/src/geometry/hull_lanes.h"

namespace jostle::physics {
namespace {

// The face of a box or a hull whose normal is nearest to a direction in its own frame: see
// feature_along().
int facing_face(const Convex& shape, Vec3 d) {
    int best = 0;
    double most = -1e300;
    if (shape.core == Core::box) {
        for (int k = 0; k < 6; k++) {
            const double along = k % 2 == 0 ? -d[k / 2] : d[k / 2];
            if (along <= most + 1e-9) continue;
            most = along;
            best = k;
        }
        return best;
    }
    const ConvexHull& hull = *shape.hull;
    alignas(16) float along[2 * max_hull_vertices + 8];
    const float least = normals_along(*hull.lanes, d, along) - 1e-5f;
    for (std::size_t k = 0; k < hull.faces.size(); k++) {
        if (along[k] < least) continue;
        const double exact = dot(hull.faces[k].normal, d);
        if (exact <= most + 1e-9) continue;
        most = exact;
        best = static_cast<int>(k);
    }
    return best;
}

// Clips a polygon, or a segment, to the inner side of the line through an edge of a triangle.
// Returns the number of corners; `to` is written only if it is less or more than all of them remain
// unchanged, which `changed` tells.
int cut_side(const Vec3* from, int count, Vec3* to, Vec3 outward, Vec3 corner, bool& changed) {
    double height[max_face_vertices + 3];
    const double slack = 1e-12 * square_root(length_squared(outward));
    int inside = 0;
    for (int k = 0; k < count; k++) {
        height[k] = dot(outward, from[k] - corner);
        inside += height[k] <= slack ? 1 : 0;
    }
    changed = inside < count;
    if (inside == 0 || !changed) return inside;
    int made = 0;
    for (int k = 0; k < count; k++) {
        if (height[k] <= slack) to[made++] = from[k];
        if (count == 2 && k == 1) continue;  // a segment has no closing side
        const int next = k + 1 < count ? k + 1 : 0;
        const double a = height[k], b = height[next];
        if ((a < -slack && b > slack) || (a > slack && b < -slack))
            to[made++] = from[k] + (from[next] - from[k]) * (a / (a - b));
    }
    ASSERT(made <= static_cast<int>(max_face_vertices) + 3);
    return made;
}

}  // namespace

void FaceClip::select_face(Vec3 direction) {
    if (shape_.core != Core::box && shape_.core != Core::hull) {
        feature_ = feature_along(shape_, direction);
        return;
    }
    const int face = facing_face(shape_, transposed_times(shape_.axes, direction));
    if (face == face_) return;
    face_ = face;
    if (shape_.core == Core::box) {
        feature_.count = 4;
        for (int k = 0; k < 4; k++)
            feature_.corner[k] =
                shape_.position + shape_.axes * box_corner(shape_.size, box_loops[4 * face + k]);
        return;
    }
    const ConvexHull& hull = *shape_.hull;
    const HullFace& of = hull.faces[static_cast<std::size_t>(face)];
    feature_.count = static_cast<int>(of.count);
    for (int k = 0; k < feature_.count; k++)
        feature_.corner[k] =
            shape_.position +
            shape_.axes *
                hull.vertices[hull.face_vertices[of.first + static_cast<std::uint32_t>(k)]];
}

std::span<const GapPoint> FaceClip::over(const Vec3 corner[3], Vec3 face, const Vec3 outward[3]) {
    select_face(-face);
    const Vec3* polygon = feature_.corner.data();
    int count = feature_.count, buffer = 0;
    for (int k = 0; k < 3 && count > 0; k++) {
        bool changed = false;
        Vec3* to = polygon_[buffer].data();
        count = cut_side(polygon, count, to, outward[k], corner[k], changed);
        if (!changed) continue;
        polygon = to;
        buffer ^= 1;
    }
    int made = 0;
    for (int k = 0; k < count; k++) {
        const double rise = dot(face, polygon[k] - corner[0]), gap = rise - shape_.radius;
        if (gap > margin_) continue;
        points_[made++] = {polygon[k] - face * (0.5 * (rise + shape_.radius)), gap};
    }
    return {points_.data(), static_cast<std::size_t>(made)};
}

}  // namespace jostle::physics
