// SPDX-License-Identifier: MIT
#include "physics/src/collision/narrowphase/collide_pairs.h"

#include <algorithm>

#include "jostle/base/check.h"
#include "physics/src/collision/narrowphase/clip.h"
#include "physics/src/collision/narrowphase/manifold_reduction.h"
#include "physics/src/collision/narrowphase/segments.h"
#include "physics/src/foundation/uninitialized_array.h"
#include "physics/src/math/is_unit.h"

namespace jostle::physics {
namespace {

// The pair in the form that the separating axis test uses.
struct BoxPair {
    Vec3 half_a, half_b;
    Vec3 axis_a[3], axis_b[3];      // world
    Vec3 between;                   // from a's centre to b's centre, world
    double along_a[3], along_b[3];  // `between` in the axes of each box
    double r[3][3];                 // dot(axis_a[i], axis_b[j])
};

BoxPair make_pair(const TransformedShape& a, const TransformedShape& b) {
    BoxPair p{.half_a = std::get<Box>(*a.geometry).half_extents,
              .half_b = std::get<Box>(*b.geometry).half_extents,
              .axis_a = {a.axes.x, a.axes.y, a.axes.z},
              .axis_b = {b.axes.x, b.axes.y, b.axes.z},
              .between = b.position - a.position,
              .along_a = {},
              .along_b = {},
              .r = {}};
    for (int i = 0; i < 3; i++) {
        p.along_a[i] = dot(p.between, p.axis_a[i]);
        p.along_b[i] = dot(p.between, p.axis_b[i]);
        for (int j = 0; j < 3; j++) p.r[i][j] = dot(p.axis_a[i], p.axis_b[j]);
    }
    return p;
}

// For a NaN pose every comparison is false and the first axis stays. Such a body is restored at the
// end of the step.
struct FaceAxis {
    int axis = 0;                // 0-2: a face of a, 3-5: a face of b
    double preferred = -1e300;   // its separation plus the preference for the cached axis
    double separation = -1e300;  // largest over all six axes
    int widest = 0;              // index of the axis with the largest separation
};

// Tolerance in metres within which axes are equal and the first axis wins.
double tie_of(double size) {
    return minimum(1e-6, 2e-5 * size);
}

FaceAxis best_face(const BoxPair& p, double size, int cached) {
    const double preference = maximum(minimum(0.0005, 1e-3 * size), 1e-4 * size);  // m
    ASSERT(size > 0);
    const double tie = tie_of(size);
    double separation[6];
    for (int i = 0; i < 3; i++) {
        separation[i] = absolute(p.along_a[i]) - p.half_a[i] -
                        (absolute(p.r[i][0]) * p.half_b.x + absolute(p.r[i][1]) * p.half_b.y +
                         absolute(p.r[i][2]) * p.half_b.z);
        separation[3 + i] = absolute(p.along_b[i]) - p.half_b[i] -
                            (absolute(p.r[0][i]) * p.half_a.x + absolute(p.r[1][i]) * p.half_a.y +
                             absolute(p.r[2][i]) * p.half_a.z);
    }
    FaceAxis best;
    for (int k = 0; k < 6; k++) {
        double s = separation[k];
        if (s > best.separation) {
            best.separation = s;
            best.widest = k;
        }
        if (k == cached) s += preference;
        if (s > best.preferred + tie) {
            best.preferred = s;
            best.axis = k;
        }
    }
    return best;
}

struct BoxEdgeAxis {
    int i = 0, j = 0;  // edge directions of a and b
    Vec3 normal;       // from a to b
    double separation = -1e300;
};

// Uses the rotation matrix between the boxes: e_i x v has the components -v[i2] and v[i1] along the
// axes after i (Gottschalk, Lin, Manocha, "OBBTree", SIGGRAPH 1996). An edge axis with less
// separation than the faces is irrelevant; most of these are rejected before the square root.
BoxEdgeAxis best_edge(const BoxPair& p, double size, double faces) {
    const double tie = tie_of(size);
    BoxEdgeAxis best{.separation = faces - 20 * tie};
    double sign = 0, scale = 0;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
            const double c = p.r[i1][j] * p.along_a[i2] - p.r[i2][j] * p.along_a[i1];
            const double reach =
                absolute(p.r[i2][j]) * p.half_a[i1] + absolute(p.r[i1][j]) * p.half_a[i2] +
                absolute(p.r[i][j2]) * p.half_b[j1] + absolute(p.r[i][j1]) * p.half_b[j2];
            const double apart =
                absolute(c) - reach;  // times the length of the axis, which is at most 1
            if (apart <= minimum(0, best.separation + tie)) continue;
            const double l2 = 1 - p.r[i][j] * p.r[i][j];
            if (l2 < 1e-4) continue;  // parallel edges: a face axis is more accurate
            const double per_length = 1 / square_root(l2);
            const double s = apart * per_length;
            if (s > best.separation + tie) {
                best.i = i, best.j = j, best.separation = s;
                sign = c < 0 ? -1 : 1;
                scale = per_length;
            }
        }
    best.normal = cross(p.axis_a[best.i], p.axis_b[best.j]) * (sign * scale);
    ASSERT(scale == 0 || is_unit(best.normal, 1e-4));
    return best;
}

// The normal of the axis with the largest separation, from a to b.
Vec3 normal_of_widest(const BoxPair& p, const FaceAxis& face) {
    const int i = face.widest % 3;
    ASSERT(face.widest >= 0 && face.widest < 6);
    const bool of_a = face.widest < 3;
    const Vec3 axis = of_a ? p.axis_a[i] : p.axis_b[i];
    return (of_a ? p.along_a[i] : p.along_b[i]) < 0 ? -axis : axis;
}

// Clips the polygon to one side of the reference face: sign * coordinate <= limit.
int clip(FacePoint* polygon, int count, bool along_v, double sign, double limit) {
    UninitializedArray<FacePoint, 16> retained;
    int made = 0;
    const auto outside = [&](const FacePoint& p) { return sign * (along_v ? p.v : p.u) - limit; };
    for (int k = 0; k < count; k++) {
        const FacePoint &p = polygon[k], &q = polygon[k + 1 < count ? k + 1 : 0];
        const double op = outside(p), oq = outside(q);
        if (op <= 0) retained[made++] = p;
        if ((op < 0 && oq > 0) || (op > 0 && oq < 0)) {
            const double t = op / (op - oq);
            retained[made++] = {p.u + t * (q.u - p.u), p.v + t * (q.v - p.v),
                                p.gap + t * (q.gap - p.gap)};
        }
    }
    std::copy(retained.data(), retained.data() + made, polygon);
    ASSERT(made <= 8);
    return made;
}

// Clips the incident face, the most antiparallel face of the other box, against the face of the
// reference box with index `face`.
Manifold face_contact(const TransformedShape& a, const BoxPair& p, int axis, double margin) {
    const bool b_is_reference = axis >= 3;
    const int face = axis % 3, u = (face + 1) % 3, v = (face + 2) % 3;
    ASSERT(axis >= 0 && axis < 6);
    const Vec3* ref = b_is_reference ? p.axis_b : p.axis_a;
    const Vec3* inc = b_is_reference ? p.axis_a : p.axis_b;
    const Vec3 half_ref = b_is_reference ? p.half_b : p.half_a;
    const Vec3 half_inc = b_is_reference ? p.half_a : p.half_b;
    // Positions relative to a's centre.
    const Vec3 center_ref = b_is_reference ? p.between : Vec3{};
    const Vec3 center_inc = b_is_reference ? Vec3{} : p.between;
    const double side = b_is_reference ? -p.along_b[face] : p.along_a[face];
    const Vec3 n = ref[face] * (side > 0 ? 1.0 : -1.0);  // out of the reference box

    int incident = 0;
    double most = 0;
    for (int k = 0; k < 3; k++) {
        const double c = dot(n, inc[k]);
        if (absolute(c) > absolute(most) + 1e-6) {
            most = c;
            incident = k;
        }
    }
    const int iu = (incident + 1) % 3, iv = (incident + 2) % 3;
    const Vec3 middle = center_inc - center_ref +
                        inc[incident] * (most > 0 ? -half_inc[incident] : half_inc[incident]);
    UninitializedArray<FacePoint, 16> polygon;
    static constexpr int sign_u[4] = {1, -1, -1, 1}, sign_v[4] = {1, 1, -1, -1};
    for (int k = 0; k < 4; k++) {
        const Vec3 corner =
            middle + inc[iu] * (sign_u[k] * half_inc[iu]) + inc[iv] * (sign_v[k] * half_inc[iv]);
        polygon[k] = {dot(corner, ref[u]), dot(corner, ref[v]), dot(corner, n) - half_ref[face]};
    }
    int count = 4;
    for (int cut = 0; cut < 4 && count > 0; cut++) {
        const bool along_v = (cut & 1) != 0;
        count = clip(polygon.data(), count, along_v, cut < 2 ? 1 : -1,
                     along_v ? half_ref[v] : half_ref[u]);
    }
    int near = 0;
    for (int k = 0; k < count; k++)
        if (polygon[k].gap <= margin) polygon[near++] = polygon[k];
    count = reduce_to_four(polygon.data(), near, minimum(length(p.half_a), length(p.half_b)));
    ASSERT(count <= 4 && near <= 8);

    Manifold m{.count = count, .normal = b_is_reference ? -n : n};
    for (int k = 0; k < count; k++) {
        m.gap[k] = polygon[k].gap;
        m.point[k] = a.position + center_ref + ref[u] * polygon[k].u + ref[v] * polygon[k].v +
                     n * (half_ref[face] + 0.5 * polygon[k].gap);
    }
    return m;
}

// The closest points of two edges, relative to a's centre.
Witness edge_witness(const BoxPair& p, const BoxEdgeAxis& edge) {
    // The centre of the edge that is furthest along n.
    const auto middle = [](const Vec3* axis, Vec3 half, int along, Vec3 n) {
        Vec3 sum;
        for (int k = 0; k < 3; k++)
            if (k != along) sum += axis[k] * (dot(n, axis[k]) > 0 ? half[k] : -half[k]);
        return sum;
    };
    const Vec3 a = middle(p.axis_a, p.half_a, edge.i, edge.normal);
    const Vec3 b = p.between + middle(p.axis_b, p.half_b, edge.j, -edge.normal);
    const Vec3 u = p.axis_a[edge.i], v = p.axis_b[edge.j];
    const SegmentPair at = closest_on_segments(a, u, p.half_a[edge.i], b, v, p.half_b[edge.j]);
    return {edge.normal, edge.separation, a + u * at.s, b + v * at.t};
}

// Contacts other than face against face. `edges`: two edges are the closest features, or overlap
// least.
Manifold general_contact(const BoxPair& pair, const FaceAxis& face, const BoxEdgeAxis& edge,
                         bool edges, const Convex& a, const Convex& b, double margin) {
    const bool wider = edge.separation > face.separation;
    const double separation = wider ? edge.separation : face.separation;
    if (separation > 0) {
        const Vec3 normal = wider ? edge.normal : normal_of_widest(pair, face);
        if (const auto m = collide_apart(a, b, normal, separation, margin)) return *m;
    } else if (edges) {
        return manifold_of(contact_points(a, b, edge_witness(pair, edge), margin), edge.normal,
                           minimum(size_of(a), size_of(b)));
    }
    PairCache free;
    return collide_convex(a, b, margin, free);
}

}  // namespace

Manifold collide_boxes(const TransformedShape& a, const TransformedShape& b, double margin,
                       PairCache& cache) {
    const BoxPair pair = make_pair(a, b);
    ASSERT(!(margin < 0));
    const double size = minimum(length(pair.half_a), length(pair.half_b));
    const FaceAxis face = best_face(pair, size, static_cast<int>(cache.axis) - 1);
    if (face.separation > margin)
        return {.normal = normal_of_widest(pair, face), .distance = face.separation};
    const BoxEdgeAxis edge = best_edge(pair, size, face.separation);
    const double separation = maximum(face.separation, edge.separation);
    if (separation > margin) return {.normal = edge.normal, .distance = separation};

    // An edge axis must be better than a face axis by more than rounding, or resting faces would
    // flicker. Separated boxes may be closest at corners, where an axis shows less than the
    // distance.
    const bool edges = edge.separation > face.preferred + 2e-5 * size;
    if (!edges && separation <= 0.01 * size) {
        cache.axis = static_cast<AxisCode>(face.axis) + 1;
        Manifold m = face_contact(a, pair, face.axis, margin);
        m.distance = separation;
        // Near the margin, clipping may leave no points although the boxes are within the margin.
        if (m.count > 0) return m;
    } else {
        cache.axis = edges ? 7 : 0;
    }
    const Convex ca = convex_of(a, a.position), cb = convex_of(b, a.position);
    Manifold m = general_contact(pair, face, edge, edges, ca, cb, margin);
    for (int k = 0; k < m.count; k++) m.point[k] += a.position;
    return m;
}

}  // namespace jostle::physics
