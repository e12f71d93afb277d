// SPDX-License-Identifier: MIT
#include "jostle/base/check.h"
#include "jostle/physics/polygon.h"

namespace jostle::physics::planar {
namespace {

Segment side_of(std::span<const Vec2> polygon, std::size_t k) {
    ASSERT(k < polygon.size());
    return {polygon[k], polygon[k + 1 == polygon.size() ? 0 : k + 1]};
}

bool on_boundary(std::span<const Vec2> polygon, Vec2 p) {
    for (std::size_t k = 0; k < polygon.size(); k++)
        if (on_segment(side_of(polygon, k), p)) return true;
    return false;
}

}  // namespace

Location locate_by_crossings(std::span<const Vec2> polygon, Vec2 p) {
    bool inside = false;
    for (std::size_t k = 0; k < polygon.size(); k++) {
        const Segment side = side_of(polygon, k);
        if (on_segment(side, p)) return Location::boundary;
        // Cast a ray along x. A side includes its lower end but not its upper end, so a corner on
        // the ray counts once or not at all.
        const bool rises = side.from.y <= p.y && p.y < side.to.y;
        const bool falls = side.to.y <= p.y && p.y < side.from.y;
        if (!rises && !falls) continue;
        if (orientation(side.from, side.to, p) == (rises ? 1 : -1)) inside = !inside;
    }
    return inside ? Location::inside : Location::outside;
}

int winding_number(std::span<const Vec2> polygon, Vec2 p) {
    int turns = 0;
    for (std::size_t k = 0; k < polygon.size(); k++) {
        const Segment side = side_of(polygon, k);
        if (side.from.y <= p.y && p.y < side.to.y) {
            if (orientation(side.from, side.to, p) > 0) turns++;
        } else if (side.to.y <= p.y && p.y < side.from.y) {
            if (orientation(side.from, side.to, p) < 0) turns--;
        }
    }
    return turns;
}

Location locate_by_winding(std::span<const Vec2> polygon, Vec2 p) {
    if (on_boundary(polygon, p)) return Location::boundary;
    return winding_number(polygon, p) != 0 ? Location::inside : Location::outside;
}

}  // namespace jostle::physics::planar
