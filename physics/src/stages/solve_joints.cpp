// SPDX-License-Identifier: MIT
#include "stages/solve_joints.h"

#include <algorithm>

#include "constraints/joints/joint_table.h"
#include "state/links.h"

namespace jostle::physics {
namespace {

JointSide side_of(const WorldState& world, std::uint32_t body, const Transform& frame) {
    const BodyCold& cold = world.bodies.cold[body];
    const BodyWarm& warm = warm_of(world, body);
    JointSide side{.hot = cold.set == BodySet::awake ? cold.at + 1 : 0,
                   .arm = warm.axes * (frame.position - cold.local_center),
                   .body = warm.rotation,
                   .frame = warm.rotation * frame.rotation,
                   .inverse_mass = {}};
    if (cold.inverse_mass == 0) return side;
    side.pushed = true;
    side.inverse_mass = free_directions(cold) * cold.inverse_mass;
    side.inverse_inertia = world_inverse_inertia(warm, cold);
    return side;
}

// What joints did counts among what acts without contacts: accelerate() then warm-starts contacts
// by what contacts did, and joints warm-start themselves, in the directions of the moment.
void count_as_free(JointSide& side, std::span<HotBody> bodies) {
    if (!side.pushed) return;
    float* free = bodies[side.hot].free;
    for (int k = 0; k < 3; k++) {
        free[k] += static_cast<float>(side.given_v[k]);
        free[k + 3] += static_cast<float>(side.given_w[k]);
    }
    side.given_v = side.given_w = {};
}

}  // namespace

void prepare_joints(StepContext& step, Effort effort) {
    WorldState& world = step.world;
    auto& joints = world.scratch.joints;
    joints.clear();
    if (world.joints.ids.alive_count() > 0) {
        for (const std::uint32_t hot : world.scratch.in_solver[index_of(effort)])
            for_each_joint(world.joints, world.bodies.cold[world.bodies.awake[hot - 1].body],
                           [&](std::uint32_t joint) { joints.push_back(joint); });
        std::sort(joints.begin(), joints.end());
        joints.erase(std::unique(joints.begin(), joints.end()), joints.end());
    }
    world.scratch.joint_work.resize(joints.size());
    for (std::size_t k = 0; k < joints.size(); k++) {
        const Joint& j = world.joints.joints[joints[k]];
        JointWork& work = world.scratch.joint_work[k];
        work = {.joint = joints[k],
                .a = side_of(world, j.body_a, j.frame_a),
                .b = side_of(world, j.body_b, j.frame_b)};
        work.apart = (warm_of(world, j.body_b).center - warm_of(world, j.body_a).center) +
                     (work.b.arm - work.a.arm);
    }
    world.profile.joints += static_cast<int>(joints.size());
}

void warm_start_joints(StepContext& step) {
    WorldState& world = step.world;
    for (JointWork& work : world.scratch.joint_work) {
        JointPair pair(work, world.scratch.hot);
        warm_start(pair, world.joints.joints[work.joint]);
        pair.store(world.scratch.hot);
    }
}

void solve_joints(StepContext& step, double h, bool relax) {
    WorldState& world = step.world;
    if (world.scratch.joint_work.empty()) return;
    const JointStep pass = joint_step(h, relax);
    for (JointWork& work : world.scratch.joint_work) {
        Joint& joint = world.joints.joints[work.joint];
        JointPair pair(work, world.scratch.hot);
        solve(pair, pass, joint);
        pair.store(world.scratch.hot);
        if (!relax) continue;
        const JointLoad load = load_of(pair, joint);
        work.force_sum += load.impulse;
        work.torque_sum += load.turn;
        count_as_free(work.a, world.scratch.hot);
        count_as_free(work.b, world.scratch.hot);
    }
}

void finish_joints(StepContext& step) {
    WorldState& world = step.world;
    for (const JointWork& work : world.scratch.joint_work) {
        Joint& joint = world.joints.joints[work.joint];
        joint.force = work.force_sum * (1 / step.dt);
        joint.torque = work.torque_sum * (1 / step.dt);
        const double force = length(joint.force), torque = length(joint.torque);
        const bool torn = joint.break_force > 0 && force > joint.break_force;
        const bool wrung = joint.break_torque > 0 && torque > joint.break_torque;
        if (!torn && !wrung) continue;
        world.events.joints_broke.push_back({joint_id(world, work.joint),
                                             body_id(world, joint.body_a),
                                             body_id(world, joint.body_b), force, torque});
        destroy_joint(world, work.joint);
    }
}

}  // namespace jostle::physics
