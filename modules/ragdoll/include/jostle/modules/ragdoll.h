// SPDX-License-Identifier: MIT
//
// Figures of bones and joints that are driven to poses by muscles, follow an animation, or fall:
// hit characters, puppets, machines with many links.
//
//     auto module = std::make_unique<Ragdolls>();
//     Ragdolls& ragdolls = *module;
//     world.add_module(std::move(module));
//     RagdollId figure = *ragdolls.add(world, human_figure(), {.position = {0, 0, 0}});
//     ragdolls.set_pose(figure, pose);                       // each step, or when it changes
//     ragdolls.set_mode(world, figure, RagdollMode::limp);   // hit: falls
//
// Thread rule: that of the World.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "jostle/physics/module.h"
#include "jostle/physics/world.h"

namespace jostle::modules {

// What turns a bone against its parent: a spring on the orientation, as strong as told.
struct Muscle {
    double hertz = 6;          // of the spring, against the two bones' own inertia; 0: none
    double damping_ratio = 1;  // 0 to 10
    double max_torque = 200;   // N m, 0 to 1e9
};

// Bones stand in a rest pose, in the figure's own frame, whose origin stands on the ground.
struct RagdollBone {
    std::string name = {};
    int parent = -1;               // index of an earlier bone; -1: the root, which is first
    physics::Transform rest = {};  // of the bone's body
    std::vector<physics::ShapeDef> shapes = {};  // in the bone's body; one at least
    // To its parent, and its frame, in the figure. A ball, hinge or cone-twist, of which limits and
    // friction count: springs and drives are the muscle's.
    physics::JointKind joint = physics::BallJoint{};
    physics::Transform frame = {};
    Muscle muscle = {};
};

struct RagdollDef {
    std::vector<RagdollBone> bones = {};  // 1 to 256
    // The root does not fall: it is moved as the pose says, in every mode.
    bool kinematic_root = false;
    bool sleep_allowed = true;
};

// A person of that height, m, 0.2 to 20: eleven capsules and ten joints; muscles of a size that
// stands.
RagdollDef human_figure(double height = 1.8);

// Where bones are wanted. Of each bone but the root how its joint's frame is turned against the
// frame at rest, as seen from the parent; a hinge takes the turn about its z axis. The identity:
// as at rest.
struct RagdollPose {
    physics::Transform root = {};  // of the figure's frame in the world, as the root would have it
    std::vector<physics::Quat> rotations = {};  // by bone; the root's counts for nothing
};

enum class RagdollMode : std::uint8_t {
    limp,       // joints alone
    powered,    // muscles pull towards the pose; the root falls
    kinematic,  // bones go where the pose says and push what is in the way
};

struct RagdollId {
    std::uint32_t index = 0xffffffff;
    std::uint32_t generation = 0;

    auto operator<=>(const RagdollId&) const = default;
};

class Ragdolls : public physics::Module {
public:
    std::string_view tag() const override { return "ragdoll"; }
    void visit(physics::StateVisitor& v) override;
    // Figures of a scene: count (0 to 200), height, spacing (m), x, y, z of the first, side of the
    // square that they stand in follows; powered and kinematic (0 or 1; neither: limp).
    physics::Status configure(physics::World& world,
                              const physics::ModuleSettings& settings) override;
    // "ragdoll", of each root's body: its mode.
    std::vector<physics::ChannelKind> channels() const override { return {{}}; }
    void publish(const physics::World& world, physics::ChannelWriter& channels) const override;
    void before_step(physics::World& world, double dt) override;
    // Lets go of figures of which a body was quarantined: those alone, and all their muscles.
    void after_step(physics::World& world, double dt) override;

    // Stands it there, limp, with its pose at rest. All or nothing. An error names the bone.
    physics::Result<RagdollId> add(physics::World& world, const RagdollDef& def,
                                   const physics::Transform& place);
    // With its bodies and joints.
    physics::Status remove(physics::World& world, RagdollId id);

    // From a pose to the next within the coming step: muscles lead by what they would lag. Called
    // once for each step, or once for a pose that is to be held.
    physics::Status set_pose(RagdollId id, const RagdollPose& pose);
    // The change takes `blend` seconds, 0 to 60: what was limp is led to the pose by and by, and
    // muscles gain their strength.
    physics::Status set_mode(physics::World& world, RagdollId id, RagdollMode mode,
                             double blend = 0);
    // Of one bone's muscle, 0 to 1: its spring and its greatest torque. 0: limp there.
    physics::Status set_strength(RagdollId id, std::size_t bone, double strength);

    bool contains(RagdollId id) const { return find(id) != nullptr; }
    std::size_t size() const;
    physics::Result<RagdollMode> mode(RagdollId id) const;
    // Bodies by bone; the joint of each bone to its parent, null of the root and while it is led.
    physics::Result<std::vector<physics::BodyId>> bodies(RagdollId id) const;
    physics::Result<std::vector<physics::JointId>> joints(RagdollId id) const;
    // As its bodies stand.
    physics::Result<RagdollPose> pose(const physics::World& world, RagdollId id) const;

private:
    // What of a joint a figure keeps: bones that are led have none.
    enum class BoneJointKind : std::uint8_t { ball, hinge, cone_twist };
    struct BoneJoint {
        BoneJointKind kind = BoneJointKind::ball;
        bool limited = false;
        double lower = 0, upper = 0, swing = 0, friction = 0;
    };
    struct Bone {
        physics::BodyId body;
        physics::JointId joint;  // null: led, or the root
        BoneJoint bone_joint;
        std::int32_t parent = -1;
        physics::Transform rest;            // in the figure
        physics::Transform frame, frame_b;  // of the joint in the figure; in the bone
        Muscle muscle;
        double strength = 1;
        physics::Quat target_rotation,
            previous_rotation;  // turns of the joint: at the end of the coming step, now
        physics::Quat blend_start_rotation;  // where a blend began
    };
    struct Figure {
        bool alive = false;
        std::uint32_t generation = 0;
        RagdollMode mode = RagdollMode::limp;
        bool kinematic_root = false;
        bool pose_changed = false;                  // a new pose for the coming step
        double blend = 0, blend_elapsed = 0;        // s: of the whole, and so far
        physics::Transform root, blend_start_root;  // of the figure's frame
        std::vector<Bone> bones;
    };

    const Figure* find(RagdollId id) const;
    Figure* find(RagdollId id);
    static physics::Error unknown(RagdollId id);
    static BoneJoint bone_joint_of(const physics::JointKind& kind);
    static physics::JointKind kind_of(const Bone& bone, double strength, physics::Quat target);
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
