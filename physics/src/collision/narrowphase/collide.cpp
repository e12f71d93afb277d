// SPDX-License-Identifier: MIT
#include "physics/src/collision/narrowphase/collide.h"

#include "jostle/base/check.h"
#include "physics/src/collision/narrowphase/collide_pairs.h"

namespace jostle::physics {
namespace {

using Collide = Manifold (*)(const TransformedShape& a, const TransformedShape& b, double margin,
                             PairCache& cache);

template <Manifold (*kCollide)(const TransformedShape&, const TransformedShape&, double)>
Manifold plain(const TransformedShape& a, const TransformedShape& b, double margin, PairCache&) {
    return kCollide(a, b, margin);
}
template <Manifold (*kCollide)(const TransformedShape&, const TransformedShape&, double)>
Manifold swapped(const TransformedShape& a, const TransformedShape& b, double margin, PairCache&) {
    return flipped(kCollide(b, a, margin));
}

// Computes relative to a's position, so that large coordinates cancel once.
Manifold general(const TransformedShape& a, const TransformedShape& b, double margin,
                 PairCache& cache) {
    Manifold m = collide_convex(convex_of(a, a.position), convex_of(b, a.position), margin, cache);
    ASSERT(m.count >= 0 && m.count <= 4);
    for (int k = 0; k < m.count; k++) m.point[k] += a.position;
    return m;
}

// The closed form is exact only while the segment is outside the box.
Manifold box_capsule(const TransformedShape& a, const TransformedShape& b, double margin,
                     PairCache& cache) {
    const auto m = collide_box_capsule(a, b, margin);
    return m ? *m : general(a, b, margin, cache);
}
Manifold capsule_box(const TransformedShape& a, const TransformedShape& b, double margin,
                     PairCache& cache) {
    const auto m = collide_box_capsule(b, a, margin);
    return m ? flipped(*m) : general(a, b, margin, cache);
}

Manifold never(const TransformedShape&, const TransformedShape&, double margin, PairCache&) {
    return {.distance = margin + 1e9};
}

// Rows: kind of a. Columns: kind of b. In the order of ShapeKind, without the composite kinds.
constexpr int simple_kinds = 7;
constexpr Collide table[simple_kinds][simple_kinds] = {
    {plain<collide_spheres>, plain<collide_sphere_capsule>, swapped<collide_box_sphere>,
     swapped<collide_plane_sphere>, general, general, general},
    {swapped<collide_sphere_capsule>, plain<collide_capsules>, capsule_box,
     swapped<collide_plane_capsule>, general, general, general},
    {plain<collide_box_sphere>, box_capsule, collide_boxes, swapped<collide_plane_box>, general,
     general, general},
    {plain<collide_plane_sphere>, plain<collide_plane_capsule>, plain<collide_plane_box>, never,
     plain<collide_plane_convex>, plain<collide_plane_convex>, plain<collide_plane_convex>},
    {general, general, general, swapped<collide_plane_convex>, general, general, general},
    {general, general, general, swapped<collide_plane_convex>, general, general, general},
    {general, general, general, swapped<collide_plane_convex>, general, general, general},
};

}  // namespace

Manifold collide(const TransformedShape& a, const TransformedShape& b, double margin,
                 PairCache& cache) {
    ASSERT(a.geometry->index() < simple_kinds && b.geometry->index() < simple_kinds);
    ASSERT(!(margin < 0));
    return table[a.geometry->index()][b.geometry->index()](a, b, margin, cache);
}

}  // namespace jostle::physics
