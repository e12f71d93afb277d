// SPDX-License-Identifier: MIT
#include "stages/solve_constraints.h"

#include <span>

#include "constraints/contact_passes.h"
#include "constraints/free_motion.h"
#include "stages/solve_joints.h"
#include "state/lane_rows.h"

namespace jostle::physics {
namespace {

void put(float* row, Vec3 linear, Vec3 angular) {
    row[0] = as_float(linear.x), row[1] = as_float(linear.y), row[2] = as_float(linear.z);
    row[3] = as_float(angular.x), row[4] = as_float(angular.y), row[5] = as_float(angular.z);
}

void sort_out_bodies(WorldState& world) {
    StepScratch& scratch = world.scratch;
    for (auto& solved : scratch.in_solver) solved.clear();
    for (auto& jointed : scratch.joints.bodies) jointed.clear();
    scratch.drivers.clear();
    scratch.free.clear();
    for (std::uint32_t i = 0; i < world.bodies.awake.size(); i++) {
        const BodyCold& cold = world.bodies.cold[world.bodies.awake[i].body];
        const bool held = cold.lanes > 0 || cold.first_joint != none;
        if (cold.frozen) continue;
        if (cold.type == BodyType::kinematic) {
            // Moved by its velocity, whatever touches it; the solver reads it when something may.
            scratch.free.push_back(i);
            if (held || cold.first_edge != none) scratch.drivers.push_back(i + 1);
        } else if (held) {
            const Effort effort = world.islands.islands[cold.island].effort;
            scratch.in_solver[index_of(effort)].push_back(i + 1);
            if (cold.first_joint != none) scratch.joints.bodies[index_of(effort)].push_back(i + 1);
        } else {
            scratch.free.push_back(i);
        }
    }
    world.profile.bodies_frozen = static_cast<int>(world.bodies.frozen);
    world.profile.bodies_awake = static_cast<int>(world.bodies.awake.size() - world.bodies.frozen);
    world.profile.bodies_in_solver =
        world.profile.bodies_awake - static_cast<int>(scratch.free.size());
    const auto bodies_of = [&](Effort effort) {
        return static_cast<int>(scratch.in_solver[index_of(effort)].size());
    };
    world.profile.bodies_flat = bodies_of(Effort::flat);
    world.profile.bodies_tall = bodies_of(Effort::tall);
    world.profile.bodies_heavy = bodies_of(Effort::heavy);
}

// The hot record and the drive of one body at the start of the step.
void prepare_body(const StepContext& step, double h, std::uint32_t index) {
    WorldState& world = step.world;
    HotBody& hot = world.scratch.hot[index + 1];
    BodyDrive& drive = world.scratch.drive[index + 1];
    const BodyWarm& warm = world.bodies.awake[index];
    const BodyCold& cold = world.bodies.cold[warm.body];
    const bool tumbling = tumbles(warm, cold, step.dt);
    world.scratch.tumbling[index + 1] = tumbling ? 1 : 0;
    if (tumbling) {
        const std::optional<PrincipalBend> bend = principal_bend(cold);
        world.scratch.tumblers[index + 1] = {warm.axes, bend ? bend->factors : Vec3{},
                                             bend.has_value()};
    }
    hot = {};
    drive = {};
    for (float& keep : drive.keep) keep = 1;
    put(hot.v, warm.v, warm.w);
    if (cold.type == BodyType::kinematic) return;
    hot.inverse_mass = as_float(cold.inverse_mass);
    hot.inverse_spin = as_float(cold.inverse_inertia.x.x);
    const Mat3 inertia = world_inverse_inertia(warm, cold);
    hot.inertia[0] = as_float(inertia.x.x);
    hot.inertia[1] = as_float(inertia.y.y);
    hot.inertia[2] = as_float(inertia.z.z);
    hot.inertia[3] = as_float(inertia.x.y);
    hot.inertia[4] = as_float(inertia.x.z);
    hot.inertia[5] = as_float(inertia.y.z);

    const Vec3 free = free_directions(cold);
    hot.free_x = as_float(free.x);
    hot.free_y = as_float(free.y);
    hot.free_z = as_float(free.z);

    const double linear = damping_factor(cold.linear_damping, h);
    const double angular = damping_factor(cold.angular_damping, h);
    for (int k = 0; k < 3; k++) {
        drive.keep[k] = as_float(linear);
        drive.keep[k + 3] = as_float(angular);
    }
    // The gyroscopic change of spin over the free step, spread evenly: it keeps L as the free step
    // does. Bodies that turn far in a step take it sub-step by sub-step: tumble(). Isotropic ones
    // have none.
    const bool torque_alone = (cold.isotropic && cold.locks == 0) || tumbling;
    const Vec3 spin_up = torque_alone ? inertia * warm.torque
                                      : (free_spin(warm, cold, step.dt).w - warm.w) / step.dt;
    put(drive.push, acceleration_of(warm, cold, world.def.gravity) * h, spin_up * h);
}

// Euler's equations for one sub-step. Within a step the spin of a tumbling body is that in the
// frame in which it stood at the start and turns with it since; finalize() turns it back into the
// world.
void tumble(WorldState& world, std::uint32_t index, double h) {
    HotBody& hot = world.scratch.hot[index + 1];
    const Tumbler& tumbler = world.scratch.tumblers[index + 1];
    const Vec3 start =
        transposed_times(tumbler.axes, {double{hot.w[0]}, double{hot.w[1]}, double{hot.w[2]}});
    const Vec3 end =
        tumbler.principal
            ? euler_step(PrincipalBend{tumbler.bend}, start, h).w
            : euler_step(world.bodies.cold[world.bodies.awake[index].body], start, h).w;
    const Vec3 change = tumbler.axes * (end - start);
    // Not an impulse: it counts among what acts without contacts.
    for (int k = 0; k < 3; k++) {
        hot.w[k] += as_float(change[k]);
        hot.free[3 + k] += as_float(change[k]);
    }
}

// Splits the work on the dynamic bodies of one effort, by hot index, among the threads.
template <class Work>
void each_body(StepContext& step, Effort effort, Work&& work) {
    const auto& solved = step.world.scratch.in_solver[index_of(effort)];
    step.team.run(static_cast<int>(solved.size()), 256, [&](int begin, int end) {
        work(std::span(solved).subspan(static_cast<std::size_t>(begin),
                                       static_cast<std::size_t>(end - begin)));
    });
}

BodyRange range_of(StepScratch& scratch, std::span<const std::uint32_t> indices) {
    return {scratch.hot.data(), scratch.drive.data(), indices.data(), 0,
            static_cast<int>(indices.size())};
}

void prepare_drivers(StepContext& step) {
    for (const std::uint32_t hot : step.world.scratch.drivers) prepare_body(step, 0, hot - 1);
}

// The sub-steps of all islands of one effort.
void solve_effort(StepContext& step, Effort effort) {
    WorldState& world = step.world;
    StepScratch& scratch = world.scratch;
    const ContactSettings& set = step.contacts[index_of(effort)];
    const double h = step.dt / set.substeps;
    each_body(step, effort, [&](std::span<const std::uint32_t> part) {
        for (const std::uint32_t hot : part) prepare_body(step, h, hot - 1);
    });
    prepare_drivers(step);
    prepare_joints(step, effort, h);
    ManifoldStore& manifolds = world.manifolds[index_of(effort)];
    const std::span<HotBody> bodies = scratch.hot;
    const Kernels& kernel = kernels();
    const bool bouncy = begin_bounces(manifolds, bodies, set, step.team);
    for (int n = 0; n < set.substeps; n++) {
        const bool first = n == 0, last = n + 1 == set.substeps;
        each_body(step, effort, [&](std::span<const std::uint32_t> part) {
            (first ? kernel.accelerate_first : kernel.accelerate)(range_of(scratch, part));
        });
        if (first && bouncy) foresee_bounces(manifolds, bodies, set, step.team);
        // Later sub-steps are warm started by accelerate().
        if (first) warm_start(manifolds, bodies, set, step.team);
        solve_joints(step, h);
        solve(manifolds, bodies, set, step.team);
        each_body(step, effort, [&](std::span<const std::uint32_t> part) {
            for (const std::uint32_t hot : part)
                if (scratch.tumbling[hot] != 0) tumble(world, hot - 1, h);
            kernel.advance(range_of(scratch, part), set.h);
        });
        kernel.advance(range_of(scratch, scratch.drivers), set.h);
        relax_joints(step, h);
        relax(manifolds, bodies, set, last, step.team);
        if (bouncy) note_bounce_peaks(manifolds, bodies, set, step.team);
    }
    if (bouncy) end_bounces(manifolds, bodies, set, step.team);
    finish_joints(step);
}

}  // namespace

Skipped solve_constraints(StepContext& step) {
    if (step.world.bodies.awake.empty()) return nobody_awake;
    StepScratch& scratch = step.world.scratch;
    sort_out_bodies(step.world);
    bool any = false;
    for (const auto& solved : scratch.in_solver) any = any || !solved.empty();
    if (!any) return "nothing touches and nothing is jointed";
    scratch.hot.resize(step.world.bodies.awake.size() + 1);
    scratch.drive.resize(step.world.bodies.awake.size() + 1);
    scratch.tumblers.resize(step.world.bodies.awake.size() + 1);
    scratch.tumbling.assign(step.world.bodies.awake.size() + 1, 0);
    scratch.hot[0] = {};
    // What is frozen stands still and cannot be pushed.
    if (step.world.bodies.frozen > 0)
        for (std::size_t i = 0; i < step.world.bodies.awake.size(); i++)
            if (step.world.bodies.cold[step.world.bodies.awake[i].body].frozen)
                scratch.hot[i + 1] = {};
    for (const Effort effort : all_efforts)
        if (!scratch.in_solver[index_of(effort)].empty()) solve_effort(step, effort);
    return ran;
}

}  // namespace jostle::physics
