// SPDX-License-Identifier: MIT
#include "physics/src/collision/narrowphase/collide_composite.h"

#include <algorithm>

#include "jostle/base/check.h"
#include "jostle/physics/compound.h"
#include "physics/src/collision/narrowphase/collide.h"
#include "physics/src/collision/narrowphase/collide_surface.h"
#include "physics/src/geometry/bvh.h"
#include "physics/src/geometry/shape_measures.h"

namespace jostle::physics {
namespace {

// Limit for one pair of shapes. Two bodies that touch in more places overlap deeply, and their
// children could form a billion pairs, which do not fit into memory.
constexpr std::size_t child_manifolds_max = 1 << 14;

bool is_surface(const TransformedShape& shape) {
    const ShapeKind kind = kind_of(*shape.geometry);
    return kind == ShapeKind::mesh || kind == ShapeKind::height_field;
}

TransformedShape child_of(const TransformedShape& compound, const CompoundChild& child) {
    return {&child.geometry, compound.position + compound.axes * child.pose.position,
            compound.axes * to_matrix(child.pose.rotation)};
}

// The bounding box of a shape in another frame.
Aabb bounds_in(const TransformedShape& frame, const TransformedShape& shape) {
    const TransformedShape local{shape.geometry,
                                 transposed_times(frame.axes, shape.position - frame.position),
                                 transpose(frame.axes) * shape.axes};
    return bounds_of(local);
}

// Children of the compound that may be within the margin of the shape, in ascending order.
std::vector<std::uint32_t> children_near(const TransformedShape& compound,
                                         const TransformedShape& shape, double margin) {
    const CompoundShape& data = *std::get<Compound>(*compound.geometry).data;
    ASSERT(data.tree != nullptr && !data.children.empty());
    std::vector<std::uint32_t> near;
    if (kind_of(*shape.geometry) == ShapeKind::plane) {
        for (std::uint32_t k = 0; k < data.children.size(); k++) near.push_back(k);
        return near;
    }
    const Aabb box = grow(bounds_in(compound, shape), margin);
    data.tree->query(box, [&](std::uint32_t k) {
        const CompoundChild& child = data.children[k];
        if (overlap(bounds_of(transformed_shape(child.geometry, child.pose)), box))
            near.push_back(k);
    });
    std::sort(near.begin(), near.end());
    ASSERT(near.empty() || near.back() < data.children.size());
    return near;
}

// Neither shape is a compound.
void collide_children(const TransformedShape& a, const TransformedShape& b, double margin,
                      std::uint64_t key, const SurfaceMotion* motion,
                      std::vector<ChildManifold>& out) {
    if (is_surface(a) || is_surface(b)) {
        const bool a_is_surface = is_surface(a);
        ASSERT(!(margin < 0));
        if ((a_is_surface && !is_convex(kind_of(*b.geometry))) ||
            (!a_is_surface && !is_convex(kind_of(*a.geometry))))
            return;
        std::vector<Manifold> pieces;
        collide_surface(a_is_surface ? a : b, a_is_surface ? b : a, margin, motion, pieces);
        for (const Manifold& piece : pieces)
            out.push_back({key, a_is_surface ? piece : flipped(piece)});
        return;
    }
    PairCache cache;
    const Manifold m = collide(a, b, margin, cache);
    if (m.count > 0) out.push_back({key, m});
}

bool parts_overlap(const TransformedShape& a, const TransformedShape& b) {
    if (is_surface(a)) return is_convex(kind_of(*b.geometry)) && overlaps_surface(a, b);
    if (is_surface(b)) return is_convex(kind_of(*a.geometry)) && overlaps_surface(b, a);
    PairCache cache;
    return collide(a, b, 0, cache).count > 0;
}

// Calls visit(part of a, part of b, key) for every two parts that may be near, until visit()
// returns true.
template <class Visit>
void for_each_two(const TransformedShape& a, const TransformedShape& b, double margin,
                  Visit&& visit) {
    const auto* compound_a = std::get_if<Compound>(a.geometry);
    const auto* compound_b = std::get_if<Compound>(b.geometry);
    ASSERT(a.geometry != nullptr && b.geometry != nullptr);
    const auto against_b = [&](const TransformedShape& part, std::uint64_t key) {
        if (compound_b == nullptr) return visit(part, b, key);
        for (const std::uint32_t k : children_near(b, part, margin))
            if (visit(part, child_of(b, compound_b->data->children[k]),
                      key | (std::uint64_t{k} + 1)))
                return true;
        return false;
    };
    if (compound_a == nullptr) {
        against_b(a, 0);
        return;
    }
    for (const std::uint32_t k : children_near(a, b, margin))
        if (against_b(child_of(a, compound_a->data->children[k]), (std::uint64_t{k} + 1) << 32))
            return;
}

}  // namespace

void collide_composite(const TransformedShape& a, const TransformedShape& b, double margin,
                       std::vector<ChildManifold>& out, const std::atomic<bool>* stopped,
                       const SurfaceMotion* motion) {
    for_each_two(a, b, margin,
                 [&](const TransformedShape& pa, const TransformedShape& pb, std::uint64_t key) {
                     collide_children(pa, pb, margin, key, motion, out);
                     return out.size() >= child_manifolds_max ||
                            (stopped != nullptr && stopped->load(std::memory_order_relaxed));
                 });
}

bool shapes_overlap(const TransformedShape& a, const TransformedShape& b) {
    bool any = false;
    for_each_two(a, b, 0,
                 [&](const TransformedShape& pa, const TransformedShape& pb, std::uint64_t) {
                     any = parts_overlap(pa, pb);
                     return any;
                 });
    return any;
}

}  // namespace jostle::physics
