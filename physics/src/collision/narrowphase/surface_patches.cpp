// SPDX-License-Identifier: MIT
#include "physics/src/collision/narrowphase/surface_patches.h"

#include <algorithm>

#include "jostle/base/check.h"
#include "physics/src/collision/narrowphase/manifold_reduction.h"
#include "physics/src/foundation/tuning.h"

namespace jostle::physics {
namespace {

// The position of a contact point on its triangle.
Vec3 on_ground(const GapPoint& p, Vec3 normal) {
    return p.point - normal * (0.5 * p.gap);
}

}  // namespace

SurfacePatches::SurfacePatches(double size) : size_(size) {
    patches_.reserve(8);
    points_.reserve(32);
}

void SurfacePatches::put(std::span<const GapPoint> points) {
    points_.insert(points_.end(), points.begin(), points.end());
}

void SurfacePatches::put(const ContactPoints& points) {
    for (int k = 0; k < points.count; k++) put(GapPoint{points.point[k], points.gap[k]});
}

double SurfacePatches::smallest_gap() const {
    double least = 1e300;
    for (const GapPoint& p : current()) least = minimum(least, p.gap);
    return least;
}

bool SurfacePatches::close(Vec3 normal, std::uint32_t triangle, const Vec3 corner[3]) {
    if (current().empty()) return false;
    patches_.push_back({normal,
                        triangle,
                        {corner[0], corner[1], corner[2]},
                        smallest_gap(),
                        static_cast<int>(first_),
                        static_cast<int>(current().size())});
    first_ = points_.size();
    return true;
}

bool SurfacePatches::any_overlaps() const {
    return std::any_of(patches_.begin(), patches_.end(),
                       [](const SurfacePatch& p) { return p.deepest < 0; });
}

std::span<const GapPoint> SurfacePatches::points_of(const SurfacePatch& patch) const {
    return std::span(points_).subspan(static_cast<std::size_t>(patch.first),
                                      static_cast<std::size_t>(patch.count));
}

// Only coplanar patches are merged into one manifold. On curved ground four points cannot
// represent the rest, and the best four change in every step.
bool SurfacePatches::continues(Vec3 normal, Vec3 ground, const SurfacePatch& next) const {
    if (dot(normal, next.normal) < tuning::same_piece) return false;
    for (const GapPoint& p : points_of(next))
        if (absolute(dot(on_ground(p, next.normal) - ground, normal)) > tuning::even_ground * size_)
            return false;
    return true;
}

// Points that two triangles share count once.
void SurfacePatches::merge(ContactPoints& sum, Vec3 point, double gap) const {
    const double near = 1e-4 * size_;
    for (int k = 0; k < sum.count; k++)
        if (length_squared(sum.point[k] - point) < near * near) {
            sum.gap[k] = minimum(sum.gap[k], gap);
            return;
        }
    if (sum.count == ContactPoints::capacity) {
        ASSERT(size_ > 0);
        // The array is full: drop the redundant points.
        sum.count = reduce(sum);
    }
    sum.point[sum.count] = point;
    sum.gap[sum.count] = gap;
    sum.count++;
}

int SurfacePatches::reduce(ContactPoints& sum) const {
    Vec3 normal = cross(sum.point[1] - sum.point[0], sum.point[2] - sum.point[0]);
    const Manifold best = manifold_of(sum, normalized(normal), size_);
    ASSERT(best.count <= 4);
    for (int k = 0; k < best.count; k++) {
        sum.point[k] = best.point[k];
        sum.gap[k] = best.gap[k];
    }
    return best.count;
}

void SurfacePatches::write(const TransformedShape& surface, Vec3 origin,
                           std::vector<Manifold>& out) {
    // Deepest first: the normal of a piece is the normal of its deepest triangle.
    std::sort(patches_.begin(), patches_.end(), [](const SurfacePatch& x, const SurfacePatch& y) {
        return x.deepest < y.deepest || (x.deepest == y.deepest && x.triangle < y.triangle);
    });
    std::vector<bool> used(patches_.size(), false);
    for (std::size_t i = 0; i < patches_.size(); i++) {
        if (used[i]) continue;
        const Vec3 ground = on_ground(points_of(patches_[i])[0], patches_[i].normal);
        ContactPoints sum;
        ASSERT(patches_[i].count <= ContactPoints::capacity);
        for (const GapPoint& p : points_of(patches_[i])) {
            sum.point[sum.count] = p.point;
            sum.gap[sum.count++] = p.gap;
        }
        for (std::size_t j = i + 1; j < patches_.size(); j++) {
            if (used[j] || !continues(patches_[i].normal, ground, patches_[j])) continue;
            used[j] = true;
            for (const GapPoint& p : points_of(patches_[j])) merge(sum, p.point, p.gap);
        }
        Manifold m = manifold_of(sum, patches_[i].normal, size_);
        m.normal = surface.axes * m.normal;
        for (int k = 0; k < m.count; k++)
            m.point[k] = surface.position + surface.axes * (m.point[k] + origin);
        out.push_back(m);
    }
}

}  // namespace jostle::physics
