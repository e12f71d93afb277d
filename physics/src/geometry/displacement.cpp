// SPDX-License-Identifier: MIT
#include "physics/src/geometry/shape_measures.h"

#include <algorithm>
#include <array>

#include "jostle/base/check.h"
#include "jostle/physics/compound.h"
#include "jostle/physics/hull.h"
#include "physics/src/geometry/mass_properties.h"
#include "physics/src/geometry/support.h"
#include "physics/src/math/is_unit.h"

namespace jostle::physics {
namespace {

struct HalfSpace {
    Vec3 normal;
    double offset;

    double height(Vec3 p) const { return dot(normal, p) - offset; }
};

// Spherical cap (Weisstein, "Spherical Cap", MathWorld).
Displacement cap_of_sphere(double r, const HalfSpace& below) {
    const double depth = below.offset + r;
    ASSERT(depth >= 0 && depth <= 2 * r);
    const double volume = pi * depth * depth * (3 * r - depth) / 3;
    const double lack = 2 * r - depth;
    return {volume, below.normal * (-0.75 * lack * lack / (3 * r - depth))};
}

// ---- polyhedra ----

// Sums pyramids from a point of the clipping plane to the clipped faces. The cap in the clipping
// plane contributes nothing, because the apex lies in its plane, and need not be computed.
class CutPolyhedron {
public:
    CutPolyhedron(const HalfSpace& below, Vec3 middle)
        : below_(below), apex_(middle - below.normal * below.height(middle)) {}

    // Corners are counter-clockwise seen from outside.
    template <class CornerAt>
    void add_face(std::size_t count, CornerAt&& corner_at) {
        corners_ = 0;
        ASSERT(count >= 3);
        Vec3 from = corner_at(count - 1);
        double height = below_.height(from);
        for (std::size_t k = 0; k < count; k++) {
            const Vec3 to = corner_at(k);
            const double next = below_.height(to);
            if ((height <= 0) != (next <= 0))
                add_corner(from + (to - from) * (height / (height - next)));
            if (next <= 0) add_corner(to);
            from = to;
            height = next;
        }
    }
    Displacement result() const {
        if (!(volume_ > 0)) return {};
        return {volume_, apex_ + moment_ * (1 / volume_)};
    }

private:
    // Triangle fan from the first corner.
    void add_corner(Vec3 corner) {
        const Vec3 p = corner - apex_;
        if (corners_ >= 2) {
            const double volume = dot(first_, cross(last_, p)) / 6;
            volume_ += volume;
            moment_ += (first_ + last_ + p) * (0.25 * volume);
        }
        if (corners_++ == 0) first_ = p;
        last_ = p;
    }

    HalfSpace below_;
    Vec3 apex_, first_, last_, moment_;
    double volume_ = 0;
    int corners_ = 0;
};

Displacement cut_box(const Box& box, const HalfSpace& below) {
    // Corner indices; the bits are the signs of x, y, z.
    constexpr std::array<std::array<int, 4>, 6> faces{
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    const Vec3 h = box.half_extents;
    CutPolyhedron cut(below, {});
    for (const auto& face : faces)
        cut.add_face(4, [&](std::size_t k) {
            const int corner = face[k];
            return Vec3{(corner & 1) != 0 ? h.x : -h.x, (corner & 2) != 0 ? h.y : -h.y,
                        (corner & 4) != 0 ? h.z : -h.z};
        });
    return cut.result();
}

Displacement cut_hull(const ConvexHull& hull, const HalfSpace& below) {
    CutPolyhedron cut(below, hull.center);
    for (const HullFace& face : hull.faces) {
        const auto corners = hull.vertices_of(face);
        cut.add_face(corners.size(), [&](std::size_t k) { return hull.vertices[corners[k]]; });
    }
    return cut.result();
}

// ---- shapes symmetric about the y axis ----

// A section of the axis on which the squared radius is a + b y + c y^2.
struct RoundPiece {
    double from, to;
    double a, b, c;

    double radius_squared(double y) const { return maximum(a + (b + c * y) * y, 0); }
};

struct Slice {
    double area = 0;    // m^2 below the plane
    double moment = 0;  // m^3, along the horizontal component of the normal
};

// The part of a disc on one side of a chord at distance `chord` from its centre.
Slice slice_of(double radius_squared, double chord) {
    if (chord * chord >= radius_squared) return {chord > 0 ? pi * radius_squared : 0, 0};
    const double half = square_root(radius_squared - chord * chord);
    return {radius_squared * (pi - arc_tangent(half, chord)) + chord * half,
            -2.0 / 3 * half * half * half};
}

// 12-point Gauss-Legendre quadrature (Abramowitz and Stegun, table 25.4). Half of the nodes; the
// others are symmetric.
constexpr std::array<double, 6> nodes{0.1252334085114689, 0.3678314989981802, 0.5873179542866175,
                                      0.7699026741943047, 0.9041172563704749, 0.9815606342467193};
constexpr std::array<double, 6> weights{0.2491470458134028, 0.2334925365383548, 0.2031674267230659,
                                        0.1600783285433462, 0.1069393259953184, 0.0471753363865118};

class CutRound {
public:
    explicit CutRound(const HalfSpace& below)
        : below_(below),
          across_(square_root(below.normal.x * below.normal.x + below.normal.z * below.normal.z)) {}

    void add(const RoundPiece& piece) {
        // Positions at which the plane starts and stops to cut the discs. The slices are smooth in
        // between.
        const double n = below_.normal.y, s2 = across_ * across_, d = below_.offset;
        ASSERT(piece.from <= piece.to);
        std::array<double, 5> ends{piece.from, piece.to, piece.to, piece.to, piece.to};
        std::size_t count = 2;
        const auto add_end = [&](double y) {
            if (y > piece.from && y < piece.to) ends[count++] = y;
        };
        if (absolute(n) > 0.5) add_end(d / n);
        const double a = n * n - s2 * piece.c, b = -2 * d * n - s2 * piece.b,
                     c = d * d - s2 * piece.a, discriminant = b * b - 4 * a * c;
        if (discriminant > 0) {
            const double q = -0.5 * (b + (b < 0 ? -1 : 1) * square_root(discriminant));
            if (a != 0) add_end(q / a);
            if (q != 0) add_end(c / q);
        }
        std::sort(ends.begin(), ends.end());  // unused entries are at the end
        ASSERT(count <= ends.size());
        for (std::size_t k = 0; k + 1 < count; k++) integrate(piece, ends[k], ends[k + 1]);
    }
    Displacement result() const {
        if (!(volume_ > 0)) return {};
        const double lateral = across_ > 0 ? lateral_ / (volume_ * across_) : 0;
        return {volume_, {below_.normal.x * lateral, along_ / volume_, below_.normal.z * lateral}};
    }

private:
    // Substitution y = (3 t - t^3) / 2, which turns the square roots at the ends of a cut into
    // polynomials.
    void integrate(const RoundPiece& piece, double from, double to) {
        const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
        ASSERT(from <= to);
        for (std::size_t k = 0; k < nodes.size(); k++)
            for (const double t : {-nodes[k], nodes[k]}) {
                const double y = middle + half * (0.5 * t * (3 - t * t));
                const double weight = weights[k] * half * 1.5 * (1 - t * t);
                const double left = below_.offset - below_.normal.y * y;
                const double r2 = piece.radius_squared(y);
                const double chord = absolute(left) >= across_ * square_root(r2)
                                         ? (left > 0 ? 1e30 : -1e30)
                                         : left / across_;
                const Slice slice = slice_of(r2, chord);
                volume_ += slice.area * weight;
                along_ += slice.area * y * weight;
                lateral_ += slice.moment * weight;
            }
    }

    HalfSpace below_;
    double across_;  // component of the normal perpendicular to the axis
    double volume_ = 0, along_ = 0, lateral_ = 0;
};

Displacement cut_capsule(const Capsule& capsule, const HalfSpace& below) {
    const double r = capsule.radius, h = capsule.half_length;
    CutRound cut(below);
    cut.add({-h - r, -h, r * r - h * h, -2 * h, -1});
    cut.add({-h, h, r * r, 0, 0});
    cut.add({h, h + r, r * r - h * h, 2 * h, -1});
    return cut.result();
}

Displacement cut_cylinder(const Cylinder& cylinder, const HalfSpace& below) {
    CutRound cut(below);
    cut.add({-cylinder.half_length, cylinder.half_length, cylinder.radius * cylinder.radius, 0, 0});
    return cut.result();
}

Displacement cut_cone(const Cone& cone, const HalfSpace& below) {
    const double h = cone.half_length, slope = cone.radius / (2 * h);  // radius = slope (h - y)
    const double s2 = slope * slope;
    CutRound cut(below);
    cut.add({-h, h, s2 * h * h, -2 * s2 * h, s2});
    return cut.result();
}

Displacement cut_compound(const CompoundShape& compound, const HalfSpace& below) {
    Displacement sum;
    for (const CompoundChild& child : compound.children) {
        const Displacement part =
            displacement(child.geometry, inverse_rotate(child.pose.rotation, below.normal),
                         -below.height(child.pose.position));
        sum.volume += part.volume;
        sum.center += apply(child.pose, part.center) * part.volume;
    }
    if (sum.volume > 0) sum.center = sum.center * (1 / sum.volume);
    return sum;
}

}  // namespace

Displacement displacement(const Geometry& geometry, Vec3 normal, double offset) {
    const HalfSpace below{normal, offset};
    ASSERT(is_unit(normal, 1e-5));
    if (const auto* compound = std::get_if<Compound>(&geometry))
        return cut_compound(*compound->data, below);
    if (!is_convex(kind_of(geometry))) return {};
    const Convex shape = convex_of({&geometry, {}, to_matrix(Quat{})}, {});
    if (below.height(support(shape, -normal)) - shape.radius >= 0) return {};
    if (below.height(support(shape, normal)) + shape.radius <= 0) {
        const MassProperties total = mass_of(geometry, 1);
        return {total.mass, total.center};
    }
    if (const auto* sphere = std::get_if<Sphere>(&geometry))
        return cap_of_sphere(sphere->radius, below);
    if (const auto* box = std::get_if<Box>(&geometry)) return cut_box(*box, below);
    if (const auto* hull = std::get_if<Hull>(&geometry)) return cut_hull(*hull->data, below);
    if (const auto* capsule = std::get_if<Capsule>(&geometry)) return cut_capsule(*capsule, below);
    if (const auto* cylinder = std::get_if<Cylinder>(&geometry))
        return cut_cylinder(*cylinder, below);
    return cut_cone(std::get<Cone>(geometry), below);
}

}  // namespace jostle::physics
