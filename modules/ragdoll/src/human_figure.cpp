// SPDX-License-Identifier: MIT
//
// The human figure: limbs and joints of the benchmark figures, with muscles sized for the loads
// that they hold.
#include "jostle/modules/ragdoll.h"

namespace jostle::modules {
namespace {

using namespace physics;

constexpr double radians_per_degree = pi / 180;

// Limbs of a figure of 1.76 m that stands with its arms spread along x and its face towards z; m.
struct Limb {
    const char* name;
    int parent;
    Vec3 center;
    double radius, half_length;
    bool sideways;  // axis along x instead of y
    // A hinge rotates about its axis; for a shoulder, the axis is its direction. The normal,
    // perpendicular to it, is the direction of angle zero.
    bool hinge;
    Vec3 anchor, axis, normal;
    double swing, lower, upper;  // degrees
    double torque;               // N m, maximum torque of its muscle
};

constexpr Limb limbs[] = {
    {"pelvis", -1, {0, 1.00, 0}, 0.11, 0.08, true, false, {}, {}, {}, 0, 0, 0, 0},
    {"chest",
     0,
     {0, 1.30, 0},
     0.13,
     0.10,
     false,
     false,
     {0, 1.12, 0},
     {0, 1, 0},
     {1, 0, 0},
     30,
     -20,
     20,
     400},
    {"head",
     1,
     {0, 1.66, 0},
     0.10,
     0.04,
     false,
     false,
     {0, 1.54, 0},
     {0, 1, 0},
     {1, 0, 0},
     35,
     -45,
     45,
     60},
    {"left upper arm",
     1,
     {0.33, 1.42, 0},
     0.05,
     0.12,
     true,
     false,
     {0.17, 1.42, 0},
     {1, 0, 0},
     {0, 0, 1},
     80,
     -45,
     45,
     120},
    {"right upper arm",
     1,
     {-0.33, 1.42, 0},
     0.05,
     0.12,
     true,
     false,
     {-0.17, 1.42, 0},
     {-1, 0, 0},
     {0, 0, 1},
     80,
     -45,
     45,
     120},
    {"left lower arm",
     3,
     {0.64, 1.42, 0},
     0.04,
     0.13,
     true,
     true,
     {0.48, 1.42, 0},
     {0, 1, 0},
     {1, 0, 0},
     0,
     -120,
     5,
     60},
    {"right lower arm",
     4,
     {-0.64, 1.42, 0},
     0.04,
     0.13,
     true,
     true,
     {-0.48, 1.42, 0},
     {0, 1, 0},
     {1, 0, 0},
     0,
     -5,
     120,
     60},
    {"left upper leg",
     0,
     {0.10, 0.69, 0},
     0.07,
     0.16,
     false,
     false,
     {0.10, 0.89, 0},
     {0, -1, 0},
     {1, 0, 0},
     60,
     -20,
     20,
     400},
    {"right upper leg",
     0,
     {-0.10, 0.69, 0},
     0.07,
     0.16,
     false,
     false,
     {-0.10, 0.89, 0},
     {0, -1, 0},
     {1, 0, 0},
     60,
     -20,
     20,
     400},
    {"left lower leg",
     7,
     {0.10, 0.24, 0},
     0.06,
     0.18,
     false,
     true,
     {0.10, 0.46, 0},
     {1, 0, 0},
     {0, 1, 0},
     0,
     -5,
     120,
     300},
    {"right lower leg",
     8,
     {-0.10, 0.24, 0},
     0.06,
     0.18,
     false,
     true,
     {-0.10, 0.46, 0},
     {1, 0, 0},
     {0, 1, 0},
     0,
     -5,
     120,
     300},
};
constexpr double height_of_limbs = 1.80;

// Returns the rotation whose x and z axes are the given perpendicular vectors: the rotation of x,
// followed by the remaining rotation about it.
Quat rotation_of(Vec3 x, Vec3 z) {
    const Vec3 half = Vec3{1, 0, 0} + x;
    const Quat first = length_squared(half) > 1e-9 ? normalized(Quat{0, -half.z, half.y, half.x})
                                                   : Quat{0, 1, 0, 0};
    const Vec3 now = rotate(first, {0, 0, 1});
    return normalized(from_axis_angle(x, arc_tangent(dot(cross(now, z), x), dot(now, z))) * first);
}

RagdollBone bone_of(const Limb& limb, double scale) {
    RagdollBone bone{.name = limb.name, .parent = limb.parent};
    bone.rest.position = limb.center * scale;
    if (limb.sideways) bone.rest.rotation = from_axis_angle({0, 0, 1}, -pi / 2);
    bone.shapes.push_back({.geometry = Capsule{limb.radius * scale, limb.half_length * scale}});
    if (limb.parent < 0) return bone;
    const Vec3 x = limb.hinge ? limb.normal : limb.axis, z = limb.hinge ? limb.axis : limb.normal;
    bone.frame = {limb.anchor * scale, rotation_of(x, z)};
    const JointLimit limit{true, limb.lower * radians_per_degree, limb.upper * radians_per_degree};
    if (limb.hinge)
        bone.joint = HingeJoint{.limit = limit};
    else
        bone.joint = ConeTwistJoint{.swing = limb.swing * radians_per_degree, .twist = limit};
    // A torque carries a weight at a lever arm, so it scales with the fourth power of the size.
    bone.muscle = {.hertz = 12, .max_torque = limb.torque * scale * scale * scale * scale};
    return bone;
}

}  // namespace

RagdollDef human_figure(double height) {
    RagdollDef def;
    const double scale = clamp(height, 0.2, 20) / height_of_limbs;
    for (const Limb& limb : limbs) def.bones.push_back(bone_of(limb, scale));
    return def;
}

}  // namespace jostle::modules
