// SPDX-License-Identifier: MIT
#include "physics/src/collision/narrowphase/clip.h"

#include "jostle/base/check.h"
#include "physics/src/collision/narrowphase/manifold_reduction.h"
#include "physics/src/collision/narrowphase/polyhedron.h"
#include "physics/src/collision/narrowphase/segments.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/math/is_unit.h"

namespace jostle::physics {
namespace {

constexpr int rim_points = 8;  // corners that approximate the rim of a disc

// A disc normal to the local y axis at height y, with one corner in the direction of d. Its corners
// run counter-clockwise around f.normal, as those of all faces that add_clipped() clips against.
void put_disc(Feature& f, double y, double radius, Vec3 d) {
    const double across = square_root(d.x * d.x + d.z * d.z);
    // If the disc is parallel to the other shape's face, the corners are fixed, so that a resting
    // rim keeps its points.
    const Vec3 first = across > 1e-4 ? Vec3{d.x / across, 0, d.z / across} : Vec3{1, 0, 0};
    const Vec3 second = cross(f.normal, first);
    constexpr double half = 0.70710678118654752440;
    static constexpr double turn[rim_points][2] = {{1, 0},  {half, half},   {0, 1},  {-half, half},
                                                   {-1, 0}, {-half, -half}, {0, -1}, {half, -half}};
    f.count = rim_points;
    ASSERT(radius >= 0);
    for (int k = 0; k < rim_points; k++) {
        f.corner[k] = (first * turn[k][0] + second * turn[k][1]) * radius;
        f.corner[k].y = y;
    }
}

Feature feature_of_cylinder(Vec3 size, Vec3 d) {
    Feature f;
    const double across = square_root(d.x * d.x + d.z * d.z);
    if (absolute(d.y) >= across) {
        f.normal = {0, d.y < 0 ? -1.0 : 1.0, 0};
        put_disc(f, f.normal.y * size.y, size.x, d);
        return f;
    }
    f.normal = {d.x / across, 0, d.z / across};
    f.count = 2;
    f.corner[0] = f.normal * size.x + Vec3{0, -size.y, 0};
    f.corner[1] = f.normal * size.x + Vec3{0, size.y, 0};
    return f;
}

Feature feature_of_cone(Vec3 size, Vec3 d) {
    Feature f;
    const double across = square_root(d.x * d.x + d.z * d.z), height = 2 * size.y;
    const double slant = square_root(size.x * size.x + height * height);
    ASSERT(!(slant <= 0));
    const double side = across * (height / slant) + d.y * (size.x / slant);
    if (-d.y >= side) {
        f.normal = {0, -1, 0};
        put_disc(f, -size.y, size.x, d);
        return f;
    }
    const Vec3 out = across > 1e-12 ? Vec3{d.x / across, 0, d.z / across} : Vec3{1, 0, 0};
    f.normal = out * (height / slant) + Vec3{0, size.x / slant, 0};
    f.count = 2;
    f.corner[0] = out * size.x + Vec3{0, -size.y, 0};
    f.corner[1] = {0, size.y, 0};
    return f;
}

Feature feature_of_polyhedron(const Convex& shape, Vec3 d) {
    PolyhedronParts parts;
    const Polyhedron p = polyhedron_of(shape, parts);
    ASSERT(!p.faces.empty());
    std::size_t best = 0;
    double most = -1e300;
    for_each_face_along(p, d, [&](std::size_t k, double along) {
        if (p.faces[k].count < 3 || along <= most + 1e-9) return;
        most = along;
        best = k;
    });
    Feature f;
    f.normal = p.faces[best].normal;
    ASSERT(p.faces[best].count <= max_face_vertices);
    for (const std::uint16_t v : p.vertices_of(p.faces[best])) f.corner[f.count++] = p.vertices[v];
    return f;
}

// The edge of a polyhedron that faces d and is parallel to u within six degrees: two corners, or
// none.
Feature edge_of_polyhedron(const Convex& shape, Vec3 d, Vec3 u) {
    PolyhedronParts parts;
    const Polyhedron p = polyhedron_of(shape, parts);
    const auto height = [&](std::uint16_t v) { return dot(p.vertices[v], d); };
    double top = -1e300, most = -1e300;
    Feature f;
    for (const HullEdge& e : p.edges) {
        const double from = height(e.from), to = height(e.to);
        top = maximum(top, maximum(from, to));
        const Vec3 along = p.vertices[e.to] - p.vertices[e.from];
        const double uv = dot(u, along);
        if (uv * uv < 0.99 * length_squared(along) * length_squared(u) || from + to <= most)
            continue;
        most = from + to;
        f.count = 2;
        f.corner[0] = p.vertices[e.from];
        f.corner[1] = p.vertices[e.to];
    }
    const auto reached = [&](Vec3 corner) { return dot(corner, d) >= top - 1e-9; };
    if (f.count == 2 && !reached(f.corner[0]) && !reached(f.corner[1])) f.count = 0;
    return f;
}

Feature local_feature(const Convex& shape, Vec3 d) {
    switch (shape.core) {
        case Core::point: {
            Feature f{.count = 1, .corner = {}, .normal = d};
            return f;
        }
        case Core::segment: {
            Feature f{.count = 2, .corner = {}, .normal = normalized(Vec3{d.x, 0, d.z}, d)};
            f.corner[0].y = -shape.size.y;
            f.corner[1].y = shape.size.y;
            return f;
        }
        case Core::cylinder:
            return feature_of_cylinder(shape.size, d);
        case Core::cone:
            return feature_of_cone(shape.size, d);
        case Core::box:
        case Core::hull:
        case Core::triangle:
            break;
    }
    return feature_of_polyhedron(shape, d);
}

// A convex polygon, a segment or a point that is clipped to planes.
class ClippedFeature {
public:
    explicit ClippedFeature(const Feature& f) : count_(f.count) {
        ASSERT(count_ > 0 && count_ <= ContactPoints::capacity);
        for (int k = 0; k < count_; k++) polygon_[0][k] = f.corner[k];
        find_ball();
    }

    int count() const { return count_; }
    Vec3 operator[](int k) const { return polygon_[now_][k]; }

    // Clips to the inner side of the plane through p with the normal `side` of any length.
    void cut(Vec3 side, Vec3 p) {
        const double l2 = length_squared(side);
        if (l2 < 1e-290) return;
        // Most planes are beyond a ball around all corners.
        const double depth = dot(side, p - center_);
        if (depth >= 0 && depth * depth >= radius2_ * l2) return;
        const double l = square_root(l2);
        const Vec3 normal = side * (1 / l);
        const double offset = dot(side, p) / l;
        double height[ContactPoints::capacity], highest = -1e300;
        for (int k = 0; k < count_; k++) {
            height[k] = dot(normal, polygon_[now_][k]) - offset;
            highest = maximum(highest, height[k]);
        }
        if (highest > slack) cut(height);
    }

private:
    static constexpr double slack = 1e-12;  // m

    void cut(const double* height) {
        const auto& from = polygon_[now_];
        auto& retained = polygon_[1 - now_];
        int made = 0;
        const bool open = count_ == 2;  // a segment has no closing side
        for (int k = 0; k < count_; k++) {
            const Vec3 p = from[k];
            const double hp = height[k];
            if (hp <= slack) retained[made++] = p;
            if (count_ == 1 || (open && k == 1)) continue;
            const int next = k + 1 < count_ ? k + 1 : 0;
            const double hq = height[next];
            if ((hp < -slack && hq > slack) || (hp > slack && hq < -slack))
                retained[made++] = p + (from[next] - p) * (hp / (hp - hq));
            if (made + 2 >= ContactPoints::capacity) break;
        }
        ASSERT(made <= ContactPoints::capacity);
        count_ = made;
        now_ = 1 - now_;
        // The old ball still contains the polygon. A smaller one pays if many planes follow.
        if (made > 8 && ++cuts_ % 4 == 0) find_ball();
    }

    void find_ball() {
        Vec3 sum;
        for (int k = 0; k < count_; k++) sum += polygon_[now_][k];
        center_ = sum * (1.0 / count_);
        radius2_ = 0;
        for (int k = 0; k < count_; k++)
            radius2_ = maximum(radius2_, length_squared(polygon_[now_][k] - center_));
    }

    int count_, now_ = 0, cuts_ = 0;
    Vec3 center_;
    double radius2_ = 0;
    UninitializedArray<Vec3, ContactPoints::capacity> polygon_[2];
};

struct Sink {
    ContactPoints& out;
    Vec3 normal;
    double radius_a, radius_b;
    double margin;

    // `pa` and `pb` lie on the cores. One of them was projected onto the other's face along the
    // normal.
    void add(Vec3 pa, Vec3 pb) { add(pa, pb, dot(pb - pa, normal)); }
    void add(Vec3 pa, Vec3 pb, double distance) {
        if (out.count == ContactPoints::capacity) return;
        const double gap = distance - radius_a - radius_b;
        if (gap > margin) return;
        out.gap[out.count] = gap;
        out.point[out.count] = (pa + normal * radius_a + pb - normal * radius_b) * 0.5;
        out.count++;
    }
};

// Two nearly parallel edges: adds the ends of their overlap. For round edges that cross it also
// adds two points around the closest point. Returns false if the edges cross at a large angle.
bool add_side_by_side(Sink& sink, const Feature& fa, const Feature& fb, Vec3 n) {
    const double half_a = 0.5 * length(fa.corner[1] - fa.corner[0]);
    const double half_b = 0.5 * length(fb.corner[1] - fb.corner[0]);
    ASSERT(fa.count == 2 && fb.count == 2);
    if (half_a == 0 || half_b == 0) return false;
    const Vec3 a = (fa.corner[0] + fa.corner[1]) * 0.5, b = (fb.corner[0] + fb.corner[1]) * 0.5;
    const Vec3 u = (fa.corner[1] - fa.corner[0]) * (0.5 / half_a);
    const Vec3 v = (fb.corner[1] - fb.corner[0]) * (0.5 / half_b);
    const double cosine = dot(u, v);
    if (cosine * cosine < 0.99 || absolute(dot(n, u)) > 0.1) return false;
    // The interval of edge b projected onto edge a.
    const double middle = dot(b - a, u), reach = half_b * absolute(cosine);
    const double low = maximum(-half_a, middle - reach), high = minimum(half_a, middle + reach);
    if (high - low < 0.04 * half_a) return false;
    const double radius = sink.radius_a + sink.radius_b;
    const auto add_at = [&](double s) {
        const Vec3 pa = a + u * s;
        const Vec3 pb = b + v * clamp(dot(pa - b, v), -half_b, half_b);
        // At the ends of the overlap, the distance between round edges is not exactly along the
        // contact normal.
        const double along = dot(pb - pa, n);
        sink.add(pa, pb, along > 0 && radius > 0 ? length(pb - pa) : along);
    };
    add_at(low);
    add_at(high);
    if (radius == 0) return true;
    const double nearest = closest_on_segments(a, u, half_a, b, v, half_b).s;
    const double aside = half_of_crossing(radius, radius, cosine);
    for (const double s : {nearest - aside, nearest + aside})
        if (low < s && s < high) add_at(s);
    return true;
}

// A capsule that lies along the edge of a polyhedron that contains the witness. With a single point
// it would rock from end to end.
bool add_along_edge(Sink& sink, const Convex& a, const Convex& b, const Feature& fa,
                    const Feature& fb, const Witness& witness) {
    const Vec3 n = witness.normal;
    const double near = 1e-3 * (sink.radius_a + sink.radius_b);
    const auto edge = [&](const Convex& shape, Vec3 d, Vec3 u, Vec3 at) {
        Feature f = edge_of_polyhedron(shape, transposed_times(shape.axes, d),
                                       transposed_times(shape.axes, u));
        for (int k = 0; k < f.count; k++) f.corner[k] = shape.position + shape.axes * f.corner[k];
        // Another edge of a nearly horizontal face may be higher.
        if (f.count == 2 && length(cross(at - f.corner[0], f.corner[1] - f.corner[0])) >
                                near * length(f.corner[1] - f.corner[0]))
            f.count = 0;
        return f;
    };
    if (a.core == Core::segment && is_polyhedron(b)) {
        const Feature eb = edge(b, -n, fa.corner[1] - fa.corner[0], witness.on_b);
        return eb.count == 2 && add_side_by_side(sink, fa, eb, n);
    }
    if (b.core == Core::segment && is_polyhedron(a)) {
        const Feature ea = edge(a, n, fb.corner[1] - fb.corner[0], witness.on_a);
        return ea.count == 2 && add_side_by_side(sink, ea, fb, n);
    }
    return false;
}

// Clips the incident feature to the outline of the reference face and measures the distance of its
// corners from that face along the normal.
void add_clipped(Sink& sink, const Feature& reference, const Feature& incident, Vec3 n,
                 bool reference_is_a) {
    ClippedFeature polygon(incident);
    ASSERT(reference.count >= 2);
    for (int k = 0; k < reference.count && polygon.count() > 0; k++) {
        const Vec3 p = reference.corner[k], q = reference.corner[(k + 1) % reference.count];
        // The clipping prism extends along the contact normal, not the face normal. Points that are
        // opposite each other along the contact normal stay paired.
        polygon.cut(reference_is_a ? cross(q - p, n) : cross(n, q - p), p);
    }
    const double slope = dot(reference.normal, n);
    ASSERT(polygon.count() == 0 || slope != 0);
    for (int k = 0; k < polygon.count(); k++) {
        const double rise = dot(reference.normal, polygon[k] - reference.corner[0]) / slope;
        const Vec3 on_reference = polygon[k] - n * rise;
        if (reference_is_a)
            sink.add(on_reference, polygon[k]);
        else
            sink.add(polygon[k], on_reference);
    }
}

}  // namespace

Feature feature_along(const Convex& shape, Vec3 direction) {
    Feature f = local_feature(shape, transposed_times(shape.axes, direction));
    f.normal = shape.axes * f.normal;
    ASSERT(f.count >= 1 && f.count <= static_cast<int>(max_face_vertices));
    for (int k = 0; k < f.count; k++) f.corner[k] = shape.position + shape.axes * f.corner[k];
    return f;
}

ContactPoints contact_points(const Convex& a, const Convex& b, const Witness& witness,
                             double margin) {
    ContactPoints out;
    const Vec3 n = witness.normal;
    const double deepest = witness.distance - a.radius - b.radius;
    Sink sink{out, n, a.radius, b.radius, margin};
    double lost = 5e-5 * minimum(size_of(a), size_of(b));
    if (a.core != Core::point && b.core != Core::point) {
        const Feature fa = feature_along(a, n), fb = feature_along(b, -n);
        const double alignment_a = fa.count >= 3 ? dot(fa.normal, n) : -1;
        const double alignment_b = fb.count >= 3 ? -dot(fb.normal, n) : -1;
        // A face can be the reference face only if its normal is near the contact normal. An edge
        // in that face is used only if the face is the touching feature.
        const double least = fa.count == 2 || fb.count == 2 ? 0.995 : 0.5;
        const bool on_face = maximum(alignment_a, alignment_b) > 1 - 1e-9;
        bool side_by_side =
            !on_face && witness.distance > 0 && add_along_edge(sink, a, b, fa, fb, witness);
        if (!side_by_side && maximum(alignment_a, alignment_b) >= least) {
            if (alignment_a >= alignment_b - 1e-9)
                add_clipped(sink, fa, fb, n, true);
            else
                add_clipped(sink, fb, fa, n, false);
        } else if (!side_by_side && fa.count == 2 && fb.count == 2) {
            side_by_side = add_side_by_side(sink, fa, fb, n);
        }
        if (side_by_side) lost = maximum(lost, tuning::crossing_gap * (a.radius + b.radius));
    }
    // Clipping can lose the point that produced the normal. Add it again.
    double lowest = 1e300;
    for (int k = 0; k < out.count; k++) lowest = minimum(lowest, out.gap[k]);
    ASSERT(out.count <= ContactPoints::capacity);
    if (lowest > deepest + lost * (1 + 1e-6) && deepest <= margin) {
        if (out.count == ContactPoints::capacity) out.count--;
        out.witness_added = true;
        out.gap[out.count] = deepest;
        out.point[out.count] = (witness.on_a + n * a.radius + witness.on_b - n * b.radius) * 0.5;
        out.count++;
    }
    return out;
}

ContactPoints points_over_face(const Convex& a, const Convex& b, Vec3 n, double margin) {
    ContactPoints out;
    Sink sink{out, n, a.radius, b.radius, margin};
    add_clipped(sink, feature_along(a, n), feature_along(b, -n), n, true);
    return out;
}

Manifold manifold_of(const ContactPoints& points, Vec3 normal, double size) {
    Manifold m{.normal = normal};
    UninitializedArray<FacePoint, ContactPoints::capacity> flat;
    const Vec3 u =
        normalized(cross(normal, absolute(normal.x) < 0.7 ? Vec3{1, 0, 0} : Vec3{0, 0, 1}));
    const Vec3 v = cross(normal, u);
    for (int k = 0; k < points.count; k++)
        flat[k] = {dot(points.point[k], u), dot(points.point[k], v), points.gap[k], k};
    m.count = reduce_to_four(flat.data(), points.count, size);
    ASSERT(m.count >= 0 && m.count <= 4 && m.count <= points.count);
    for (int k = 0; k < m.count; k++) {
        m.point[k] = points.point[flat[k].index];
        m.gap[k] = points.gap[flat[k].index];
        m.distance = k == 0 ? m.gap[0] : minimum(m.distance, m.gap[k]);
    }
    return m;
}

}  // namespace jostle::physics
