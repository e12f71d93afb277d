// SPDX-License-Identifier: MIT
#include "physics/src/stages/continuous/swept_shapes.h"

#include <cstddef>

#include "jostle/base/check.h"
#include "physics/src/stages/continuous/toi_motion.h"

namespace jostle::physics {
namespace {

// Building a tree pays off from this number of shapes on.
constexpr std::size_t tree_shapes_min = 12;

}  // namespace

const SweptShapes& swept_shapes_of(const WorldState& world, ToiBody& t) {
    if (t.swept_shapes.known) return t.swept_shapes;
    t.swept_shapes = {.known = true, .shapes = {}, .tree = {}};
    std::size_t count = 0;
    const std::uint32_t first = world.bodies.cold[t.body].first_shape;
    for (std::uint32_t s = first; s != none; s = world.shapes.shapes[s].next) count++;
    if (count < tree_shapes_min) return t.swept_shapes;
    std::vector<Aabb> boxes;
    for (std::uint32_t s = first; s != none; s = world.shapes.shapes[s].next) {
        ASSERT(!is_plane(world.shapes.shapes[s]));
        ASSERT(world.shapes.shapes[s].body == t.body);
        t.swept_shapes.shapes.push_back(s);
        boxes.push_back(swept_bounds(swept_shape(world, s, t.sweep), t.sweep.from, t.sweep.until));
    }
    t.swept_shapes.tree = Bvh(boxes);
    return t.swept_shapes;
}

}  // namespace jostle::physics
