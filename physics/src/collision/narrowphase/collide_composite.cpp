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

bool is_compound(const TransformedShape& shape) {
    return kind_of(*shape.geometry) == ShapeKind::compound;
}

TransformedShape child_of(const TransformedShape& compound, const CompoundChild& child) {
    return {&child.geometry, compound.position + compound.axes * child.pose.position,
            compound.axes * to_matrix(child.pose.rotation)};
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

// Neither shape is a compound. Returns whether a neighbour covers a contact.
bool collide_children(const TransformedShape& a, const TransformedShape& b, double margin,
                      std::uint64_t key, const SurfaceMotion* motion,
                      const SeamNeighbours& neighbours, std::vector<ChildManifold>& out) {
    if (is_surface(a) || is_surface(b)) {
        const bool a_is_surface = is_surface(a);
        ASSERT(!(margin < 0));
        if ((a_is_surface && !is_convex(kind_of(*b.geometry))) ||
            (!a_is_surface && !is_convex(kind_of(*a.geometry))))
            return false;
        std::vector<Manifold> pieces;
        const bool covered =
            collide_surface(a_is_surface ? a : b, a_is_surface ? b : a, margin, motion,
                            a_is_surface ? neighbours.of_a : neighbours.of_b, pieces);
        for (const Manifold& piece : pieces)
            out.push_back({key, a_is_surface ? piece : flipped(piece)});
        return covered;
    }
    PairCache cache;
    Manifold m = collide(a, b, margin, cache);
    const bool covered = apply_seams(m, a, b, neighbours, margin);
    if (m.count > 0) out.push_back({key, m});
    return covered;
}

bool parts_overlap(const TransformedShape& a, const TransformedShape& b) {
    if (is_surface(a)) return is_convex(kind_of(*b.geometry)) && overlaps_surface(a, b);
    if (is_surface(b)) return is_convex(kind_of(*a.geometry)) && overlaps_surface(b, a);
    PairCache cache;
    return collide(a, b, 0, cache).count > 0;
}

// A part of a shape with its index plus one; 0 for a shape that is not a compound.
struct Part {
    TransformedShape shape;
    std::uint64_t number = 0;
};

// The parts of one shape that may be within the margin of another one.
std::vector<Part> parts_near(const TransformedShape& whole, const TransformedShape& shape,
                             double margin) {
    const auto* compound = std::get_if<Compound>(whole.geometry);
    if (compound == nullptr) return {{whole}};
    std::vector<Part> parts;
    for (const std::uint32_t k : children_near(whole, shape, margin))
        parts.push_back({child_of(whole, compound->data->children[k]), std::uint64_t{k} + 1});
    return parts;
}

void append(std::vector<TransformedShape>& shapes, const std::vector<Part>& parts) {
    for (const Part& part : parts) shapes.push_back(part.shape);
}

}  // namespace

bool collide_composite(const TransformedShape& a, const TransformedShape& b, double margin,
                       std::vector<ChildManifold>& out, const std::atomic<bool>* stopped,
                       const SurfaceMotion* motion, const SeamNeighbours* neighbours) {
    static const SeamNeighbours none;
    const SeamNeighbours& others = neighbours != nullptr ? *neighbours : none;
    if (!is_compound(a) && !is_compound(b))
        return collide_children(a, b, margin, 0, motion, others, out);
    const std::vector<Part> parts_a = parts_near(a, b, margin);
    bool covered = false;
    for (const Part& pa : parts_a) {
        const std::vector<Part> parts_b = parts_near(b, pa.shape, margin);
        SeamNeighbours near = others;
        if (parts_b.size() > 1) append(near.of_b, parts_b);
        if (parts_a.size() > 1) append(near.of_a, parts_a);
        for (const Part& pb : parts_b) {
            covered |= collide_children(pa.shape, pb.shape, margin, pa.number << 32 | pb.number,
                                        motion, near, out);
            if (out.size() >= child_manifolds_max ||
                (stopped != nullptr && stopped->load(std::memory_order_relaxed)))
                return covered;
        }
    }
    return covered;
}

bool shapes_overlap(const TransformedShape& a, const TransformedShape& b) {
    for (const Part& pa : parts_near(a, b, 0))
        for (const Part& pb : parts_near(b, pa.shape, 0))
            if (parts_overlap(pa.shape, pb.shape)) return true;
    return false;
}

}  // namespace jostle::physics
