// SPDX-License-Identifier: MIT
//
// Joints: the settings, and the impulses carried over between sub-steps.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "jostle/base/check.h"
#include "jostle/physics/joint_defs.h"
#include "physics/src/constraint_graph/joint_memory.h"
#include "physics/src/foundation/id_pool.h"
#include "physics/src/state/body_store.h"

namespace jostle::physics {

struct Joint {
    std::uint32_t next[2] = {none, none}, prev[2] = {none, none};  // lists, as in Contact

    // Settings. Bodies by index; body_a may be none, the world.
    std::uint32_t body_a = none, body_b = none;
    Transform frame_a, frame_b;
    JointKind kind;
    bool collide_connected = false;
    std::optional<JointSolver> solver;
    double break_force = 0, break_torque = 0;
    std::uint64_t user_data = 0;

    // Impulses of one sub-step on b, N s and N m s. Vectors are stored in the frame of body b (of a
    // if b does not move): in world axes they would lag behind the rotation and push the body. The
    // kind determines which of them are used.
    Vec3 point;                   // of the point constraint
    Vec3 angular;                 // of the angular constraint
    double lower = 0, upper = 0;  // of a limit, >= 0
    double swing = 0;             // of a cone limit, >= 0
    double spring = 0;
    double motor = 0;  // about the axis; or of a velocity row
    Vec3 friction;
    // Further numbers that a kind stores between steps: memory_of(kind) of them
    // (constraint_graph/joint_memory.h).
    std::vector<double> memory;
    // Load during the last step, for reports and breaking.
    Vec3 force, torque;  // N, N m
};

struct JointStore {
    IdPool ids;
    std::vector<Joint> joints;
    std::uint64_t revision = 0;  // World::joint_revision(); not saved
};

inline JointId joint_id(const JointStore& joints, std::uint32_t joint) {
    return {joint, joints.ids.generation(joint)};
}

// Calls visit(joint index) for every joint of a body. visit() may destroy that joint, but no other.
template <class Visit>
void for_each_joint(const JointStore& store, const BodyCold& body, Visit&& visit) {
    for (std::uint32_t edge = body.first_joint; edge != none;) {
        const std::uint32_t joint = edge / 2;
        ASSERT(joint < store.joints.size());
        edge = store.joints[joint].next[edge % 2];
        visit(joint);
    }
}

}  // namespace jostle::physics
