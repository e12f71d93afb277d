// SPDX-License-Identifier: MIT
//
// The points of a convex shape over the face of a triangle: the face of the shape that faces the
// triangle, clipped to the prism above it. Same results as points_over_face() (clip.h), for many
// triangles of one surface, which mostly meet the same face of the shape.
#pragma once

#include <span>

#include "physics/src/collision/narrowphase/clip.h"
#include "physics/src/collision/narrowphase/polyhedron.h"

namespace jostle::physics {

struct GapPoint {
    Vec3 point;      // midway between the surfaces
    double gap = 0;  // m
};

class FaceClip {
public:
    // `shape` must outlive the clip.
    FaceClip(const Convex& shape, double margin) : shape_(shape), margin_(margin) {}

    // The points within the margin over a triangle with the unit normal `face`. outward[k] is
    // perpendicular to edge k and the normal, with the length of the edge. The result is valid
    // until the next call.
    std::span<const GapPoint> over(const Vec3 corner[3], Vec3 face, const Vec3 outward[3]);

private:
    void select_face(Vec3 direction);

    const Convex& shape_;
    double margin_;
    int face_ = -1;  // of a polyhedron, selected last
    Feature feature_;
    // A convex polygon gets at most one more corner per cut.
    UninitializedArray<Vec3, max_face_vertices + 3> polygon_[2];
    UninitializedArray<GapPoint, max_face_vertices + 3> points_;
};

}  // namespace jostle::physics
