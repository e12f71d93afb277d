// SPDX-License-Identifier: MIT
#include "jostle/modules/ragdoll.h"

#include <algorithm>
#include <cmath>

#include "jostle/modules/settings.h"
#include "modules/ragdoll/src/figure_checks.h"
#include "modules/ragdoll/src/rotation_interpolation.h"

namespace jostle::modules {

using namespace physics;

namespace {

constexpr std::size_t figures_max = 10000;
constexpr double blend_seconds_max = 60;  // s

// Pose of a bone for the pose of its parent and a rotation of its joint.
Transform bone_pose(const Transform& parent, const Transform& parent_rest, const Transform& frame,
                    const Transform& rest, Quat turn) {
    const Transform joint = compose(compose(parent, inverse(parent_rest)), frame);
    return compose(compose(joint, {{}, turn}), compose(inverse(frame), rest));
}

// Angular velocity from one rotation to another, rad/s, in the parent's frame.
Vec3 angular_velocity_between(Quat previous, Quat target_rotation, double dt) {
    return rotation_vector(target_rotation * conjugate(previous)) * (1 / dt);
}

// Lead time that compensates the lag of a muscle, s. A damped spring lags behind a moving target by
// 2 zeta / omega. The target is constant over a step, whose middle is half a step before the pose
// at its end. Springs that the sub-step does not resolve are implicit (held_spring() of the
// solver). They are solved before and after its motion, which adds the lag of two sub-steps.
double lead_time_of(const Muscle& muscle, double scale, double dt, int substeps) {
    const double h = dt / substeps, turn = 2 * pi * muscle.hertz * scale * h;
    const bool is_implicit = turn > 1 || 2 * muscle.damping_ratio * scale * turn > 1;
    return muscle.damping_ratio / (pi * muscle.hertz) - 0.5 * dt + (is_implicit ? 2 * h : 0);
}

// Displacement of the target for which the spring accelerates the bone like the pose.
Vec3 acceleration_lead(const Muscle& muscle, double strength, Vec3 acceleration) {
    const double rate = 2 * pi * muscle.hertz;
    return strength > 0 ? acceleration * (1 / (rate * rate * strength)) : Vec3{};
}

// Mass and inertia about the origin of the figure's frame, in the rest pose.
struct Inertia {
    double mass = 0;
    Vec3 moment;  // kg m
    Mat3 inertia = diagonal({0, 0, 0});

    void add(const Inertia& other) {
        mass += other.mass;
        moment += other.moment;
        inertia = inertia + other.inertia;
    }
    double about(Vec3 point, Vec3 axis) const {
        // Parallel axes: through the origin, then through the point.
        const Vec3 through = cross(axis, point);
        return dot(axis, inertia * axis) - 2 * dot(through, cross(axis, moment)) +
               mass * length_squared(through);
    }
};

BodyDef body_of(const RagdollDef& def, std::size_t bone, const Transform& origin) {
    return {.type = bone == 0 && def.kinematic_root ? BodyType::kinematic : BodyType::dynamic,
            .pose = compose(origin, def.bones[bone].rest),
            .sleep_allowed = def.sleep_allowed};
}

}  // namespace

const Ragdolls::Figure* Ragdolls::find(RagdollId id) const {
    if (id.index >= figures_.size()) return nullptr;
    const Figure& figure = figures_[id.index];
    return figure.alive && figure.generation == id.generation ? &figure : nullptr;
}

Ragdolls::Figure* Ragdolls::find(RagdollId id) {
    return const_cast<Figure*>(std::as_const(*this).find(id));
}

Error Ragdolls::unknown(RagdollId id) {
    return {ErrorCode::not_found, "ragdoll " + std::to_string(id.index) + " of generation " +
                                      std::to_string(id.generation) + " does not exist"};
}

Ragdolls::BoneJoint Ragdolls::bone_joint_of(const JointKind& kind) {
    if (const auto* hinge = std::get_if<HingeJoint>(&kind))
        return {BoneJointKind::hinge, hinge->limit.enabled, hinge->limit.lower, hinge->limit.upper};
    if (const auto* cone = std::get_if<ConeTwistJoint>(&kind))
        return {BoneJointKind::cone_twist, cone->twist.enabled, cone->twist.lower,
                cone->twist.upper,         cone->swing,         cone->friction_torque};
    if (const auto* ball = std::get_if<BallJoint>(&kind))
        return {.friction = ball->friction_torque};
    return {};
}

// Springs of joints refer to the inertia of the two bodies about their centres. Returns the factor
// of frequency and damping with which they have the muscle's frequency about the joint. The masses
// may change between steps.
std::vector<double> Ragdolls::muscle_scales(const World& world, const Figure& figure) {
    const std::size_t count = figure.bones.size();
    std::vector<Inertia> hanging(count);
    std::vector<Mat3> responses(count, diagonal({0, 0, 0}));  // inverse inertias
    std::vector<double> scales(count, 1);
    for (std::size_t k = 0; k < count; k++) {
        const Result<BodyState> body = world.body(figure.bones[k].body);
        if (!body.ok() || body->mass <= 0 || !(dot(body->inertia.x, {1, 0, 0}) > 0)) continue;
        const Transform to_rest = compose(figure.bones[k].rest, inverse(body->pose));
        const Mat3 turn = to_matrix(to_rest.rotation);
        const Mat3 inertia = turn * body->inertia * transpose(turn);
        const Vec3 center = apply(to_rest, body->center);
        const double xx = length_squared(center);
        hanging[k] = {body->mass, center * body->mass,
                      inertia + Mat3{(Vec3{xx, 0, 0} - center * center.x) * body->mass,
                                     (Vec3{0, xx, 0} - center * center.y) * body->mass,
                                     (Vec3{0, 0, xx} - center * center.z) * body->mass}};
        responses[k] = inverse(inertia);
    }
    for (std::size_t k = count; k-- > 1;) {
        const Bone& bone = figure.bones[k];
        const auto parent = static_cast<std::size_t>(bone.parent);
        const Mat3 response = responses[k] + responses[parent],
                   axes = to_matrix(bone.frame.rotation);
        double most = 0;
        for (const Vec3 axis : {axes.z, axes.x, axes.y}) {
            most = maximum(
                most, hanging[k].about(bone.frame.position, axis) * dot(axis, response * axis));
            if (bone.bone_joint.kind == BoneJointKind::hinge) break;
        }
        if (most > 0) scales[k] = square_root(most);
        hanging[parent].add(hanging[k]);
    }
    return scales;
}

// Returns the joint with a drive of the given strength towards a target.
JointKind Ragdolls::kind_of(const Bone& bone, double strength, Quat target, double scale) {
    const BoneJoint& bone_joint = bone.bone_joint;
    const double most = bone.muscle.max_torque * strength;
    const bool pulls = most > 0 && bone.muscle.hertz > 0;
    // Stiffness is proportional to the square of the frequency.
    const JointSpring spring{pulls ? bone.muscle.hertz * square_root(strength) * scale : 0,
                             bone.muscle.damping_ratio * scale};
    const RotationDrive drive{spring, pulls ? target : Quat{}, most};
    const JointLimit limit{bone_joint.limited, bone_joint.lower, bone_joint.upper};
    if (bone_joint.kind == BoneJointKind::hinge)
        return HingeJoint{.limit = limit,
                          .spring = spring,
                          .spring_angle = pulls ? angle_about_z(target) : 0,
                          .spring_max_torque = pulls ? most : 0};
    if (bone_joint.kind == BoneJointKind::cone_twist)
        return ConeTwistJoint{bone_joint.swing, limit, bone_joint.friction, drive};
    return BallJoint{drive, bone_joint.friction};
}

// Creates the joints of all bones at their current poses. On failure, none is created.
Status Ragdolls::create_joints(World& world, Figure& figure) {
    for (std::size_t k = 0; k < figure.bones.size(); k++) {
        Bone& bone = figure.bones[k];
        if (bone.parent < 0) continue;
        const Bone& parent = figure.bones[static_cast<std::size_t>(bone.parent)];
        const Result<JointId> joint =
            world.create_joint({.body_a = parent.body,
                                .body_b = bone.body,
                                .frame_a = compose(inverse(parent.rest), bone.frame),
                                .frame_b = bone.frame_b,
                                .kind = kind_of(bone, 0, {})});
        if (!joint.ok()) {
            destroy_joints(world, figure);
            return Error{joint.error().code,
                         "bones[" + std::to_string(k) + "].joint: " + joint.error().message};
        }
        bone.joint = *joint;
    }
    return {};
}

void Ragdolls::destroy_joints(World& world, Figure& figure) {
    for (Bone& bone : figure.bones) {
        if (world.contains(bone.joint)) static_cast<void>(world.destroy_joint(bone.joint).ok());
        bone.joint = {};
    }
}

std::size_t Ragdolls::size() const {
    return static_cast<std::size_t>(
        std::count_if(figures_.begin(), figures_.end(), [](const Figure& f) { return f.alive; }));
}

Result<RagdollId> Ragdolls::add(World& world, const RagdollDef& def, const Transform& origin) {
    if (Status s = check_figure(def); !s.ok()) return s.error();
    if (!is_finite(origin) || std::abs(norm_squared(origin.rotation) - 1) > 0.01)
        return invalid_argument("origin must have a finite position and a unit quaternion");
    std::size_t at = 0;
    while (at < figures_.size() && figures_[at].alive) at++;
    if (at >= figures_max)
        return Error{ErrorCode::resource_exhausted, "the world already has the maximum of " +
                                                        std::to_string(figures_max) +
                                                        " ragdolls; remove one first"};
    std::vector<BodyAndShapes> parts(def.bones.size());
    for (std::size_t k = 0; k < parts.size(); k++)
        parts[k] = {body_of(def, k, origin), def.bones[k].shapes};
    const Result<std::vector<BodyId>> made = world.create_bodies(parts);
    if (!made.ok()) return made.error();
    Figure figure{.alive = true, .kinematic_root = def.kinematic_root, .root = origin};
    for (std::size_t k = 0; k < parts.size(); k++) {
        const RagdollBone& from = def.bones[k];
        figure.bones.push_back({.body = (*made)[k],
                                .bone_joint = bone_joint_of(from.joint),
                                .parent = from.parent,
                                .rest = from.rest,
                                .frame = from.frame,
                                .frame_b = compose(inverse(from.rest), from.frame),
                                .muscle = from.muscle});
    }
    if (Status joined = create_joints(world, figure); !joined.ok()) {
        static_cast<void>(world.destroy_bodies(*made).ok());
        return joined.error();
    }
    if (at == figures_.size()) figures_.emplace_back();
    figure.generation = figures_[at].generation + 1;
    figures_[at] = std::move(figure);
    return RagdollId{static_cast<std::uint32_t>(at), figures_[at].generation};
}

Status Ragdolls::remove(World& world, RagdollId id) {
    Figure* figure = find(id);
    if (figure == nullptr) return unknown(id);
    for (const Bone& bone : figure->bones)  // bodies may have been destroyed by other callers
        if (world.contains(bone.body)) static_cast<void>(world.destroy_body(bone.body).ok());
    figure->alive = false;
    figure->bones.clear();
    return {};
}

Status Ragdolls::set_pose(RagdollId id, const RagdollPose& pose) {
    Figure* figure = find(id);
    if (figure == nullptr) return unknown(id);
    if (pose.rotations.size() != figure->bones.size())
        return invalid_argument("rotations has " + std::to_string(pose.rotations.size()) +
                                " elements; it must have " + std::to_string(figure->bones.size()) +
                                ", one per bone");
    const auto is_turn = [](Quat q) { return std::abs(norm_squared(q) - 1) <= 0.01; };
    for (std::size_t k = 0; k < pose.rotations.size(); k++)
        if (!is_turn(pose.rotations[k]))
            return invalid_argument("rotations[" + std::to_string(k) +
                                    "] is not a unit quaternion");
    if (!is_finite(pose.root) || !is_turn(pose.root.rotation))
        return invalid_argument("root must have a finite position and a unit quaternion");
    for (std::size_t k = 0; k < pose.rotations.size(); k++)
        figure->bones[k].target_rotation = normalized(pose.rotations[k]);
    figure->root = {pose.root.position, normalized(pose.root.rotation)};
    figure->pose_changed = true;
    return {};
}

Status Ragdolls::set_types(World& world, const Figure& figure, RagdollMode mode) {
    for (std::size_t k = 0; k < figure.bones.size(); k++) {
        const BodyId body = figure.bones[k].body;
        const bool held = mode == RagdollMode::kinematic || (k == 0 && figure.kinematic_root);
        const BodyType type = held ? BodyType::kinematic : BodyType::dynamic;
        const Result<BodyState> now = world.body(body);
        if (!now.ok()) return now.error();
        if (now->type == type) continue;
        if (Status s = world.set_type(body, type); !s.ok()) return s;
        if (held) continue;
        // It continues with its current velocity.
        if (Status s = world.set_velocity(body, now->linear_velocity, now->angular_velocity);
            !s.ok())
            return s;
    }
    return {};
}

Status Ragdolls::set_mode(World& world, RagdollId id, RagdollMode mode, double blend) {
    Figure* figure = find(id);
    if (figure == nullptr) return unknown(id);
    if (!(blend >= 0 && blend <= blend_seconds_max))
        return invalid_argument("blend must be from 0 to 60 s");
    if (mode > RagdollMode::kinematic)
        return invalid_argument("mode is out of range; it must be limp, powered or kinematic");
    const Result<RagdollPose> now = pose(world, id);
    if (!now.ok()) return now.error();
    // Kinematic bodies do not need joints between them.
    const bool is_kinematic = mode == RagdollMode::kinematic,
               was_kinematic = figure->mode == mode && is_kinematic;
    if (is_kinematic && !was_kinematic) destroy_joints(world, *figure);
    if (Status s = set_types(world, *figure, mode); !s.ok()) return s;
    if (!is_kinematic && figure->mode == RagdollMode::kinematic)
        if (Status s = create_joints(world, *figure); !s.ok()) return s;
    figure->mode = mode;
    figure->blend = blend;
    figure->blend_elapsed = 0;
    figure->pose_changed = true;
    figure->blend_start_root = now->root;
    for (std::size_t k = 0; k < figure->bones.size(); k++)
        figure->bones[k].blend_start_rotation = now->rotations[k];
    for (Bone& bone : figure->bones) {
        bone.previous_rotation = blend > 0 ? bone.blend_start_rotation : bone.target_rotation;
        bone.previous_speed = {};
    }
    return {};
}

Status Ragdolls::set_strength(RagdollId id, std::size_t bone, double strength) {
    Figure* figure = find(id);
    if (figure == nullptr) return unknown(id);
    if (bone >= figure->bones.size())
        return invalid_argument("bone " + std::to_string(bone) +
                                " does not exist; the figure has " +
                                std::to_string(figure->bones.size()) + " bones");
    if (!(strength >= 0 && strength <= 1)) return invalid_argument("strength must be from 0 to 1");
    figure->bones[bone].strength = strength;
    figure->pose_changed = true;
    return {};
}

Result<RagdollMode> Ragdolls::mode(RagdollId id) const {
    const Figure* figure = find(id);
    if (figure == nullptr) return unknown(id);
    return figure->mode;
}

Result<std::vector<BodyId>> Ragdolls::bodies(RagdollId id) const {
    const Figure* figure = find(id);
    if (figure == nullptr) return unknown(id);
    std::vector<BodyId> all;
    for (const Bone& bone : figure->bones) all.push_back(bone.body);
    return all;
}

Result<std::vector<JointId>> Ragdolls::joints(RagdollId id) const {
    const Figure* figure = find(id);
    if (figure == nullptr) return unknown(id);
    std::vector<JointId> all;
    for (const Bone& bone : figure->bones) all.push_back(bone.joint);
    return all;
}

Result<RagdollPose> Ragdolls::pose(const World& world, RagdollId id) const {
    const Figure* figure = find(id);
    if (figure == nullptr) return unknown(id);
    RagdollPose pose;
    std::vector<Transform> now;
    for (const Bone& bone : figure->bones) {
        const Result<BodyState> body = world.body(bone.body);
        if (!body.ok()) return body.error();
        now.push_back(body->pose);
        if (bone.parent < 0) {
            pose.root = compose(body->pose, inverse(bone.rest));
            pose.rotations.push_back({});
            continue;
        }
        const auto parent = static_cast<std::size_t>(bone.parent);
        const Transform a =
            compose(compose(now[parent], inverse(figure->bones[parent].rest)), bone.frame);
        const Transform b = compose(body->pose, bone.frame_b);
        pose.rotations.push_back(normalized(conjugate(a.rotation) * b.rotation));
    }
    return pose;
}

// Releases a figure that lost a body or a joint.
void Ragdolls::release_if_incomplete(World& world, Figure& figure) {
    const bool complete = std::all_of(figure.bones.begin(), figure.bones.end(), [&](const Bone& b) {
        const bool joined = b.parent >= 0 && figure.mode != RagdollMode::kinematic;
        return world.contains(b.body) && (!joined || world.contains(b.joint));
    });
    if (!complete) release(world, figure);
}

// Releases a figure: the remaining bodies stay in the world, limp.
void Ragdolls::release(World& world, Figure& figure) {
    for (const Bone& bone : figure.bones)
        if (world.contains(bone.joint))
            static_cast<void>(world.set_joint(bone.joint, kind_of(bone, 0, {})).ok());
    figure.alive = false;
    figure.bones.clear();
}

void Ragdolls::after_step(World& world, double) {
    const std::span<const BodyId> lost = world.events().quarantined;
    if (lost.empty()) return;
    for (Figure& figure : figures_)
        if (std::any_of(figure.bones.begin(), figure.bones.end(), [&](const Bone& bone) {
                return std::find(lost.begin(), lost.end(), bone.body) != lost.end();
            }))
            release(world, figure);
}

// Moves kinematic bones to the pose at the end of the step.
void Ragdolls::move_kinematic_bones(World& world, Figure& figure, double dt) {
    const bool blends = figure.blend_elapsed < figure.blend;
    const double fraction = blends ? figure.blend_elapsed / figure.blend : 1;
    std::vector<Transform> poses;
    const Transform root =
        blends ? interpolate(figure.blend_start_root, figure.root, fraction) : figure.root;
    for (const Bone& bone : figure.bones) {
        const Quat turn =
            blends ? interpolate(bone.blend_start_rotation, bone.target_rotation, fraction)
                   : bone.target_rotation;
        poses.push_back(bone.parent < 0
                            ? compose(root, bone.rest)
                            : bone_pose(poses[static_cast<std::size_t>(bone.parent)],
                                        figure.bones[static_cast<std::size_t>(bone.parent)].rest,
                                        bone.frame, bone.rest, turn));
        if (figure.mode == RagdollMode::kinematic || bone.parent < 0)
            static_cast<void>(world.move_to(bone.body, poses.back(), dt).ok());
        if (figure.mode != RagdollMode::kinematic) return;  // only the root is kinematic
    }
}

// Drives muscles towards the pose in powered mode and disables them in limp mode. If the pose does
// not change in the next step, the lead is removed.
void Ragdolls::drive_muscles(World& world, Figure& figure, double dt) {
    const bool blends = figure.blend_elapsed < figure.blend;
    const double fraction = blends ? figure.blend_elapsed / figure.blend : 1;
    const int substeps = world.substeps();
    const std::vector<double> scales = muscle_scales(world, figure);
    figure.pose_changed = false;
    for (std::size_t k = 0; k < figure.bones.size(); k++) {
        Bone& bone = figure.bones[k];
        if (bone.parent < 0) continue;
        const double strength = figure.mode == RagdollMode::powered ? bone.strength * fraction : 0;
        const Quat turn =
            blends ? interpolate(bone.blend_start_rotation, bone.target_rotation, fraction)
                   : bone.target_rotation;
        Quat target = turn;
        Vec3 speed;
        if (bone.muscle.hertz > 0 && bone.previous_rotation != turn) {
            speed = angular_velocity_between(bone.previous_rotation, turn, dt);
            Vec3 lead = speed * lead_time_of(bone.muscle, scales[k], dt, substeps);
            // A pose that starts to move has no acceleration to follow.
            if (bone.previous_speed != Vec3{})
                lead += acceleration_lead(bone.muscle, strength,
                                          (speed - bone.previous_speed) * (1 / dt));
            target = from_rotation_vector(lead) * turn;
            figure.pose_changed = true;
        }
        bone.previous_speed = speed;
        bone.previous_rotation = turn;
        const JointKind kind = kind_of(bone, strength, normalized(target), scales[k]);
        static_cast<void>(world.set_joint(bone.joint, kind).ok());
    }
}

void Ragdolls::before_step(World& world, double dt) {
    for (Figure& figure : figures_) {
        if (!figure.alive) continue;
        release_if_incomplete(world, figure);
        if (!figure.alive) continue;
        const bool is_kinematic = figure.mode == RagdollMode::kinematic;
        const bool changes = figure.pose_changed || figure.blend_elapsed < figure.blend;
        if (figure.blend_elapsed < figure.blend)
            figure.blend_elapsed = minimum(figure.blend, figure.blend_elapsed + dt);
        if (is_kinematic ||
            (figure.kinematic_root && (changes || figure.mode == RagdollMode::powered)))
            move_kinematic_bones(world, figure, dt);
        if (is_kinematic)
            figure.pose_changed = false;
        else if (changes)
            drive_muscles(world, figure, dt);
    }
}

void Ragdolls::publish(const World& world, ChannelWriter& channels) const {
    for (const Figure& figure : figures_) {
        if (!figure.alive || !world.contains(figure.bones.front().body)) continue;
        if (channels.begin(0, figure.bones.front().body))
            channels.value(static_cast<std::int32_t>(figure.mode));
    }
}

}  // namespace jostle::modules
