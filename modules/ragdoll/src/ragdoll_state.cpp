// SPDX-License-Identifier: MIT
//
// Serialization and scene settings of figures.
#include "jostle/modules/ragdoll.h"
#include "jostle/modules/settings.h"
#include "modules/ragdoll/src/figure_checks.h"

namespace jostle::modules {

using namespace physics;

namespace {

// Fails the load if the quaternion is not a unit quaternion.
void rotation(StateVisitor& v, std::string_view name, Quat& q) {
    v.field(name, q);
    if (v.loading() && !(norm_squared(q) > 0.98 && norm_squared(q) < 1.02))
        v.fail(name, "is not a unit quaternion");
}
void visit_transform(StateVisitor& v, std::string_view name, Transform& t) {
    v.field(name, t);
    if (v.loading() && !(norm_squared(t.rotation) > 0.98 && norm_squared(t.rotation) < 1.02))
        v.fail(name, "must have a unit quaternion");
}

}  // namespace

void Ragdolls::visit(StateVisitor& v, Figure& figure) {
    v.field("alive", figure.alive);
    v.field("generation", figure.generation);
    v.field("mode", figure.mode, RagdollMode::kinematic);
    v.field("kinematic_root", figure.kinematic_root);
    v.field("moved", figure.pose_changed);
    bounded(v, "blend", figure.blend, 0, 60);
    bounded(v, "blended", figure.blend_elapsed, 0, 60);
    visit_transform(v, "root", figure.root);
    visit_transform(v, "blend_start_root", figure.blend_start_root);
    std::int32_t index = 0;
    v.all("bones", figure.bones, [&](Bone& bone) {
        v.field("body", bone.body);
        v.field("joint", bone.joint);
        v.field("parent", bone.parent);
        if (v.loading() &&
            (bone.parent < -1 || bone.parent >= index || (bone.parent == -1) != (index == 0)))
            v.fail("parent", "is not the index of an earlier bone");
        index++;
        v.field("link", bone.bone_joint.kind, BoneJointKind::cone_twist);
        v.field("limited", bone.bone_joint.limited);
        bounded(v, "lower", bone.bone_joint.lower, -pi, pi);
        bounded(v, "upper", bone.bone_joint.upper, -pi, pi);
        bounded(v, "swing", bone.bone_joint.swing, 0, pi);
        bounded(v, "friction", bone.bone_joint.friction, 0, 1e15);
        visit_transform(v, "rest", bone.rest);
        visit_transform(v, "frame", bone.frame);
        visit_transform(v, "frame_b", bone.frame_b);
        bounded(v, "hertz", bone.muscle.hertz, 0, 1000);
        bounded(v, "damping_ratio", bone.muscle.damping_ratio, 0, 10);
        bounded(v, "max_torque", bone.muscle.max_torque, 0, 1e9);
        bounded(v, "strength", bone.strength, 0, 1);
        rotation(v, "wanted", bone.target_rotation);
        rotation(v, "before", bone.previous_rotation);
        rotation(v, "from", bone.blend_start_rotation);
        v.field("speed_before", bone.previous_speed);
        if (v.loading() && !(length_squared(bone.previous_speed) < 1e18))
            v.fail("speed_before", "is out of range");
    });
    if (v.loading() && figure.alive == figure.bones.empty())
        v.fail("bones", "must be present exactly if the figure is alive");
}

void Ragdolls::visit(StateVisitor& v) {
    v.all("figures", figures_, [&](Figure& figure) { visit(v, figure); });
}

Status Ragdolls::configure(World& world, const ModuleSettings& given) {
    double count = 1, height = 1.8, spacing = 2;
    Vec3 first;
    bool powered = false, kinematic = false;
    SettingsReader settings(given);
    settings.number("count", count, 0, 200);
    settings.number("height", height, 0.2, 20);
    settings.number("spacing", spacing, 0.1, 1000);
    settings.number("x", first.x, -1e6, 1e6);
    settings.number("y", first.y, -1e6, 1e6);
    settings.number("z", first.z, -1e6, 1e6);
    settings.flag("powered", powered);
    settings.flag("kinematic", kinematic);
    if (Status s = settings.finish(); !s.ok()) return s;
    if (powered && kinematic)
        return Error{ErrorCode::invalid_argument,
                     "powered and kinematic are both 1; at most one must be 1"};
    int side = 1;
    while (side * side < static_cast<int>(count)) side++;
    const RagdollDef figure = human_figure(height);
    for (int k = 0; k < static_cast<int>(count); k++) {
        const Vec3 at = first + Vec3{spacing * (k % side), 0, spacing * (k / side)};
        const Result<RagdollId> id = add(world, figure, {.position = at});
        if (!id.ok()) return id.error();
        if (powered || kinematic)
            if (Status s =
                    set_mode(world, *id, powered ? RagdollMode::powered : RagdollMode::kinematic);
                !s.ok())
                return s;
    }
    return {};
}

}  // namespace jostle::modules
