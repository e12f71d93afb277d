// SPDX-License-Identifier: MIT
//
// The contact points of a shape and the triangles of a surface, triangle by triangle, and the
// manifolds that they form. All in the surface's frame, relative to the shape's position.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "physics/src/collision/narrowphase/clip.h"
#include "physics/src/collision/narrowphase/face_clip.h"
#include "physics/src/geometry/transformed_shape.h"

namespace jostle::physics {

// Contact points of one triangle.
struct SurfacePatch {
    Vec3 normal;  // from the triangle to the shape
    std::uint32_t triangle = 0;
    Vec3 corner[3];
    double deepest = 1e300;    // m, smallest gap
    int first = 0, count = 0;  // of its points
};

class SurfacePatches {
public:
    // `size`: of the shape, m.
    explicit SurfacePatches(double size);

    // The points of the current patch. begin() drops those that have not been closed.
    void begin() { points_.resize(first_); }
    void put(const GapPoint& point) { points_.push_back(point); }
    void put(std::span<const GapPoint> points);
    void put(const ContactPoints& points);
    std::span<const GapPoint> current() const { return std::span(points_).subspan(first_); }
    double smallest_gap() const;  // of the current patch
    template <class Drop>
    void drop_if(Drop&& drop) {
        points_.erase(std::remove_if(points_.begin() + static_cast<std::ptrdiff_t>(first_),
                                     points_.end(), drop),
                      points_.end());
    }
    // Ends the current patch. Returns false if it has no points; there is then no such patch.
    bool close(Vec3 normal, std::uint32_t triangle, const Vec3 corner[3]);

    std::span<const SurfacePatch> all() const { return patches_; }
    bool any_overlaps() const;

    // Adds the manifolds of all patches, in world space: coplanar patches share one. `origin`: the
    // position of the shape in the surface's frame.
    void write(const TransformedShape& surface, Vec3 origin, std::vector<Manifold>& out);

private:
    std::span<const GapPoint> points_of(const SurfacePatch& patch) const;
    bool continues(Vec3 normal, Vec3 ground, const SurfacePatch& next) const;
    void merge(ContactPoints& sum, Vec3 point, double gap) const;
    int reduce(ContactPoints& sum) const;

    double size_;
    std::size_t first_ = 0;  // point of the current patch
    std::vector<SurfacePatch> patches_;
    std::vector<GapPoint> points_;
};

}  // namespace jostle::physics
