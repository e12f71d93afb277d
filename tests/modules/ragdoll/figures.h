// SPDX-License-Identifier: MIT
//
// Small figures for tests.
#pragma once

#include <memory>

#include "jostle/modules/ragdoll.h"

namespace jostle::modules {

// Two boxes of 8 kg, 0.4 m long, end to end along x: the first is kinematic, the second is held at
// its end by a muscle.
inline RagdollDef arm(physics::JointKind joint, const Muscle& muscle) {
    RagdollDef def{.kinematic_root = true, .sleep_allowed = false};
    const physics::ShapeDef shape{.geometry = physics::Box{{0.2, 0.05, 0.05}}, .density = 2000};
    def.bones.push_back({.name = "upper", .shapes = {shape}});
    def.bones.push_back({.name = "lower",
                         .parent = 0,
                         .rest = {.position = {0.4, 0, 0}},
                         .shapes = {shape},
                         .joint = std::move(joint),
                         .frame = {.position = {0.2, 0, 0}},
                         .muscle = muscle});
    return def;
}

struct Stage {
    physics::World world;
    Ragdolls* ragdolls = nullptr;

    explicit Stage(const physics::WorldDef& def = {})
        : world(std::move(*physics::World::create(def))) {
        auto module = std::make_unique<Ragdolls>();
        ragdolls = module.get();
        world.add_module(std::move(module)).expect();
    }
    RagdollId add(const RagdollDef& def, const physics::Transform& origin = {}) {
        return ragdolls->add(world, def, origin).value();
    }
    void step(double hz = 60) { world.step(1 / hz).expect(); }
    // Rotation of the joint of a bone about the z axis of its frame.
    double angle(RagdollId id, std::size_t bone) const {
        const physics::Quat q = ragdolls->pose(world, id)->rotations[bone];
        return 2 * physics::arc_tangent(q.z, q.w);
    }
    void floor() {
        world.create_body({.type = physics::BodyType::static_body}, {.geometry = physics::Plane{}})
            .value();
    }
};

}  // namespace jostle::modules
