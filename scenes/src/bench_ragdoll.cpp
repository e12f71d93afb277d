// SPDX-License-Identifier: MIT
#include "scenes/src/bench_scene_parts.h"

#include "scenes/src/scene_helpers.h"

namespace jostle::scenes {

using namespace physics;

namespace {

constexpr double degree = 0.01745329252;  // the value in the definition of the scene

struct Bone {
    Vec3 center;
    double radius, half_length;
    bool sideways;  // axis along x instead of y
};

constexpr Bone bones[] = {
    {{0, 1.00, 0}, 0.11, 0.08, true},       // 0 pelvis
    {{0, 1.30, 0}, 0.13, 0.10, false},      // 1 chest
    {{0, 1.66, 0}, 0.10, 0.04, false},      // 2 head
    {{0.33, 1.42, 0}, 0.05, 0.12, true},    // 3 left upper arm
    {{-0.33, 1.42, 0}, 0.05, 0.12, true},   // 4 right upper arm
    {{0.64, 1.42, 0}, 0.04, 0.13, true},    // 5 left lower arm
    {{-0.64, 1.42, 0}, 0.04, 0.13, true},   // 6 right lower arm
    {{0.10, 0.69, 0}, 0.07, 0.16, false},   // 7 left upper leg
    {{-0.10, 0.69, 0}, 0.07, 0.16, false},  // 8 right upper leg
    {{0.10, 0.24, 0}, 0.06, 0.18, false},   // 9 left lower leg
    {{-0.10, 0.24, 0}, 0.06, 0.18, false},  // 10 right lower leg
};

enum Kind { cone_twist, hinge };

// Kind, bodies, anchor and limits. A hinge rotates about its axis; for a shoulder, the axis is its
// direction. The normal, perpendicular to it, is the direction of angle zero. Axes of the figure.
struct BoneJoint {
    Kind kind;
    std::size_t a, b;
    Vec3 anchor, axis, normal;
    double swing, lower, upper;  // degrees
};

constexpr BoneJoint bone_joints[] = {
    {cone_twist, 0, 1, {0, 1.12, 0}, {0, 1, 0}, {1, 0, 0}, 30, -20, 20},     // waist
    {cone_twist, 1, 2, {0, 1.54, 0}, {0, 1, 0}, {1, 0, 0}, 35, -45, 45},     // neck
    {cone_twist, 1, 3, {0.17, 1.42, 0}, {1, 0, 0}, {0, 0, 1}, 80, -45, 45},  // shoulders
    {cone_twist, 1, 4, {-0.17, 1.42, 0}, {-1, 0, 0}, {0, 0, 1}, 80, -45, 45},
    {hinge, 3, 5, {0.48, 1.42, 0}, {0, 1, 0}, {1, 0, 0}, 0, -120, 5},  // elbows
    {hinge, 4, 6, {-0.48, 1.42, 0}, {0, 1, 0}, {1, 0, 0}, 0, -5, 120},
    {cone_twist, 0, 7, {0.10, 0.89, 0}, {0, -1, 0}, {1, 0, 0}, 60, -20, 20},  // hips
    {cone_twist, 0, 8, {-0.10, 0.89, 0}, {0, -1, 0}, {1, 0, 0}, 60, -20, 20},
    {hinge, 7, 9, {0.10, 0.46, 0}, {1, 0, 0}, {0, 1, 0}, 0, -5, 120},  // knees
    {hinge, 8, 10, {-0.10, 0.46, 0}, {1, 0, 0}, {0, 1, 0}, 0, -5, 120},
};

// The rotation with the columns x, y, z (Shepperd's method: divides by the largest component).
Quat from_axes(const Mat3& m) {
    const double trace = m.x.x + m.y.y + m.z.z;
    if (trace > 0) {
        const double s = 2 * square_root(trace + 1);
        return normalized(
            Quat{(m.y.z - m.z.y) / s, (m.z.x - m.x.z) / s, (m.x.y - m.y.x) / s, s / 4});
    }
    if (m.x.x >= m.y.y && m.x.x >= m.z.z) {
        const double s = 2 * square_root(1 + m.x.x - m.y.y - m.z.z);
        return normalized(
            Quat{s / 4, (m.x.y + m.y.x) / s, (m.x.z + m.z.x) / s, (m.y.z - m.z.y) / s});
    }
    // By cyclic permutation of the axes, the two other cases reduce to this one.
    const Quat turned =
        from_axes({{m.y.y, m.y.z, m.y.x}, {m.z.y, m.z.z, m.z.x}, {m.x.y, m.x.z, m.x.x}});
    return {turned.z, turned.x, turned.y, turned.w};
}

// Hinges of Jostle rotate about the z axis of their frame; cone-twist joints point along x.
Transform frame_of(const BoneJoint& link, const Transform& feet) {
    const Vec3 axis = rotate(feet.rotation, link.axis), normal = rotate(feet.rotation, link.normal);
    const Vec3 x = link.kind == hinge ? normal : axis, z = link.kind == hinge ? axis : normal;
    return {apply(feet, link.anchor), from_axes({x, cross(z, x), z})};
}

JointKind kind_of(const BoneJoint& link) {
    const JointLimit limit{true, link.lower * degree, link.upper * degree};
    if (link.kind == hinge) return HingeJoint{.limit = limit};
    return ConeTwistJoint{.swing = link.swing * degree, .twist = limit};
}

}  // namespace

void add_bench_ragdoll(SceneDescription& scene, const Transform& feet) {
    const std::size_t first = scene.bodies.size();
    const Quat y_to_x = from_axis_angle({0, 0, 1}, -pi / 2);
    for (const Bone& bone : bones) {
        const Transform pose = compose(feet, {bone.center, bone.sideways ? y_to_x : Quat{}});
        scene.bodies.push_back(dynamic_body("bone", pose.position,
                                            Capsule{bone.radius, bone.half_length}, pose.rotation));
    }
    for (const BoneJoint& link : bone_joints)
        join(scene, "joint", first + link.a, first + link.b, frame_of(link, feet), kind_of(link));
}

}  // namespace jostle::scenes
