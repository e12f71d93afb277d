// SPDX-License-Identifier: MIT
#include "modules/ragdoll/src/figure_checks.h"

namespace jostle::modules {
namespace {

using namespace physics;

constexpr std::size_t bones_max = 256;

bool is_within(double x, double low, double high) {
    return x >= low && x <= high;  // false for NaN
}

bool is_rotation(Quat q) {
    return is_within(norm_squared(q), 0.99, 1.01);
}

std::string name_of(const RagdollDef& def, std::size_t k) {
    const std::string& name = def.bones[k].name;
    return "bones[" + std::to_string(k) + "]" + (name.empty() ? "" : " (" + name + ")");
}

Status check_bone(const RagdollDef& def, std::size_t k) {
    const RagdollBone& bone = def.bones[k];
    const std::string where = name_of(def, k);
    if (k == 0 && bone.parent != -1)
        return invalid_argument(where + " is the root; its parent must be -1");
    if (k > 0 && (bone.parent < 0 || bone.parent >= static_cast<int>(k)))
        return invalid_argument(where + ": parent is " + std::to_string(bone.parent) +
                                "; it must be the index of an earlier bone");
    if (bone.shapes.empty())
        return invalid_argument(where + " has no shape; it must have at least one");
    if (!is_finite(bone.rest) || !is_rotation(bone.rest.rotation))
        return invalid_argument(where + ": rest must have a finite position and a unit quaternion");
    if (k == 0) return {};
    if (!is_finite(bone.frame) || !is_rotation(bone.frame.rotation))
        return invalid_argument(where +
                                ": frame must have a finite position and a unit quaternion");
    const bool known = std::holds_alternative<BallJoint>(bone.joint) ||
                       std::holds_alternative<HingeJoint>(bone.joint) ||
                       std::holds_alternative<ConeTwistJoint>(bone.joint);
    if (!known)
        return invalid_argument(where + ": joint is a " + kind_name(bone.joint) +
                                "; it must be a ball, a hinge or a cone-twist");
    return check_muscle(bone.muscle, where);
}

}  // namespace

Status check_muscle(const Muscle& muscle, const std::string& where) {
    if (!is_within(muscle.hertz, 0, 1000))
        return invalid_argument(where + ": muscle.hertz must be from 0 to 1000");
    if (!is_within(muscle.damping_ratio, 0, 10))
        return invalid_argument(where + ": muscle.damping_ratio must be from 0 to 10");
    if (!is_within(muscle.max_torque, 0, 1e9))
        return invalid_argument(where + ": muscle.max_torque must be from 0 to 1e9 N m");
    return {};
}

Status check_figure(const RagdollDef& def) {
    if (def.bones.empty() || def.bones.size() > bones_max)
        return invalid_argument("bones has " + std::to_string(def.bones.size()) +
                                " elements; it must have 1 to " + std::to_string(bones_max));
    for (std::size_t k = 0; k < def.bones.size(); k++)
        if (Status s = check_bone(def, k); !s.ok()) return s;
    return {};
}

}  // namespace jostle::modules
