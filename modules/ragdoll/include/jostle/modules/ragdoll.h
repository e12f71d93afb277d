// SPDX-License-Identifier: MIT
//
// Ragdolls: figures of bones and joints that muscles drive to poses, that follow an animation, or
// that fall. Examples are characters that are hit, puppets, and machines with many links.
//
//     auto module = std::make_unique<Ragdolls>();
//     Ragdolls& ragdolls = *module;
//     world.add_module(std::move(module));
//     RagdollId figure = *ragdolls.add(world, human_figure(), {.position = {0, 0, 0}});
//     ragdolls.set_pose(figure, pose);                       // each step, or when it changes
//     ragdolls.set_mode(world, figure, RagdollMode::limp);   // hit: falls
//
// Thread rule: that of World.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "jostle/physics/module.h"
#include "jostle/physics/world.h"

namespace jostle::modules {

/// Drives a bone relative to its parent: a spring on the orientation with a limited torque.
struct Muscle {
    /// of the spring, for the inertia about the joint of the bone and of all bones that hang on it
    /// in the rest pose, 0 to 1000; 0 disables the muscle
    double hertz = 6;
    double damping_ratio = 1;  ///< 0 to 10
    double max_torque = 200;   ///< N m, 0 to 1e9
};

/// A bone. The rest pose is given in the figure's own frame, whose origin is on the ground.
struct RagdollBone {
    /// For error messages and for finding bones.
    std::string name = {};
    int parent = -1;  ///< index of an earlier bone; -1 for the root, which is the first bone
    physics::Transform rest = {};                ///< of the bone's body, in the figure's frame
    std::vector<physics::ShapeDef> shapes = {};  ///< in the frame of the bone's body; at least one
    /// Joint to the parent, and its frame in the figure's frame. A ball, hinge or cone-twist joint.
    /// Its limits and friction are used; springs and drives are replaced by the muscle.
    physics::JointKind joint = physics::BallJoint{};
    physics::Transform frame = {};
    Muscle muscle = {};
};

/// Description of a figure.
struct RagdollDef {
    std::vector<RagdollBone> bones = {};  ///< 1 to 256 bones
    /// If true, the root is kinematic and follows the pose in every mode.
    bool kinematic_root = false;
    bool sleep_allowed = true;
};

/// Returns a human figure with the given height, m, 0.2 to 20: eleven capsules and ten joints, with
/// muscles strong enough to stand.
RagdollDef human_figure(double height = 1.8);

/// A pose of a figure. The rotation of each bone except the root is that of its joint frame
/// relative to rest, seen from the parent. The identity is the rest pose. A hinge uses only the
/// rotation about its z axis.
struct RagdollPose {
    /// of the figure's frame in the world, derived from the root bone
    physics::Transform root = {};
    std::vector<physics::Quat> rotations = {};  ///< one per bone; that of the root is ignored
};

/// How a figure moves.
enum class RagdollMode : std::uint8_t {
    limp,       ///< joints without muscles
    powered,    ///< muscles drive towards the pose; the root falls
    kinematic,  ///< bones follow the pose and push other bodies
};

/// Identifies a figure. Valid until it is removed. A default id is null.
struct RagdollId {
    std::uint32_t index = 0xffffffff;
    std::uint32_t generation = 0;

    auto operator<=>(const RagdollId&) const = default;
};

/// Module that owns the ragdolls of a world. Tag: "ragdoll".
class Ragdolls : public physics::Module {
public:
    std::string_view tag() const override { return "ragdoll"; }
    void visit(physics::StateVisitor& v) override;
    /// Configures the module from a scene: a square grid of human figures. Numbers: count (0 to
    /// 200), height, spacing (m), x, y, z of the first figure (m), and powered and kinematic (0 or
    /// 1; neither means limp).
    physics::Status configure(physics::World& world,
                              const physics::ModuleSettings& settings) override;
    /// Publishes the channel "ragdoll" for the body of each root: its RagdollMode.
    std::vector<physics::ChannelKind> channels() const override { return {{}}; }
    void publish(const physics::World& world, physics::ChannelWriter& channels) const override;
    void before_step(physics::World& world, double dt) override;
    /// Releases figures with a quarantined body: all their muscles become limp.
    void after_step(physics::World& world, double dt) override;

    /// Creates a figure whose frame is at `origin` in the world, limp and in the rest pose. On
    /// failure, nothing is created. invalid_argument names the bone.
    physics::Result<RagdollId> add(physics::World& world, const RagdollDef& def,
                                   const physics::Transform& origin);
    /// Removes a figure with its bodies and joints. Returns not_found for an unknown id, as all
    /// calls with an id do.
    physics::Status remove(physics::World& world, RagdollId id);

    /// Sets the pose for the end of the coming step. Muscles lead the motion to compensate their
    /// lag. Call it once per step, or once for a pose to hold. invalid_argument if the number of
    /// rotations is wrong or one is not a unit quaternion.
    physics::Status set_pose(RagdollId id, const RagdollPose& pose);
    /// Changes the mode within `blend` seconds, 0 to 60: a limp figure moves gradually to the pose,
    /// and muscles gain strength.
    physics::Status set_mode(physics::World& world, RagdollId id, RagdollMode mode,
                             double blend = 0);
    /// Sets the strength of one bone's muscle, 0 to 1: scales its stiffness and maximum torque. 0
    /// makes it limp.
    physics::Status set_strength(RagdollId id, std::size_t bone, double strength);

    /// Returns false after removal or release.
    bool contains(RagdollId id) const { return find(id) != nullptr; }
    /// Number of figures.
    std::size_t size() const;
    /// Returns the current mode.
    physics::Result<RagdollMode> mode(RagdollId id) const;
    /// Returns the body of each bone.
    physics::Result<std::vector<physics::BodyId>> bodies(RagdollId id) const;
    /// Returns the joint of each bone to its parent: null for the root, and for all bones in
    /// kinematic mode.
    physics::Result<std::vector<physics::JointId>> joints(RagdollId id) const;
    /// Returns the current pose of the bodies.
    physics::Result<RagdollPose> pose(const physics::World& world, RagdollId id) const;

private:
    /// Joint parameters of a bone; they persist while the bone has no joint.
    enum class BoneJointKind : std::uint8_t { ball, hinge, cone_twist };
    struct BoneJoint {
        BoneJointKind kind = BoneJointKind::ball;
        bool limited = false;
        double lower = 0, upper = 0, swing = 0, friction = 0;
    };
    struct Bone {
        physics::BodyId body;
        physics::JointId joint;  ///< null for the root and in kinematic mode
        BoneJoint bone_joint;
        std::int32_t parent = -1;
        physics::Transform rest;  ///< in the figure's frame
        /// of the joint, in the figure's frame and in the bone's frame
        physics::Transform frame, frame_b;
        Muscle muscle;
        double strength = 1;
        // Rotations of the joint: at the end of the coming step, and now.
        physics::Quat target_rotation, previous_rotation;
        physics::Vec3 previous_speed;        ///< of the target, rad/s, in the parent's frame
        physics::Quat blend_start_rotation;  ///< at the start of a blend
    };
    struct Figure {
        bool alive = false;
        std::uint32_t generation = 0;
        RagdollMode mode = RagdollMode::limp;
        bool kinematic_root = false;
        bool pose_changed = false;                  ///< a new pose for the coming step
        double blend = 0, blend_elapsed = 0;        ///< s, duration and elapsed time
        physics::Transform root, blend_start_root;  ///< of the figure's frame
        std::vector<Bone> bones;
    };

    const Figure* find(RagdollId id) const;
    Figure* find(RagdollId id);
    static physics::Error unknown(RagdollId id);
    static BoneJoint bone_joint_of(const physics::JointKind& kind);
    static physics::JointKind kind_of(const Bone& bone, double strength, physics::Quat target,
                                      double scale = 1);
    static std::vector<double> muscle_scales(const physics::World& world, const Figure& figure);
    static physics::Status create_joints(physics::World& world, Figure& figure);
    static void destroy_joints(physics::World& world, Figure& figure);
    static void release_if_incomplete(physics::World& world, Figure& figure);
    static void release(physics::World& world, Figure& figure);
    static void move_kinematic_bones(physics::World& world, Figure& figure, double dt);
    static void drive_muscles(physics::World& world, Figure& figure, double dt);
    static void visit(physics::StateVisitor& v, Figure& figure);
    static physics::Status set_types(physics::World& world, const Figure& figure, RagdollMode mode);

    std::vector<Figure> figures_;
};

}  // namespace jostle::modules
