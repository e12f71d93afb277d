// SPDX-License-Identifier: MIT
#include "physics/src/collision/narrowphase/collide_composite.h"

#include <algorithm>

#include "jostle/base/check.h"
#include "jostle/physics/compound.h"
#include "physics/src/collision/narrowphase/collide.h"
#include "physics/src/collision/narrowphase/collide_surface.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/geometry/bvh.h"
#include "physics/src/geometry/shape_measures.h"

namespace jostle::physics {
namespace {

// Limit for one pair of shapes. Two bodies that touch in more places overlap deeply, and their
// children could form a billion pairs, which do not fit into memory.
constexpr std::size_t child_manifolds_max = 1 << 14;
// Every two manifolds are compared. More parts than this touch only if the shapes overlap deeply.
constexpr std::size_t seam_parts_max = 256;

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

// The two parts of a manifold between convex parts.
struct PartPair {
    std::size_t index = 0;  // of the manifold
    TransformedShape a, b;
    Manifold manifold;
};

// The manifold as seen from one side: from the piece on that side to the other part.
struct SeamSide {
    const TransformedShape *piece, *shape;
    std::uint32_t shape_number;
    Vec3 normal;
};
SeamSide side_of(const PartPair& pair, std::uint64_t key, bool of_b) {
    const auto low = static_cast<std::uint32_t>(key), high = static_cast<std::uint32_t>(key >> 32);
    if (of_b) return {&pair.b, &pair.a, high, -pair.manifold.normal};
    return {&pair.a, &pair.b, low, pair.manifold.normal};
}

// Returns whether another part touches the same shape along another normal: cheap rejection.
bool has_neighbour(const std::vector<PartPair>& pairs, const PartPair& own, const SeamSide& side,
                   bool of_b, const std::vector<ChildManifold>& out) {
    const double reach = maximum(own.manifold.distance, 0) + tuning::flush_distance;
    return std::any_of(pairs.begin(), pairs.end(), [&](const PartPair& other) {
        if (&other == &own || other.manifold.distance > reach) return false;
        const SeamSide next = side_of(other, out[other.index].key, of_b);
        return next.shape_number == side.shape_number && dot(next.normal, side.normal) < 1 - 1e-9;
    });
}

// Parts of one compound are neighbours. Changes the manifolds that other parts cover; returns
// whether there are any.
bool apply_seams_of_parts(const std::vector<PartPair>& pairs, double margin,
                          std::vector<ChildManifold>& out) {
    bool any = false;
    for (const PartPair& own : pairs)
        for (const bool of_b : {true, false}) {
            ChildManifold& child = out[own.index];
            const SeamSide side = side_of(own, child.key, of_b);
            if (!has_neighbour(pairs, own, side, of_b, out)) continue;
            const Vec3 origin = side.shape->position;
            const Convex shape = convex_of(*side.shape, origin),
                         piece = convex_of(*side.piece, origin);
            SeamContact contact(shape, piece, side.normal, own.manifold.distance);
            for (const PartPair& other : pairs) {
                const SeamSide next = side_of(other, out[other.index].key, of_b);
                if (&other != &own && next.shape_number == side.shape_number)
                    contact.test(convex_of(*next.piece, origin), next.normal,
                                 other.manifold.distance);
            }
            const auto n = contact.covering_normal();
            if (!n) continue;
            any = true;
            Manifold along = contact_along(piece, shape, *n, margin);
            for (int k = 0; k < along.count; k++) along.point[k] += origin;
            child.manifold = of_b ? flipped(along) : along;
            break;
        }
    std::erase_if(out, [](const ChildManifold& child) { return child.manifold.count == 0; });
    return any;
}

}  // namespace

bool collide_composite(const TransformedShape& a, const TransformedShape& b, double margin,
                       std::vector<ChildManifold>& out, const std::atomic<bool>* stopped,
                       const SurfaceMotion* motion, const SeamNeighbours* neighbours) {
    static const SeamNeighbours none;
    const SeamNeighbours& others = neighbours != nullptr ? *neighbours : none;
    if (!is_compound(a) && !is_compound(b))
        return collide_children(a, b, margin, 0, motion, others, out);
    bool covered = false;
    std::vector<PartPair> pairs;
    const std::vector<Part> parts_a = parts_near(a, b, margin);
    for (const Part& pa : parts_a)
        for (const Part& pb : parts_near(b, pa.shape, margin)) {
            const std::size_t before = out.size();
            covered |= collide_children(pa.shape, pb.shape, margin, pa.number << 32 | pb.number,
                                        motion, others, out);
            if (out.size() >= child_manifolds_max ||
                (stopped != nullptr && stopped->load(std::memory_order_relaxed)))
                return covered;
            const bool convex = !is_surface(pa.shape) && !is_surface(pb.shape) &&
                                kind_of(*pb.shape.geometry) != ShapeKind::plane;
            if (convex && out.size() > before)
                pairs.push_back({out.size() - 1, pa.shape, pb.shape, out.back().manifold});
        }
    if (pairs.size() < 2 || pairs.size() > seam_parts_max) return covered;
    return apply_seams_of_parts(pairs, margin, out) || covered;
}

bool shapes_overlap(const TransformedShape& a, const TransformedShape& b) {
    for (const Part& pa : parts_near(a, b, 0))
        for (const Part& pb : parts_near(b, pa.shape, 0))
            if (parts_overlap(pa.shape, pb.shape)) return true;
    return false;
}

}  // namespace jostle::physics
