// SPDX-License-Identifier: MIT
//
// Joints: what the user set, and the impulses that they carry from sub-step to sub-step.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "jostle/physics/joint_defs.h"
#include "physics/src/constraint_graph/joint_memory.h"
#include "physics/src/foundation/check.h"
#include "physics/src/foundation/id_pool.h"
#include "physics/src/state/body_store.h"

namespace jostle::physics {

struct Joint {
    std::uint32_t next[2] = {none, none}, prev[2] = {none, none};  // as Contact's

    // What the user set. Bodies by index; body_a may be none, the world.
    std::uint32_t body_a = none, body_b = none;
    Transform frame_a, frame_b;
    JointKind kind;
    bool collide_connected = false;
    std::optional<JointSolver> solver;
    double break_force = 0, break_torque = 0;
    std::uint64_t user_data = 0;

    // Impulses of one sub-step on b, N s and N m s. Vectors turn with body b (with a when b does
    // not move): kept in the world's axes they would lag behind and push what turns. Which of them
    // mean something depends on the kind.
    Vec3 point;                   // holds the frames' origins together
    Vec3 angular;                 // holds their directions together
    double lower = 0, upper = 0;  // of a limit, >= 0
    double swing = 0;             // of a cone, >= 0
    double spring = 0;
    double motor = 0;  // about the axis; of a velocity row
    Vec3 friction;
    // What else a kind keeps from step to step, memory_of(kind) numbers
    // (constraint_graph/joint_memory.h).
    std::vector<double> memory;
    // What acted during the last step, for reports and for breaking.
    Vec3 force, torque;  // N, N m
};

struct JointStore {
    IdPool ids;
    std::vector<Joint> joints;
};

// Calls visit(joint index) for every joint of a body. The visit may destroy that joint, no other.
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
