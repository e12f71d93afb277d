// SPDX-License-Identifier: MIT
#include "stages/solver/joint_groups.h"

#include <algorithm>

#include "constraints/joints/write_joint.h"
#include "foundation/check.h"
#include "foundation/tuning.h"
#include "stages/solver/substep_hooks.h"
#include "stages/step_scratch.h"
#include "state/force_fields.h"
#include "state/joint_graph.h"

namespace jostle::physics {
namespace {

// ---- which ----

bool may_be_grouped(const WorldState& world, const BodyCold& cold) {
    return cold.constraints == 0 && cold.locks == 0 && !cold.asleep_in_place && !world.def.planar &&
           cold.mass > 0;
}

bool is_pushed(const WorldState& world, std::uint32_t body) {
    return body != none && is_dynamic(world, body);
}

bool is_known(const WorldState& world, const Joint& joint) {
    return supported(joint.kind) &&
           (is_pushed(world, joint.body_a) || is_pushed(world, joint.body_b));
}

// Islands with a body or a joint of which groups know nothing are refused.
void look_at_islands(StepContext& step) {
    const WorldState& world = step.world;
    JointGroupScratch& scratch = step.scratch.solver.groups;
    const std::size_t islands = world.islands.ids.size();
    scratch.refused.resize(islands);
    for (std::size_t i = 0; i < islands; i++)
        scratch.refused[i] = world.islands.islands[i].joints_too_dense ? 1 : 0;
    scratch.active.clear();
    if (scratch.of_island.size() < islands) scratch.of_island.resize(islands);
    for (const BodyWarm& warm : world.bodies.awake) {
        const BodyCold& cold = world.bodies.cold[warm.body];
        if (cold.type != BodyType::dynamic || scratch.refused[cold.island] != 0) continue;
        if (!may_be_grouped(world, cold)) {
            scratch.refused[cold.island] = 1;
            continue;
        }
        if (cold.first_joint == none) continue;
        bool known = true;
        for_each_joint(world.joints, cold, [&](std::uint32_t joint) {
            known = known && is_known(world, world.joints.joints[joint]);
        });
        if (!known)
            scratch.refused[cold.island] = 1;
        else
            scratch.active.push_back(cold.island);
    }
    std::sort(scratch.active.begin(), scratch.active.end());
    scratch.active.erase(std::unique(scratch.active.begin(), scratch.active.end()),
                         scratch.active.end());
    std::erase_if(scratch.active, [&](std::uint32_t i) { return scratch.refused[i] != 0; });
}

// ---- gather ----

void list_joints(const WorldState& world, const Island& island, JointGroup& group) {
    group.joints.clear();
    for (std::uint32_t body = island.first; body != none;
         body = world.bodies.cold[body].island_next)
        for_each_joint(world.joints, world.bodies.cold[body],
                       [&](std::uint32_t joint) { group.joints.push_back(joint); });
    std::sort(group.joints.begin(), group.joints.end());
    group.joints.erase(std::unique(group.joints.begin(), group.joints.end()), group.joints.end());
}

// In the order in which joints name them. The world is the last of number_of.
void list_bodies(const WorldState& world, JointGroup& group, std::vector<std::int32_t>& number_of) {
    group.bodies.clear();
    for (const std::uint32_t index : group.joints) {
        const Joint& joint = world.joints.joints[index];
        for (const std::uint32_t body : {joint.body_a, joint.body_b}) {
            std::int32_t& number = body == none ? number_of.back() : number_of[body];
            if (number >= 0) continue;
            number = static_cast<std::int32_t>(group.bodies.size());
            group.bodies.push_back(body);
        }
    }
}

void gather_body(const StepContext& step, JointGroup& group, std::size_t k) {
    const WorldState& world = step.world;
    const std::uint32_t index = group.bodies[k];
    DirectBody& body = group.solver.bodies[k];
    body = {};
    if (index == none) {
        group.axes[k] = {};
        refresh(body);
        return;
    }
    const BodyCold& cold = world.bodies.cold[index];
    const BodyWarm& warm = warm_of(world, index);
    body.x = warm.center;
    if (cold.type != BodyType::dynamic) {
        group.axes[k] = {};
        body.q = warm.rotation;
        if (cold.type == BodyType::kinematic) body.v = warm.v, body.w = warm.w;
        refresh(body);
        return;
    }
    ASSERT(cold.set == BodySet::awake && cold.locks == 0);
    if (!(group.inertias[k] == cold.inertia)) {
        group.inertias[k] = cold.inertia;
        group.axes[k] = principal_axes(cold.inertia);
    }
    const PrincipalAxes& axes = group.axes[k];
    body.pushed = true;
    body.mass = cold.mass;
    body.inverse_mass = cold.inverse_mass;
    body.moments = axes.moments;
    body.inverse_moments = {1 / axes.moments.x, 1 / axes.moments.y, 1 / axes.moments.z};
    body.force = acceleration_of(warm, cold, world.def.gravity) * cold.mass;
    body.torque = warm.torque;
    body.linear_damping = cold.linear_damping;
    body.angular_damping = cold.angular_damping;
    body.q = axes.frame == Quat{} ? warm.rotation : warm.rotation * axes.frame;
    refresh(body);
    body.p = warm.v * cold.mass;
    body.l = in_axes(body.axes, body.moments) * warm.w;
}

DirectEnd end_of(const WorldState& world, const JointGroup& group, std::size_t k,
                 const Transform& frame) {
    const Quat axes = group.axes[k].frame;
    const std::uint32_t body = group.bodies[k];
    const Vec3 center = body == none ? Vec3{} : world.bodies.cold[body].local_center;
    const Vec3 arm = frame.position - center;
    return {inverse_rotate(axes, arm), conjugate(axes) * frame.rotation};
}

void gather_joint(const StepContext& step, JointGroup& group, std::size_t k, double h) {
    const WorldState& world = step.world;
    const std::vector<std::int32_t>& number_of = step.scratch.solver.groups.number_of;
    const Joint& from = world.joints.joints[group.joints[k]];
    DirectJoint& joint = group.solver.joints[k];
    joint = {};
    joint.a = from.body_a == none ? number_of.back() : number_of[from.body_a];
    joint.b = number_of[from.body_b];
    const auto a = static_cast<std::size_t>(joint.a), b = static_cast<std::size_t>(joint.b);
    set_up(joint, from.kind, end_of(world, group, a, from.frame_a),
           end_of(world, group, b, from.frame_b));
    const DirectBody &body_a = group.solver.bodies[a], &body_b = group.solver.bodies[b];
    const std::uint32_t carrier = body_b.pushed ? from.body_b : from.body_a;
    const Quat carried = warm_of(world, carrier).rotation;
    write_vectors(joint, body_a, body_b);
    load_forces(joint,
                {rotate(carried, from.point), rotate(carried, from.angular), from.lower, from.upper,
                 from.spring, from.motor},
                h);
}

// False if it is too dense to be solved directly.
bool gather(StepContext& step, std::uint32_t island) {
    WorldState& world = step.world;
    JointGroupScratch& scratch = step.scratch.solver.groups;
    if (scratch.of_island[island] == nullptr)
        scratch.of_island[island] = std::make_unique<JointGroup>();
    JointGroup& group = *scratch.of_island[island];
    list_joints(world, world.islands.islands[island], group);
    if (is_net(static_cast<int>(group.joints.size()),
               static_cast<int>(world.islands.islands[island].bodies)))
        return false;
    list_bodies(world, group, scratch.number_of);
    group.substeps =
        step.contacts[index_of(world.islands.islands[island].colour_set.tier)].substeps;
    group.inertias.resize(group.bodies.size(), diagonal({-1, -1, -1}));
    group.axes.resize(group.bodies.size());
    group.solver.bodies.resize(group.bodies.size());
    group.solver.joints.resize(group.joints.size());
    for (std::size_t k = 0; k < group.bodies.size(); k++) gather_body(step, group, k);
    for (std::size_t k = 0; k < group.joints.size(); k++)
        gather_joint(step, group, k, step.dt / group.substeps);
    for (const std::uint32_t body : group.bodies)
        (body == none ? scratch.number_of.back() : scratch.number_of[body]) = -1;
    std::int64_t cubes = 0;
    for (const DirectJoint& joint : group.solver.joints)
        cubes += std::int64_t{joint.rows()} * joint.rows() * joint.rows();
    return group.solver.prepare(tuning::direct_work * cubes);
}

// ---- scatter ----

void scatter_joint(StepContext& step, JointGroup& group, std::size_t k, double h) {
    WorldState& world = step.world;
    Joint& to = world.joints.joints[group.joints[k]];
    DirectJoint& joint = group.solver.joints[k];
    const DirectBody& b = group.solver.bodies[static_cast<std::size_t>(joint.b)];
    const std::size_t carrier = static_cast<std::size_t>(b.pushed ? joint.b : joint.a);
    const DirectBody& carrying = group.solver.bodies[carrier];
    const Quat carried = carrying.q * conjugate(group.axes[carrier].frame);
    write_vectors(joint, group.solver.bodies[static_cast<std::size_t>(joint.a)], b);
    const KeptImpulses kept = keep_forces(joint, h);
    to.point = inverse_rotate(carried, kept.point);
    to.angular = inverse_rotate(carried, kept.angular);
    to.lower = kept.lower;
    to.upper = kept.upper;
    to.spring = kept.spring;
    to.motor = kept.motor;
    to.swing = 0;
    to.friction = {};
    to.force = joint.force_sum * (1 / step.dt);
    to.torque = joint.torque_sum * (1 / step.dt);
}

void advance(StepContext& step, JointGroup& group, std::span<FreeMotion> motions) {
    group.solver.advance(step.dt, group.substeps);
    std::size_t next = 0;
    for (std::size_t k = 0; k < group.bodies.size(); k++) {
        const DirectBody& body = group.solver.bodies[k];
        if (!body.pushed) continue;
        const BodyWarm& warm = warm_of(step.world, group.bodies[k]);
        motions[next++] = {body.x - warm.center,
                           normalized(body.q * conjugate(group.axes[k].frame)), velocity(body),
                           spin(body)};
    }
    for (std::size_t k = 0; k < group.joints.size(); k++)
        scatter_joint(step, group, k, step.dt / group.substeps);
}

}  // namespace

void find_joint_groups(StepContext& step) {
    const WorldState& world = step.world;
    JointGroupScratch& scratch = step.scratch.solver.groups;
    scratch.active.clear();
    scratch.awake.clear();
    scratch.grouped.clear();
    if (world.joints.ids.alive_count() == 0 || has_substep_listeners(world.listeners) ||
        !world.fields.empty())
        return;
    look_at_islands(step);
    if (scratch.active.empty()) return;
    scratch.number_of.assign(world.bodies.cold.size() + 1, -1);
    scratch.grouped.assign(world.bodies.awake.size(), 0);
    std::erase_if(scratch.active, [&](std::uint32_t island) {
        if (!gather(step, island)) {
            step.world.islands.islands[island].joints_too_dense = true;
            scratch.of_island[island] = nullptr;
            return true;
        }
        const JointGroup& group = *scratch.of_island[island];
        for (const std::uint32_t body : group.bodies) {
            if (!is_pushed(world, body)) continue;
            scratch.awake.push_back(world.bodies.cold[body].at);
            scratch.grouped[world.bodies.cold[body].at] = 1;
        }
        return false;
    });
    scratch.motions.resize(scratch.awake.size());
}

void solve_joint_groups(StepContext& step) {
    JointGroupScratch& scratch = step.scratch.solver.groups;
    if (scratch.active.empty()) return;
    std::vector<std::size_t>& first = scratch.first;
    first.clear();
    std::size_t next = 0;
    for (const std::uint32_t island : scratch.active) {
        first.push_back(next);
        for (const DirectBody& body : scratch.of_island[island]->solver.bodies)
            next += body.pushed ? 1 : 0;
    }
    ASSERT(next == scratch.motions.size());
    step.team.run_tasks(static_cast<int>(scratch.active.size()), [&](int k) {
        const auto at = static_cast<std::size_t>(k);
        advance(step, *scratch.of_island[scratch.active[at]],
                std::span(scratch.motions).subspan(first[at]));
    });
}

}  // namespace jostle::physics
