// SPDX-License-Identifier: MIT
#include "physics/src/stages/solver/joint_groups.h"

#include <algorithm>
#include <variant>

#include "jostle/base/check.h"
#include "physics/src/constraint_graph/joint_memory.h"
#include "physics/src/constraint_graph/joint_solver_preferences.h"
#include "physics/src/constraints/joints/path_curve.h"
#include "physics/src/constraints/joints/write_joint.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/solver/error_trial.h"
#include "physics/src/stages/solver/group_fields.h"
#include "physics/src/stages/solver/substep_hooks.h"
#include "physics/src/stages/solver/warm_start_cache.h"
#include "physics/src/stages/step_scratch.h"
#include "physics/src/state/joint_graph.h"

namespace jostle::physics {
namespace {

// ---- selection ----

int locked_turns(const BodyCold& cold) {
    const Vec3 free = free_rotations(cold);
    return 3 - static_cast<int>(free.x + free.y + free.z);
}

// A body that can rotate only about two world axes has no principal axes that rotate with it.
bool may_be_grouped(const BodyCold& cold) {
    return cold.constraints == 0 && !cold.asleep_in_place && cold.mass > 0 &&
           locked_turns(cold) != 1;
}

bool is_pushed(const BodyStore& bodies, std::uint32_t body) {
    return body != none && is_dynamic(bodies, body);
}

bool is_known(const BodyStore& bodies, const Joint& joint) {
    return supported(joint.kind) &&
           (is_pushed(bodies, joint.body_a) || is_pushed(bodies, joint.body_b));
}

// Ragdolls with cone joints fall and tumble until they touch something, and there are many of them.
// The iterative solver with exact point rows takes a quarter of the time, and the difference is not
// visible. Users who need it can request the direct solver.
bool is_left_to_iterative(const Joint& joint) {
    return std::holds_alternative<ConeTwistJoint>(joint.kind);
}

// Multiplications granted per joint of an island that requests the direct solver; -1: none of its
// joints is solved directly.
std::int64_t budget_of(const WorldDef& def, const JointStore& joints,
                       const JointGroupScratch& scratch, std::uint32_t island) {
    switch (solver_of(scratch.preferences[island], def.joint_solver)) {
        case JointSolver::direct:
            return direct_budget(joints.ids.alive_count());
        case JointSolver::automatic:
            if (scratch.left_to_iterative[island] == 0) return 0;
            break;
        case JointSolver::iterative:
            break;
    }
    return -1;
}

// Refuses islands with a body or joint that groups do not support.
void classify_islands(StepContext& step) {
    const WorldState& world = step.world;
    JointGroupScratch& scratch = step.scratch.solver.groups;
    const std::size_t islands = world.islands.ids.size();
    scratch.refused.assign(islands, 0);
    scratch.preferences.assign(islands, 0);
    scratch.left_to_iterative.assign(islands, 0);
    scratch.active.clear();
    if (scratch.of_island.size() < islands) scratch.of_island.resize(islands);
    for (const BodyWarm& warm : world.bodies.awake) {
        const BodyCold& cold = world.bodies.cold[warm.body];
        if (cold.type != BodyType::dynamic || scratch.refused[cold.island] != 0) continue;
        if (!may_be_grouped(cold)) {
            scratch.refused[cold.island] = 1;
            continue;
        }
        if (cold.first_joint == none) continue;
        bool known = true;
        for_each_joint(world.joints, cold, [&](std::uint32_t index) {
            const Joint& joint = world.joints.joints[index];
            known = known && is_known(world.bodies, joint);
            scratch.preferences[cold.island] |= preference_bit(joint.solver);
            if (is_left_to_iterative(joint)) scratch.left_to_iterative[cold.island] = 1;
        });
        if (!known)
            scratch.refused[cold.island] = 1;
        else
            scratch.active.push_back(cold.island);
    }
    std::sort(scratch.active.begin(), scratch.active.end());
    scratch.active.erase(std::unique(scratch.active.begin(), scratch.active.end()),
                         scratch.active.end());
    std::erase_if(scratch.active, [&](std::uint32_t i) {
        return scratch.refused[i] != 0 || budget_of(world.def, world.joints, scratch, i) <=
                                              world.islands.islands[i].too_dense_for;
    });
}

// ---- gather ----

void list_joints(const BodyStore& bodies, const JointStore& joints, const Island& island,
                 JointGroup& group) {
    group.joints.clear();
    for (std::uint32_t body = island.first; body != none; body = bodies.cold[body].island_next)
        for_each_joint(joints, bodies.cold[body],
                       [&](std::uint32_t joint) { group.joints.push_back(joint); });
    std::sort(group.joints.begin(), group.joints.end());
    group.joints.erase(std::unique(group.joints.begin(), group.joints.end()), group.joints.end());
}

// In the order in which joints reference them. The world is the last entry of number_of.
void list_bodies(const JointStore& joints, JointGroup& group,
                 std::vector<std::int32_t>& number_of) {
    group.bodies.clear();
    for (const std::uint32_t index : group.joints) {
        const Joint& joint = joints.joints[index];
        for (const std::uint32_t body : {joint.body_a, joint.body_b}) {
            std::int32_t& number = body == none ? number_of.back() : number_of[body];
            if (number >= 0) continue;
            number = static_cast<std::int32_t>(group.bodies.size());
            group.bodies.push_back(body);
        }
    }
}

// World axes, for a body that can rotate about one of them or none. About that axis its inertia is
// independent of its orientation.
PrincipalAxes axes_of_locked(const BodyWarm& warm, const BodyCold& cold) {
    const Mat3 inertia = warm.axes * cold.inertia * transpose(warm.axes);
    const Vec3 along{inertia.x.x, inertia.y.y, inertia.z.z};
    return {conjugate(warm.rotation), scaled(along, free_rotations(cold))};
}
Vec3 inverse_of_locked(Vec3 moments) {
    const auto inverse = [](double x) { return x > 0 ? 1 / x : 0; };
    return {inverse(moments.x), inverse(moments.y), inverse(moments.z)};
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
    ASSERT(cold.set == BodySet::awake);
    const bool turns_freely = locked_turns(cold) == 0;
    group.axes[k] = turns_freely ? cold.principal : axes_of_locked(warm, cold);
    const PrincipalAxes& axes = group.axes[k];
    body.pushed = true;
    body.mass = cold.mass;
    body.inverse_mass = cold.inverse_mass;
    body.inverse_masses = free_directions(cold) * cold.inverse_mass;
    body.turns_freely = turns_freely;
    body.moments = axes.moments;
    body.inverse_moments = turns_freely
                               ? Vec3{1 / axes.moments.x, 1 / axes.moments.y, 1 / axes.moments.z}
                               : inverse_of_locked(axes.moments);
    body.force = acceleration_of(warm, cold, world.def.gravity) * cold.mass;
    body.torque = warm.torque;
    body.linear_damping = cold.linear_damping;
    body.angular_damping = cold.angular_damping;
    body.q = axes.frame == Quat{} ? warm.rotation : warm.rotation * axes.frame;
    refresh(body);
    body.p = warm.v * cold.mass;
    body.l = in_axes(body.axes, body.moments) * warm.w;
}

DirectEnd end_of(const BodyStore& bodies, const JointGroup& group, std::size_t k,
                 const Transform& frame) {
    const Quat axes = group.axes[k].frame;
    const std::uint32_t body = group.bodies[k];
    const Vec3 center = body == none ? Vec3{} : bodies.cold[body].local_center;
    const Vec3 arm = frame.position - center;
    return {inverse_rotate(axes, arm), conjugate(axes) * frame.rotation};
}

// The rotation that stored impulses follow.
Quat carried_by(const JointGroup& group, const DirectJoint& joint, const JointKind& kind) {
    const auto a = static_cast<std::size_t>(joint.a), b = static_cast<std::size_t>(joint.b);
    const auto number = [&](std::size_t body) {
        return group.solver.bodies[body].pushed ? static_cast<std::int32_t>(body) + 1 : 0;
    };
    const std::int32_t carrier = carrier_of(kind, number(a), number(b));
    if (carrier == 0) return {};
    const auto k = static_cast<std::size_t>(carrier - 1);
    return group.solver.bodies[k].q * conjugate(group.axes[k].frame);
}

// ---- gears, racks and pulleys ----

DirectCarrier carrier_at(const StepContext& step, const JointGroup& group, std::uint32_t body) {
    if (body == none) return {};
    const std::int32_t number = step.scratch.solver.groups.number_of[body];
    ASSERT(number >= 0);  // a hinge or slider of the group connects it
    return {number, group.axes[static_cast<std::size_t>(number)].frame,
            step.world.bodies.cold[body].local_center};
}

void load_gear(const Joint& from, const std::uint32_t* carriers, std::span<const DirectBody> bodies,
               double h, DirectJoint& joint) {
    DirectGear& gear = joint.gear[0];
    if (!joint.free_axes.empty()) {  // a rope
        joint.free_axes[0].at_limit = from.motor < 0 ? -1 : 0;
    } else {
        const std::vector<double>& memory = from.memory;
        ASSERT(memory.size() == GearMemory::count);
        const bool measured = memory[GearMemory::measured] != 0;
        for (std::size_t end = 0; measured && end < 2; end++)
            gear.ends[end].travel = memory[GearMemory::travel_a + end];
        write_gear(gear, bodies);
        const bool same = memory[GearMemory::carrier_a] == static_cast<double>(carriers[0]) &&
                          memory[GearMemory::carrier_b] == static_cast<double>(carriers[1]);
        gear.target = measured && same ? memory[GearMemory::sum] : gear.value;
    }
    joint.force[0] = from.motor * 0.5 / h;
    write_vectors(joint, bodies);
}

void save_gear(const DirectJoint& joint, const std::uint32_t* carriers, double h, Joint& to) {
    const DirectGear& gear = joint.gear[0];
    const bool slack = !joint.free_axes.empty() && joint.free_axes[0].at_limit == 0;
    to.motor = slack ? 0 : joint.force[0] * 2 * h;
    if (to.memory.empty()) return;
    to.memory[GearMemory::measured] = 1;
    to.memory[GearMemory::carrier_a] = static_cast<double>(carriers[0]);
    to.memory[GearMemory::carrier_b] = static_cast<double>(carriers[1]);
    for (std::size_t end = 0; end < 2; end++)
        to.memory[GearMemory::travel_a + end] = gear.ends[end].travel;
    to.memory[GearMemory::sum] = gear.target;
}

// ---- paths ----

double start_on_path(const Joint& from, const PathJoint& path, const DirectJoint& joint,
                     const DirectBody& a, const DirectBody& b) {
    if (from.memory[PathMemory::found] != 0) return from.memory[PathMemory::at];
    const Vec3 apart = (b.x + b.axes * joint.arm_b) - (a.x + a.axes * joint.arm_a);
    return nearest_path_point(path, inverse_rotate(a.q * joint.frame_a, apart)).at;
}

void save_path(const DirectJoint& joint, Joint& to) {
    const double before = to.memory[PathMemory::at];
    const double at = parameter_within(*joint.path, joint.path_at);
    to.memory[PathMemory::step] =
        to.memory[PathMemory::found] == 0 ? 0 : parameter_step(*joint.path, before, at);
    to.memory[PathMemory::found] = 1;
    to.memory[PathMemory::at] = at;
}

void gather_joint(const StepContext& step, JointGroup& group, std::size_t k, double h) {
    const WorldState& world = step.world;
    const std::vector<std::int32_t>& number_of = step.scratch.solver.groups.number_of;
    const Joint& from = world.joints.joints[group.joints[k]];
    DirectJoint& joint = group.solver.joints[k];
    std::vector<FreeAxis> free_axes = std::move(joint.free_axes);  // to reuse its memory
    std::vector<DirectGear> gear = std::move(joint.gear);
    free_axes.clear();
    gear.clear();
    joint = {};
    joint.free_axes = std::move(free_axes);
    joint.gear = std::move(gear);
    joint.a = from.body_a == none ? number_of.back() : number_of[from.body_a];
    joint.b = number_of[from.body_b];
    const auto a = static_cast<std::size_t>(joint.a), b = static_cast<std::size_t>(joint.b);
    set_up(joint, from.kind, end_of(world.bodies, group, a, from.frame_a),
           end_of(world.bodies, group, b, from.frame_b));
    if (joint.is_gear()) {
        const std::uint32_t carriers[] = {find_carrier(world.bodies, world.joints, from, 0),
                                          find_carrier(world.bodies, world.joints, from, 1)};
        set_carriers(joint, carrier_at(step, group, carriers[0]),
                     carrier_at(step, group, carriers[1]));
        return load_gear(from, carriers, group.solver.bodies, h, joint);
    }
    const DirectBody &body_a = group.solver.bodies[a], &body_b = group.solver.bodies[b];
    if (joint.path != nullptr)
        joint.path_at = start_on_path(from, *joint.path, joint, body_a, body_b);
    write_vectors(joint, body_a, body_b);
    load_forces(joint, body_a, body_b, read_warm_start(from, carried_by(group, joint, from.kind)),
                h);
}

// Returns false if the group is too dense for the direct solver.
bool gather(StepContext& step, std::uint32_t island, std::int64_t budget) {
    WorldState& world = step.world;
    JointGroupScratch& scratch = step.scratch.solver.groups;
    if (scratch.of_island[island] == nullptr)
        scratch.of_island[island] = std::make_unique<JointGroup>();
    JointGroup& group = *scratch.of_island[island];
    list_joints(world.bodies, world.joints, world.islands.islands[island], group);
    const auto gears = std::count_if(
        group.joints.begin(), group.joints.end(),
        [&](std::uint32_t joint) { return joint_is_geared(world.joints.joints[joint].kind); });
    if (is_net(static_cast<int>(group.joints.size()) - static_cast<int>(gears),
               static_cast<int>(world.islands.islands[island].bodies)) &&
        (budget == 0 || group.joints.size() > tuning::max_net_joints))
        return false;
    list_bodies(world.joints, group, scratch.number_of);
    group.substeps = step.contacts[index_of(world.islands.islands[island].colour_set)].substeps;
    group.axes.resize(group.bodies.size());
    group.solver.may_take_fewer_steps = !controls_error(world.def);
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
    return group.solver.prepare(max_work(cubes, group.joints.size(), budget));
}

// ---- scatter ----

void scatter_joint(StepContext& step, JointGroup& group, std::size_t k, double h) {
    WorldState& world = step.world;
    Joint& to = world.joints.joints[group.joints[k]];
    DirectJoint& joint = group.solver.joints[k];
    const DirectBody& b = group.solver.bodies[static_cast<std::size_t>(joint.b)];
    const DirectBody& a = group.solver.bodies[static_cast<std::size_t>(joint.a)];
    if (joint.is_gear()) {
        const std::uint32_t carriers[] = {find_carrier(world.bodies, world.joints, to, 0),
                                          find_carrier(world.bodies, world.joints, to, 1)};
        write_vectors(joint, group.solver.bodies);
        save_gear(joint, carriers, h, to);
        to.force = joint.force_sum * (1 / step.dt);
        to.torque = joint.torque_sum * (1 / step.dt);
        return;
    }
    write_vectors(joint, a, b);
    if (joint.path != nullptr) save_path(joint, to);
    write_warm_start(to, carried_by(group, joint, to.kind), save_forces(joint, a, b, h));
    to.force = joint.force_sum * (1 / step.dt);
    to.torque = joint.torque_sum * (1 / step.dt);
}

// Measures the difference from `trial`, which took half of the sub-steps.
void compare(const StepContext& step, const JointGroup& group, const DirectGroup& trial,
             Island& island) {
    island.error.fresh = false;
    for (std::size_t k = 0; k < group.bodies.size(); k++) {
        const DirectBody &now = group.solver.bodies[k], &then = trial.bodies[k];
        if (!now.pushed) continue;
        const double radius = step.world.bodies.cold[group.bodies[k]].radius;
        const Quat turn = now.q * conjugate(then.q);
        const double shift =
            length(now.x - then.x) + radius * 2 * length(Vec3{turn.x, turn.y, turn.z});
        const double change =
            length(velocity(now) - velocity(then)) + radius * length(spin(now) - spin(then));
        // All kinds of its steps are at least second-order.
        note_error(island, second_error(shift, change, step.dt, ErrorLife::lasting) / 3);
    }
}

void advance(StepContext& step, std::uint32_t island, std::span<FreeMotion> motions) {
    JointGroup& group = *step.scratch.solver.groups.of_island[island];
    GroupFields fields(step.world, group);
    if (fields.reach(step.dt)) group.solver.outside = &fields;
    Island& of = step.world.islands.islands[island];
    if (wants_trial(step, index_of(of.colour_set))) {
        DirectGroup trial = group.solver;
        trial.is_trial = true;
        trial.advance(step.dt, group.substeps / 2);
        group.solver.advance(step.dt, group.substeps);
        compare(step, group, trial, of);
    } else {
        group.solver.advance(step.dt, group.substeps);
    }
    group.solver.outside = nullptr;
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
    if (world.joints.ids.alive_count() == 0 || has_substep_listeners(world.listeners)) return;
    classify_islands(step);
    if (scratch.active.empty()) return;
    scratch.number_of.assign(world.bodies.cold.size() + 1, -1);
    scratch.grouped.assign(world.bodies.awake.size(), 0);
    std::erase_if(scratch.active, [&](std::uint32_t island) {
        const std::int64_t budget = budget_of(world.def, world.joints, scratch, island);
        if (!gather(step, island, budget)) {
            step.world.islands.islands[island].too_dense_for = budget;
            scratch.of_island[island] = nullptr;
            return true;
        }
        const JointGroup& group = *scratch.of_island[island];
        for (const std::uint32_t body : group.bodies) {
            if (!is_pushed(world.bodies, body)) continue;
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
    step.thread_pool.run_tasks(static_cast<int>(scratch.active.size()), [&](int k) {
        const auto at = static_cast<std::size_t>(k);
        advance(step, scratch.active[at], std::span(scratch.motions).subspan(first[at]));
    });
}

}  // namespace jostle::physics
