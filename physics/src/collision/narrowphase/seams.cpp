// SPDX-License-Identifier: MIT
#include "physics/src/collision/narrowphase/seams.h"

#include "jostle/base/check.h"
#include "jostle/physics/compound.h"
#include "physics/src/collision/narrowphase/clip.h"
#include "physics/src/collision/narrowphase/collide_convex.h"
#include "physics/src/collision/narrowphase/gjk.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/geometry/bvh.h"
#include "physics/src/geometry/shape_measures.h"
#include "physics/src/geometry/surface.h"
#include "physics/src/math/is_unit.h"

namespace jostle::physics {
namespace {

double height_along(const Convex& shape, Vec3 n) {
    return dot(support(shape, n), n) + shape.radius;
}

// Returns whether a face of one of two boxes separates them by more than a distance. Most
// neighbours of a contact are further away than the contact, and this test takes a tenth of the
// time of a complete one.
bool separated_by_faces(const Convex& a, const Convex& b, double distance) {
    if (a.core != Core::box || b.core != Core::box) return false;
    const Vec3 apart = b.position - a.position;
    const auto separates = [&](const Convex& box, const Convex& other) {
        const Vec3 along = abs(transposed_times(box.axes, apart));
        const Mat3 turn = transpose(box.axes) * other.axes;
        const Vec3 reach = box.size + abs(turn.x) * other.size.x + abs(turn.y) * other.size.y +
                           abs(turn.z) * other.size.z;
        return along.x - reach.x > distance || along.y - reach.y > distance ||
               along.z - reach.z > distance;
    };
    return separates(a, b) || separates(b, a);
}

// Calls visit(const Convex&) for the convex parts of a shape, other than a plane, in a box in its
// own frame.
template <class Visit>
void for_each_part(const TransformedShape& whole, const Aabb& box, Visit&& visit) {
    const ShapeKind kind = kind_of(*whole.geometry);
    ASSERT(kind != ShapeKind::plane);
    if (is_convex(kind)) return visit(convex_of(whole, {}));
    if (kind == ShapeKind::compound) {
        const CompoundShape& data = *std::get<Compound>(*whole.geometry).data;
        data.tree->query(box, [&](std::uint32_t k) {
            const CompoundChild& child = data.children[k];
            visit(convex_of({&child.geometry, whole.position + whole.axes * child.pose.position,
                             whole.axes * to_matrix(child.pose.rotation)},
                            {}));
        });
        return;
    }
    for_each_triangle(*whole.geometry, box, [&](const SurfaceTriangle& t) {
        visit(triangle_convex(t.corner, whole.position, whole.axes));
    });
}

}  // namespace

SeamContact::SeamContact(const Convex& shape, const Convex& piece, Vec3 normal, double gap)
    : shape_(shape),
      piece_(piece),
      normal_(normal),
      tolerance_(minimum(tuning::even_ground * size_of(shape), tuning::flush_distance)),
      reach_(maximum(gap, 0) + tolerance_),
      height_(height_along(piece, normal)) {
    ASSERT(is_unit(normal, 1e-5));
}

void SeamContact::test(const Convex& neighbour) {
    const double rise = height_along(neighbour, normal_) - height_;
    if (rise <= 0.1 * tolerance_) return;
    const double radii = neighbour.radius + shape_.radius;
    if (separated_by_faces(neighbour, shape_, reach_ + radii)) return;
    PairCache cache;
    const Witness w = find_witness(neighbour, shape_, reach_ + radii, cache);
    const double gap = w.distance - radii;
    if (gap <= reach_) test(w.normal, height_along(neighbour, w.normal), rise, gap);
}

void SeamContact::test(const Convex& neighbour, Vec3 normal, double gap) {
    if (gap > reach_) return;
    const double rise = height_along(neighbour, normal_) - height_;
    if (rise > 0.1 * tolerance_) test(normal, height_along(neighbour, normal), rise, gap);
}

void SeamContact::test_plane(Vec3 normal, double offset) {
    const double gap = -height_along(shape_, -normal) - offset;
    if (gap <= reach_) test(normal, offset, 1e300, gap);
}

void SeamContact::test(Vec3 normal, double offset, double rise, double gap) {
    if (gap >= covering_gap_ || dot(normal, normal_) > 1 - 1e-9) return;
    const double own_rise = height_along(piece_, normal) - offset;
    if (own_rise > tolerance_ || own_rise >= rise) return;
    covering_ = normal;
    covering_gap_ = gap;
}

namespace {

// Tests the parts of a neighbour near the box of the shape.
void test_neighbour(SeamContact& contact, const TransformedShape& neighbour, const Aabb& box) {
    if (const auto* plane = std::get_if<Plane>(neighbour.geometry)) {
        const Vec3 up = neighbour.axes * plane->normal;
        return contact.test_plane(up, dot(up, neighbour.position));
    }
    if (is_convex(kind_of(*neighbour.geometry))) {
        if (overlap(bounds_of(neighbour), grow(box, contact.reach())))
            contact.test(convex_of(neighbour, {}));
        return;
    }
    // The box in the frame of the neighbour.
    const Vec3 middle = (box.low + box.high) * 0.5, half = (box.high - box.low) * 0.5;
    const Vec3 center = transposed_times(neighbour.axes, middle - neighbour.position);
    const Mat3 inverse = transpose(neighbour.axes);
    const Vec3 reach = abs(inverse.x) * half.x + abs(inverse.y) * half.y + abs(inverse.z) * half.z;
    for_each_part(neighbour, grow({center - reach, center + reach}, contact.reach()),
                  [&](const Convex& part) { contact.test(part); });
}

}  // namespace

Seams::Seams(const TransformedShape& shape, const Mat3& axes)
    : origin_(shape.position),
      axes_(axes),
      local_{shape.geometry, {}, transpose(axes) * shape.axes},
      shape_(convex_of(local_, {})),
      box_(bounds_of(local_)) {
    ASSERT(is_convex(kind_of(*shape.geometry)));
}

void Seams::add(const TransformedShape& neighbour) {
    neighbours_.push_back({neighbour.geometry,
                           transposed_times(axes_, neighbour.position - origin_),
                           transpose(axes_) * neighbour.axes});
}

std::optional<Vec3> Seams::covering_normal(const Convex& piece, Vec3 normal, double gap) const {
    SeamContact contact(shape_, piece, normal, gap);
    for (const TransformedShape& neighbour : neighbours_) test_neighbour(contact, neighbour, box_);
    return contact.covering_normal();
}

Manifold contact_along(const Convex& piece, const Convex& shape, Vec3 n, double margin) {
    const Feature face = feature_along(piece, n);
    if (face.count < 3 || dot(face.normal, n) < tuning::same_piece) return {};
    return manifold_of(points_over_face(piece, shape, n, margin), n,
                       minimum(size_of(piece), size_of(shape)));
}

namespace {

// `m`: the manifold of a piece and a shape; its normal points to the shape.
bool apply_seams(Manifold& m, const TransformedShape& piece, const TransformedShape& shape,
                 const std::vector<TransformedShape>& neighbours, double margin) {
    if (m.count == 0 || neighbours.empty() || !is_convex(kind_of(*piece.geometry)) ||
        !is_convex(kind_of(*shape.geometry)))
        return false;
    const Convex core = convex_of(piece, shape.position), moving = convex_of(shape, shape.position);
    SeamContact contact(moving, core, m.normal, m.distance);
    const Aabb box = bounds_of(TransformedShape{shape.geometry, {}, shape.axes});
    for (const TransformedShape& neighbour : neighbours)
        test_neighbour(contact,
                       {neighbour.geometry, neighbour.position - shape.position, neighbour.axes},
                       box);
    const auto n = contact.covering_normal();
    if (!n) return false;
    const Manifold along = contact_along(core, moving, *n, margin);
    m.count = 0;  // retains the direction of the separation and its distance
    if (along.count == 0) return true;
    m = along;
    for (int k = 0; k < m.count; k++) m.point[k] += shape.position;
    return true;
}

}  // namespace

bool apply_seams(Manifold& m, const TransformedShape& a, const TransformedShape& b,
                 const SeamNeighbours& neighbours, double margin) {
    if (m.count == 0 || neighbours.empty()) return false;
    m = flipped(m);
    const bool by_b = apply_seams(m, b, a, neighbours.of_b, margin);
    m = flipped(m);
    return apply_seams(m, a, b, neighbours.of_a, margin) || by_b;
}

namespace {

// Calls visit(const Convex&) for the convex parts of a shape within `margin` of a point, relative
// to that point. Not for planes.
template <class Visit>
void for_each_part_at(const TransformedShape& whole, Vec3 point, double margin, Visit&& visit) {
    const Vec3 own = transposed_times(whole.axes, point - whole.position);
    const Convex at{.core = Core::point, .position = {}, .size = {}};
    for_each_part({whole.geometry, whole.position - point, whole.axes}, grow({own, own}, margin),
                  [&](const Convex& part) {
                      if (gjk(part, at, {}).distance <= part.radius + margin) visit(part);
                  });
}

}  // namespace

bool is_covered(const TransformedShape& floor, const TransformedShape& shape, Vec3 point,
                Vec3 normal, const std::vector<TransformedShape>& neighbours, double margin) {
    if (kind_of(*floor.geometry) == ShapeKind::plane) return false;
    bool covered = false, uncovered = false;
    const Aabb box =
        bounds_of(TransformedShape{shape.geometry, shape.position - point, shape.axes});
    for_each_part_at(shape, point, margin, [&](const Convex& moving) {
        for_each_part_at(floor, point, margin, [&](const Convex& piece) {
            SeamContact contact(moving, piece, normal, margin);
            for (const TransformedShape& neighbour : neighbours)
                test_neighbour(
                    contact, {neighbour.geometry, neighbour.position - point, neighbour.axes}, box);
            (contact.covering_normal() ? covered : uncovered) = true;
        });
    });
    return covered && !uncovered;
}

}  // namespace jostle::physics
