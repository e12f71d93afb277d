// SPDX-License-Identifier: MIT
#include "collision/narrowphase/collide.h"

#include "collision/narrowphase/collide_boxes.h"
#include "collision/narrowphase/collide_plane.h"
#include "collision/narrowphase/collide_round.h"

namespace jostle::physics {
namespace {

using Collide = Manifold (*)(const Placed& a, const Placed& b, double margin, AxisCache& axis);

template <Manifold (*kCollide)(const Placed&, const Placed&, double)>
Manifold plain(const Placed& a, const Placed& b, double margin, AxisCache&) {
    return kCollide(a, b, margin);
}
template <Manifold (*kCollide)(const Placed&, const Placed&, double)>
Manifold swapped(const Placed& a, const Placed& b, double margin, AxisCache&) {
    return flipped(kCollide(b, a, margin));
}

Manifold never(const Placed&, const Placed&, double margin, AxisCache&) {
    return {.distance = margin + 1e9};
}

// Rows: kind of a. Columns: kind of b. In the order of ShapeKind.
constexpr Collide table[4][4] = {
    {plain<collide_spheres>, plain<collide_sphere_capsule>, swapped<collide_box_sphere>,
     swapped<collide_plane_sphere>},
    {swapped<collide_sphere_capsule>, plain<collide_capsules>, swapped<collide_box_capsule>,
     swapped<collide_plane_capsule>},
    {plain<collide_box_sphere>, plain<collide_box_capsule>, collide_boxes,
     swapped<collide_plane_box>},
    {plain<collide_plane_sphere>, plain<collide_plane_capsule>, plain<collide_plane_box>, never},
};

}  // namespace

Manifold collide(const Placed& a, const Placed& b, double margin, AxisCache& axis) {
    return table[a.geometry->index()][b.geometry->index()](a, b, margin, axis);
}

}  // namespace jostle::physics
