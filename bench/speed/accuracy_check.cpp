// SPDX-License-Identifier: MIT
#include "bench/speed/accuracy_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

#include "jostle/physics/hull.h"
#include "jostle/physics/mesh.h"
#include "physics/src/geometry/bvh.h"

namespace jostle::bench {
namespace {

using physics::Box;
using physics::Capsule;
using physics::Hull;
using physics::Mat3;
using physics::Mesh;
using physics::Sphere;
using physics::Transform;
using physics::Vec3;

template <class Shape>
concept ConvexShape = !std::is_same_v<Shape, Mesh>;

struct Segment {
    Vec3 from, to;

    Vec3 at(double fraction) const { return from + (to - from) * fraction; }
};

Segment segment_of(const Capsule& capsule, const Transform& pose) {
    const Vec3 reach = rotate(pose.rotation, {0, capsule.half_length, 0});
    return {pose.position - reach, pose.position + reach};
}

Segment segment_of(const Sphere&, const Transform& pose) {
    return {pose.position, pose.position};
}

// The shortest vector from p to q. Ericson, "Real-Time Collision Detection", 5.1.9.
Vec3 minimum_translation(const Segment& p, const Segment& q) {
    const Vec3 u = p.to - p.from, v = q.to - q.from, r = p.from - q.from;
    const double uu = dot(u, u), vv = dot(v, v), uv = dot(u, v), ur = dot(u, r), vr = dot(v, r);
    const double across = uu * vv - uv * uv;
    const auto unit = [](double x) { return physics::clamp(x, 0, 1); };
    double s = across > 1e-12 * uu * vv ? unit((uv * vr - ur * vv) / across) : 0;
    double t = vv > 0 ? (uv * s + vr) / vv : 0;
    if (vv == 0 || t < 0 || t > 1) {
        t = unit(t);
        s = uu > 0 ? unit((uv * t - ur) / uu) : 0;
    }
    return q.at(t) - p.at(s);
}

double distance(const Segment& p, const Segment& q) {
    return length(minimum_translation(p, q));
}

// Distance of a point from a box around the origin; inside, the negative distance to the nearest
// face.
double distance(Vec3 point, const Box& box) {
    const Vec3 d = abs(point) - box.half_extents;
    const double inside = physics::minimum(0, physics::maximum(d.x, physics::maximum(d.y, d.z)));
    return length(max(d, {})) + inside;
}

// The smallest overlap of two shapes' projections on the tested axes. Over all face normals and all
// products of edges it is the overlap of two polytopes (separating axis theorem).
struct SeparatingAxes {
    double least = std::numeric_limits<double>::infinity();

    void try_axis(Vec3 axis, Vec3 between, auto both_radii) {
        const double size = length(axis);
        if (size < 1e-6) return;  // parallel edges; a face normal covers this axis
        axis = axis * (1 / size);
        least = physics::minimum(least, both_radii(axis) - physics::absolute(dot(axis, between)));
    }
};

double projected_radius(const Mat3& axes, Vec3 half_extents, Vec3 along) {
    return dot(abs(transposed_times(axes, along)), half_extents);
}

double depth(const Box& a, const Transform& pose_a, const Box& b, const Transform& pose_b) {
    const Mat3 in_a = to_matrix(pose_a.rotation), in_b = to_matrix(pose_b.rotation);
    const Vec3 between = pose_b.position - pose_a.position;
    const auto both = [&](Vec3 along) {
        return projected_radius(in_a, a.half_extents, along) +
               projected_radius(in_b, b.half_extents, along);
    };
    SeparatingAxes tried;
    for (const Mat3* axes : {&in_a, &in_b})
        for (const Vec3& normal : {axes->x, axes->y, axes->z})
            tried.try_axis(normal, between, both);
    if (tried.least <= 0) return tried.least;
    for (const Vec3& edge_a : {in_a.x, in_a.y, in_a.z})
        for (const Vec3& edge_b : {in_b.x, in_b.y, in_b.z})
            tried.try_axis(cross(edge_a, edge_b), between, both);
    return tried.least;
}

// Depth of a segment in a box around the origin; zero or less if they do not intersect.
double depth_of_core(const Segment& core, const Box& box) {
    const Vec3 reach = (core.to - core.from) * 0.5, between = core.at(0.5);
    const auto both = [&](Vec3 along) {
        return dot(abs(along), box.half_extents) + physics::absolute(dot(along, reach));
    };
    SeparatingAxes tried;
    for (const Vec3& edge : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
        tried.try_axis(edge, between, both);
        tried.try_axis(cross(edge, reach), between, both);
    }
    return tried.least;
}

// The distance to a convex shape is a convex function along a line, so a ternary search finds the
// minimum.
double distance(const Segment& core, const Box& box) {
    double low = 0, high = 1;
    for (int k = 0; k < 60; k++) {
        const double third = (high - low) / 3;
        const bool first_half =
            distance(core.at(low + third), box) < distance(core.at(high - third), box);
        (first_half ? high : low) += first_half ? -third : third;
    }
    return distance(core.at(0.5 * (low + high)), box);
}

double depth(const Capsule& capsule, const Transform& pose, const Box& box,
             const Transform& pose_of_box) {
    const Segment world = segment_of(capsule, pose);
    const Segment core{apply_inverse(pose_of_box, world.from),
                       apply_inverse(pose_of_box, world.to)};
    const double inside = depth_of_core(core, box);
    return capsule.radius + (inside > 0 ? inside : -distance(core, box));
}

double depth(const Sphere& sphere, const Transform& pose, const Box& box,
             const Transform& pose_of_box) {
    return sphere.radius - distance(apply_inverse(pose_of_box, pose.position), box);
}

double depth(const Capsule& a, const Transform& pose_a, const Capsule& b, const Transform& pose_b) {
    return a.radius + b.radius - distance(segment_of(a, pose_a), segment_of(b, pose_b));
}

double depth(const Sphere& a, const Transform& pose_a, const Capsule& b, const Transform& pose_b) {
    return depth(Capsule{a.radius, 0}, pose_a, b, pose_b);
}

double depth(const Sphere& a, const Transform& pose_a, const Sphere& b, const Transform& pose_b) {
    return a.radius + b.radius - length(pose_a.position - pose_b.position);
}

// Half extents of the axis-aligned box around a shape.
Vec3 reach_of(const Sphere& sphere, const Transform&) {
    return {sphere.radius, sphere.radius, sphere.radius};
}

Vec3 reach_of(const Capsule& capsule, const Transform& pose) {
    return abs(rotate(pose.rotation, {0, capsule.half_length, 0})) +
           reach_of(Sphere{capsule.radius}, pose);
}

Vec3 reach_of(const Box& box, const Transform& pose) {
    const Mat3 axes = to_matrix(pose.rotation);
    return abs(axes.x) * box.half_extents.x + abs(axes.y) * box.half_extents.y +
           abs(axes.z) * box.half_extents.z;
}

// Around the origin of the hull, which may differ from its centre.
Vec3 reach_of(const Hull& hull, const Transform& pose) {
    Vec3 reach;
    for (const Vec3& v : hull.data->vertices) reach = max(reach, abs(rotate(pose.rotation, v)));
    return reach;
}

// Largest projection of the shape on a direction, m.
double support(const Sphere& sphere, const Transform& pose, Vec3 n) {
    return dot(pose.position, n) + sphere.radius * length(n);
}

double support(const Capsule& capsule, const Transform& pose, Vec3 n) {
    return dot(pose.position, n) + capsule.radius * length(n) +
           capsule.half_length * physics::absolute(inverse_rotate(pose.rotation, n).y);
}

double support(const Box& box, const Transform& pose, Vec3 n) {
    return dot(pose.position, n) + dot(abs(inverse_rotate(pose.rotation, n)), box.half_extents);
}

double support(const Hull& hull, const Transform& pose, Vec3 n) {
    const Vec3 in_hull = inverse_rotate(pose.rotation, n);
    double furthest = -std::numeric_limits<double>::infinity();
    for (const Vec3& v : hull.data->vertices)
        furthest = physics::maximum(furthest, dot(v, in_hull));
    return dot(pose.position, n) + furthest;
}

// Outward normals of the faces; a box has the normals of the equivalent hull.
std::vector<Vec3> face_normals(const auto& shape, const Transform& pose) {
    std::vector<Vec3> normals;
    if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, Hull>)
        for (const physics::HullFace& face : shape.data->faces)
            normals.push_back(rotate(pose.rotation, face.normal));
    if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, Box>)
        for (const double side : {1.0, -1.0})
            for (const Vec3& axis : {Vec3{side, 0, 0}, Vec3{0, side, 0}, Vec3{0, 0, side}})
                normals.push_back(rotate(pose.rotation, axis));
    return normals;
}

// An edge and the normals of its two adjacent faces. Without faces, any normal perpendicular to the
// edge is possible.
struct Edge {
    Vec3 from, along, left, right;
    bool has_faces = false;
};

std::vector<Edge> edges_of(const auto& shape, const Transform& pose) {
    using Shape = std::decay_t<decltype(shape)>;
    std::vector<Edge> edges;
    const auto turned = [&](Vec3 v) { return rotate(pose.rotation, v); };
    if constexpr (std::is_same_v<Shape, Hull>)
        for (const physics::HullEdge& e : shape.data->edges)
            edges.push_back({apply(pose, shape.data->vertices[e.from]),
                             turned(shape.data->vertices[e.to] - shape.data->vertices[e.from]),
                             turned(shape.data->faces[e.left].normal),
                             turned(shape.data->faces[e.right].normal), true});
    if constexpr (std::is_same_v<Shape, Box>)
        for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
            edges.push_back({.along = turned(axis)});
    if constexpr (std::is_same_v<Shape, Capsule>) edges.push_back({.along = turned({0, 1, 0})});
    return edges;
}

// Tests whether the arcs between the face normals of the two edges, one of them negated, cross on
// the sphere. Otherwise the edges form no face of the Minkowski difference (Gregorius, "The
// separating axis test between convex polyhedra", GDC 2013).
bool arcs_cross(const Edge& x, const Edge& y) {
    if (!x.has_faces || !y.has_faces) return true;
    const double a = -dot(y.left, x.along), b = -dot(y.right, x.along);
    const double c = dot(x.left, y.along), d = dot(x.right, y.along);
    return a * b < 0 && c * d < 0 && a * d > 0;
}

// The overlap of two convex shapes is the smallest overlap of their projections over all directions
// from a to b. Candidates are the face normals, the products of edges, and, for round shapes, the
// direction from the core to the nearest point of an edge.
template <class A, class B>
double min_overlap(const A& a, const Transform& pose_a, const B& b, const Transform& pose_b) {
    const auto overlap = [&](Vec3 n) { return support(a, pose_a, n) + support(b, pose_b, -n); };
    Vec3 best = normalized(pose_b.position - pose_a.position);
    double least = overlap(best);
    const auto try_one = [&](Vec3 n) {
        const double value = overlap(n);
        if (value >= least) return false;
        least = value;
        best = n;
        return true;
    };
    for (const Vec3& n : face_normals(a, pose_a)) try_one(n);
    for (const Vec3& n : face_normals(b, pose_b)) try_one(-n);
    if (least <= 0) return least;
    const std::vector<Edge> of_a = edges_of(a, pose_a), of_b = edges_of(b, pose_b);
    for (const Edge& x : of_a)
        for (const Edge& y : of_b) {
            const Vec3 across = cross(x.along, y.along);
            if (length(across) < 1e-6 * length(x.along) * length(y.along) || !arcs_cross(x, y))
                continue;
            try_one(normalized(across));
            try_one(-normalized(across));
        }
    if constexpr (requires { segment_of(a, pose_a); })
        for (const Edge& y : of_b) {
            const Vec3 direction =
                minimum_translation(segment_of(a, pose_a), {y.from, y.from + y.along});
            if (length(direction) > 0) try_one(normalized(direction));
        }
    return least;
}

double depth(const ConvexShape auto& shape, const Transform& pose, const Hull& hull,
             const Transform& pose_of_hull) {
    return min_overlap(shape, pose, hull, pose_of_hull);
}

// Tests whether a point in the plane of a triangle is inside the triangle.
bool is_within(Vec3 point, const std::array<Vec3, 3>& corners, Vec3 normal) {
    for (std::size_t k = 0; k < 3; k++) {
        const Vec3 from = corners[k], along = corners[(k + 1) % 3] - from;
        if (dot(cross(along, point - from), normal) < 0) return false;
    }
    return true;
}

// The point of the shape that is farthest along a direction.
Vec3 furthest_point(const Sphere& sphere, const Transform& pose, Vec3 n) {
    return pose.position + n * sphere.radius;
}
Vec3 furthest_point(const Capsule& capsule, const Transform& pose, Vec3 n) {
    const Vec3 reach = rotate(pose.rotation, {0, capsule.half_length, 0});
    return pose.position + (dot(reach, n) < 0 ? -reach : reach) + n * capsule.radius;
}
Vec3 furthest_point(const Box& box, const Transform& pose, Vec3 n) {
    Vec3 corner = inverse_rotate(pose.rotation, n);
    for (int k = 0; k < 3; k++) corner[k] = std::copysign(box.half_extents[k], corner[k]);
    return apply(pose, corner);
}
Vec3 furthest_point(const Hull& hull, const Transform& pose, Vec3 n) {
    const Vec3 in_hull = inverse_rotate(pose.rotation, n);
    return apply(pose, *std::ranges::max_element(hull.data->vertices, {},
                                                 [&](const Vec3& v) { return dot(v, in_hull); }));
}

// Points deeper than this are considered to be on the other side of the surface, m.
constexpr double deepest_in_mesh = 0.5;

double depth(const ConvexShape auto& shape, const Transform& pose, const Mesh& mesh,
             const Transform& pose_of_mesh) {
    const Transform in_mesh{apply_inverse(pose_of_mesh, pose.position),
                            conjugate(pose_of_mesh.rotation) * pose.rotation};
    const Vec3 reach = reach_of(shape, in_mesh), low = in_mesh.position - reach,
               high = in_mesh.position + reach;
    double deepest = 0;
    mesh.data->tree->query({low, high}, [&](std::uint32_t index) {
        const std::array<std::uint32_t, 3>& triangle = mesh.data->triangles[index];
        const std::array<Vec3, 3> corners = {mesh.data->vertices[triangle[0]],
                                             mesh.data->vertices[triangle[1]],
                                             mesh.data->vertices[triangle[2]]};
        const Vec3 normal = normalized(cross(corners[1] - corners[0], corners[2] - corners[0]));
        const Vec3 point = furthest_point(shape, in_mesh, -normal);
        const double below = dot(corners[0] - point, normal);
        if (below > deepest && below < deepest_in_mesh && is_within(point, corners, normal))
            deepest = below;
    });
    return deepest;
}

struct Bounds {
    Vec3 low, high;
    std::uint32_t piece;
};

Vec3 reach_of(const Mesh& mesh, const Transform& pose) {
    return reach_of(Box{max(abs(mesh.data->bounds.low), abs(mesh.data->bounds.high))}, pose);
}

Bounds bounds_of(std::uint32_t piece, const Primitive& primitive, const Transform& pose) {
    const Vec3 reach =
        std::visit([&](const auto& shape) { return reach_of(shape, pose); }, primitive);
    return {pose.position - reach, pose.position + reach, piece};
}

bool overlaps(const Bounds& a, const Bounds& b) {
    return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y &&
           a.low.z < b.high.z && b.low.z < a.high.z;
}

void count(Penetration& found, double depth) {
    if (depth <= 0) return;
    found.mean += (depth - found.mean) / ++found.pairs;
    found.deepest = physics::maximum(found.deepest, depth);
    found.over_1cm += depth > 0.01 ? 1 : 0;
}

std::uint64_t pair_key(std::uint64_t a, std::uint64_t b) {
    return (std::min(a, b) << 32) | std::max(a, b);
}

}  // namespace

double penetration_depth(const Primitive& a, const Transform& pose_a, const Primitive& b,
                         const Transform& pose_b) {
    if (a.index() > b.index()) return penetration_depth(b, pose_b, a, pose_a);
    return std::visit(
        [&]<class A, class B>(const A& first, const B& second) {
            // Only the order sphere, capsule, box, hull, mesh has a depth(); other orders were
            // swapped before. Two meshes have none.
            if constexpr (requires { depth(first, pose_a, second, pose_b); })
                return depth(first, pose_a, second, pose_b);
            else
                return 0.0;
        },
        a, b);
}

AccuracyCheck::AccuracyCheck(const scenes::SceneDescription& scene) {
    for (const scenes::SceneJoint& joint : scene.joints) {
        ends_.push_back({joint.body_a, joint.body_b, joint.joint.frame_a.position,
                         joint.joint.frame_b.position});
        joined_.push_back(pair_key(joint.body_a, joint.body_b));
    }
    std::sort(joined_.begin(), joined_.end());
    for (std::uint32_t k = 0; k < scene.bodies.size(); k++) {
        const scenes::SceneBody& body = scene.bodies[k];
        if (!collides(body)) continue;
        for (Part& part : parts_of(body)) pieces_.push_back({k, is_dynamic(body), std::move(part)});
    }
}

bool AccuracyCheck::joined(std::uint32_t a, std::uint32_t b) const {
    return std::binary_search(joined_.begin(), joined_.end(), pair_key(a, b));
}

// Sort and sweep along x. The few pieces that are not dynamic are large and are tested against all
// others.
Penetration AccuracyCheck::penetration(std::span<const Transform> poses) const {
    Penetration result;
    for (const Transform& pose : poses) result.lost += is_finite(pose) ? 0 : 1;
    std::vector<Bounds> standing, moving;
    const auto pose_of = [&](const Piece& piece) {
        return compose(poses[piece.body], piece.part.pose);
    };
    for (std::uint32_t k = 0; k < pieces_.size(); k++) {
        const Piece& piece = pieces_[k];
        if (is_finite(poses[piece.body]))
            (piece.is_dynamic ? moving : standing)
                .push_back(bounds_of(k, piece.part.shape, pose_of(piece)));
    }
    std::sort(moving.begin(), moving.end(), [](const Bounds& a, const Bounds& b) {
        return a.low.x != b.low.x ? a.low.x < b.low.x : a.piece < b.piece;
    });
    const auto try_pair = [&](const Bounds& x, const Bounds& y) {
        const Piece &a = pieces_[x.piece], &b = pieces_[y.piece];
        if (a.body == b.body || !overlaps(x, y) || joined(a.body, b.body)) return;
        count(result, penetration_depth(a.part.shape, pose_of(a), b.part.shape, pose_of(b)));
    };
    for (std::size_t k = 0; k < moving.size(); k++) {
        for (const Bounds& other : standing) try_pair(moving[k], other);
        for (std::size_t l = k + 1; l < moving.size() && moving[l].low.x < moving[k].high.x; l++)
            try_pair(moving[k], moving[l]);
    }
    return result;
}

double AccuracyCheck::joint_drift(std::span<const Transform> poses) const {
    double drift = 0;
    for (const Ends& ends : ends_)
        drift = physics::maximum(
            drift, length(apply(poses[ends.a], ends.in_a) - apply(poses[ends.b], ends.in_b)));
    return drift;
}

}  // namespace jostle::bench
