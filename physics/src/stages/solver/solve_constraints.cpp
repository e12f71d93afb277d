// SPDX-License-Identifier: MIT
#include "stages/solver/solve_constraints.h"

#include <algorithm>
#include <span>
#include <utility>

#include "constraint_graph/wide_rows.h"
#include "constraints/contact_passes.h"
#include "constraints/free_motion.h"
#include "stages/solver/solve_joints.h"

namespace jostle::physics {
namespace {

void put(float* row, Vec3 linear, Vec3 angular) {
    row[0] = as_float(linear.x), row[1] = as_float(linear.y), row[2] = as_float(linear.z);
    row[3] = as_float(angular.x), row[4] = as_float(angular.y), row[5] = as_float(angular.z);
}

constexpr std::uint8_t no_set = 255;
static_assert(solved_set_count < no_set);

// The bodies of each store, one after the other.
template <class Takes>
void collect(const WorldState& world, ByStore& list, Takes&& takes) {
    const std::vector<std::uint8_t>& set_of = world.scratch.set_of;
    std::array<std::uint32_t, solved_set_count> next{};
    for (std::uint32_t i = 0; i < set_of.size(); i++)
        if (set_of[i] != no_set && takes(i)) next[set_of[i]]++;
    std::uint32_t all = 0;
    for (std::size_t k = 0; k < next.size(); k++) {
        list.begin[k] = all;
        all += next[k];
        next[k] = list.begin[k];
    }
    list.begin.back() = all;
    list.all.resize(all);
    for (std::uint32_t i = 0; i < set_of.size(); i++)
        if (set_of[i] != no_set && takes(i)) list.all[next[set_of[i]]++] = i + 1;
}

void sort_out_bodies(WorldState& world) {
    StepScratch& scratch = world.scratch;
    scratch.drivers.clear();
    scratch.free.clear();
    scratch.set_of.assign(world.bodies.awake.size(), no_set);
    const auto cold_of = [&](std::uint32_t i) -> const BodyCold& {
        return world.bodies.cold[world.bodies.awake[i].body];
    };
    bool any_jointed = false;
    for (std::uint32_t i = 0; i < world.bodies.awake.size(); i++) {
        const BodyCold& cold = cold_of(i);
        const bool held = cold.constraints > 0 || cold.first_joint != none;
        if (cold.asleep_in_place) continue;
        if (cold.type == BodyType::kinematic) {
            // Moved by its velocity, whatever touches it; the solver reads it when something may.
            scratch.free.push_back(i);
            if (held || cold.first_edge != none) scratch.drivers.push_back(i + 1);
        } else if (held) {
            const ColourSetKey store = world.islands.islands[cold.island].colour_set;
            scratch.set_of[i] = static_cast<std::uint8_t>(index_of(store));
            any_jointed = any_jointed || cold.first_joint != none;
        } else {
            scratch.free.push_back(i);
        }
    }
    collect(world, scratch.in_solver, [](std::uint32_t) { return true; });
    collect(world, scratch.jointed_in_solver,
            [&](std::uint32_t i) { return any_jointed && cold_of(i).first_joint != none; });
    world.profile.bodies_frozen = static_cast<int>(world.bodies.asleep_in_place);
    world.profile.bodies_awake =
        static_cast<int>(world.bodies.awake.size() - world.bodies.asleep_in_place);
    world.profile.bodies_in_solver =
        world.profile.bodies_awake - static_cast<int>(scratch.free.size());
    const auto bodies_of = [&](SolverTier tier) {
        const std::size_t first = index_of(ColourSetKey{tier, 0});
        return static_cast<int>(scratch.in_solver.of(first, first + batch_count).size());
    };
    world.profile.bodies_flat = bodies_of(SolverTier::flat);
    world.profile.bodies_tall = bodies_of(SolverTier::tall);
    world.profile.bodies_heavy = bodies_of(SolverTier::heavy);
}

// The hot record and the drive of one body at the start of the step.
void prepare_body(const StepContext& step, double h, std::uint32_t index) {
    WorldState& world = step.world;
    HotBody& hot = world.scratch.hot[index + 1];
    BodyDrive& drive = world.scratch.drive[index + 1];
    const BodyWarm& warm = world.bodies.awake[index];
    const BodyCold& cold = world.bodies.cold[warm.body];
    const bool gyroscopic = is_gyroscopic(warm, cold, step.dt);
    world.scratch.gyroscopic[index + 1] = gyroscopic ? 1 : 0;
    if (gyroscopic) {
        const std::optional<PrincipalRatios> bend = principal_ratios(cold);
        world.scratch.gyroscopic_bodies[index + 1] = {warm.axes, bend ? bend->factors : Vec3{},
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
    // does. Bodies that turn far in a step take it sub-step by sub-step: integrate_gyroscopic().
    // Isotropic ones have none.
    const bool torque_alone = (cold.isotropic && cold.locks == 0) || gyroscopic;
    const Vec3 spin_up = torque_alone ? inertia * warm.torque
                                      : (free_spin(warm, cold, step.dt).w - warm.w) / step.dt;
    put(drive.push, acceleration_of(warm, cold, world.def.gravity) * h, spin_up * h);
}

// Euler's equations for one sub-step. Within a step the spin of a gyroscopic body is that in the
// frame in which it stood at the start and turns with it since; finalize() turns it back into the
// world.
void integrate_gyroscopic(WorldState& world, std::uint32_t index, double h) {
    HotBody& hot = world.scratch.hot[index + 1];
    const GyroscopicBody& gyroscopic_body = world.scratch.gyroscopic_bodies[index + 1];
    const Vec3 start = transposed_times(gyroscopic_body.axes,
                                        {double{hot.w[0]}, double{hot.w[1]}, double{hot.w[2]}});
    const Vec3 end =
        gyroscopic_body.principal
            ? euler_step(PrincipalRatios{gyroscopic_body.bend}, start, h).w
            : euler_step(world.bodies.cold[world.bodies.awake[index].body], start, h).w;
    const Vec3 change = gyroscopic_body.axes * (end - start);
    // Not an impulse: it counts among what acts without contacts.
    for (int k = 0; k < 3; k++) {
        hot.w[k] += as_float(change[k]);
        hot.free[3 + k] += as_float(change[k]);
    }
}

// ---- parts ----

// What is solved by itself: all that is in the stores [first, last), which are of one tier.
struct Part {
    SolverTier tier;
    std::size_t first, last;
    std::uint32_t weight;  // bodies and manifolds
};

Part make_part(const WorldState& world, SolverTier tier, std::size_t first, std::size_t last) {
    Part part{tier, first, last, 0};
    part.weight = static_cast<std::uint32_t>(world.scratch.in_solver.of(first, last).size());
    for (std::size_t k = first; k < last; k++)
        part.weight += static_cast<std::uint32_t>(world.graph.sets[k].contacts);
    return part;
}

// One thread fills the lanes of joint blocks best with all batches of an tier at once; several
// take a batch each. That changes no result: islands know nothing of each other.
std::vector<Part> make_parts(const StepContext& step) {
    std::vector<Part> parts;
    const std::size_t together = step.team.size() == 1 ? batch_count : 1;
    for (const SolverTier tier : all_tiers) {
        const std::size_t first = index_of(ColourSetKey{tier, 0});
        for (std::size_t k = first; k < first + batch_count; k += together)
            if (!step.world.scratch.in_solver.of(k, k + together).empty())
                parts.push_back(make_part(step.world, tier, k, k + together));
    }
    return parts;
}

// Kinematic bodies move on in each sub-step, and whoever solves a part with one moves them.
bool reads_drivers(const WorldState& world, const Part& part) {
    const StepScratch& scratch = world.scratch;
    if (scratch.drivers.empty()) return false;
    const auto jointed = [&](std::uint32_t hot) {
        return world.bodies.cold[world.bodies.awake[hot - 1].body].first_joint != none;
    };
    if (!scratch.jointed_in_solver.of(part.first, part.last).empty() &&
        std::any_of(scratch.drivers.begin(), scratch.drivers.end(), jointed))
        return true;
    for (std::size_t k = part.first; k < part.last; k++)
        for (int c = 0; c < colour_count; c++)
            if (pair_kind_of(c) == PairKind::kinematic &&
                world.graph.sets[k].colours[static_cast<std::size_t>(c)].contacts > 0)
                return true;
    return false;
}

// ---- one part ----

// Splits the work on the dynamic bodies of a part, by hot index, among the threads.
template <class Work>
void each_body(StepContext& step, const Part& part, Work&& work) {
    const auto solved = step.world.scratch.in_solver.of(part.first, part.last);
    step.team.run(
        static_cast<int>(solved.size()), 256,
        [&](int begin, int end) {
            work(solved.subspan(static_cast<std::size_t>(begin),
                                static_cast<std::size_t>(end - begin)));
        },
        TaskTeam::Part::own);
}

BodyRange range_of(StepScratch& scratch, std::span<const std::uint32_t> indices) {
    return {scratch.hot.data(), scratch.drive.data(), indices.data(), 0,
            static_cast<int>(indices.size())};
}

// Of what was prepared.
void run_substeps(StepContext& step, const Part& part, const JointPart& joints,
                  std::span<const std::uint32_t> drivers) {
    StepScratch& scratch = step.world.scratch;
    const ContactSettings& set = step.contacts[index_of(part.tier)];
    const double h = step.dt / set.substeps;
    const ContactPart contacts{scratch.colour_runs[part.first], scratch.hot.data(), set, step.team};
    const Kernels& kernel = kernels();
    const bool bouncy = begin_restitution(contacts);
    for (int n = 0; n < set.substeps; n++) {
        const bool first = n == 0, last = n + 1 == set.substeps;
        each_body(step, part, [&](std::span<const std::uint32_t> some) {
            (first ? kernel.accelerate_first : kernel.accelerate)(range_of(scratch, some));
        });
        if (first && bouncy) predict_approaches(contacts);
        // Later sub-steps are warm started by accelerate().
        if (first) warm_start(contacts);
        solve_joints(step, joints, h);
        solve(contacts);
        each_body(step, part, [&](std::span<const std::uint32_t> some) {
            for (const std::uint32_t hot : some)
                if (scratch.gyroscopic[hot] != 0) integrate_gyroscopic(step.world, hot - 1, h);
            kernel.advance(range_of(scratch, some), set.h);
        });
        kernel.advance(range_of(scratch, drivers), set.h);
        relax_joints(step, joints, h);
        relax(contacts, last);
        if (bouncy) record_peaks(contacts);
    }
    if (bouncy) apply_restitution(contacts);
}

void solve_part(StepContext& step, const Part& part, std::span<const std::uint32_t> drivers) {
    WorldState& world = step.world;
    StepScratch& scratch = world.scratch;
    const double h = step.dt / step.contacts[index_of(part.tier)].substeps;
    each_body(step, part, [&](std::span<const std::uint32_t> bodies) {
        for (const std::uint32_t hot : bodies) prepare_body(step, h, hot - 1);
    });
    for (const std::uint32_t hot : drivers) prepare_body(step, 0, hot - 1);
    const JointPart joints{scratch.joints[part.first],
                           scratch.jointed_in_solver.of(part.first, part.last)};
    prepare_joints(step, joints, h);
    std::vector<ColourRun>& colours = scratch.colour_runs[part.first];
    list_runs(world.graph, part.first, part.last, colours);
    // Where threads share neither colours nor levels, passes over bodies would do nothing but carry
    // them from one cache to the other and back.
    const bool shared =
        shares_levels(joints) || std::any_of(colours.begin(), colours.end(),
                                             [](const ColourRun& run) { return run.shared; });
    TaskTeam alone(1);
    StepContext substeps{world, shared ? step.team : alone, step.dt, step.contacts};
    run_substeps(substeps, part, joints, drivers);
    finish_joints(step, joints);
}

// ---- all parts ----

// A part that is so light, or so light a share of all, is one thread's: nobody waits for anybody
// until all are done. The threads share the colours of a heavier one.
constexpr std::uint32_t light_part = 4000;

void solve_parts(StepContext& step, const std::vector<Part>& parts) {
    const std::vector<std::uint32_t>& drivers = step.world.scratch.drivers;
    if (step.team.size() == 1) {
        for (const Part& part : parts) solve_part(step, part, drivers);
        return;
    }
    std::uint32_t all = 0;
    for (const Part& part : parts) all += part.weight;
    const auto light_share = all / (2 * static_cast<std::uint32_t>(step.team.size()));
    std::vector<Part> tasks, shared;
    for (const Part& part : parts) {
        const bool light = part.weight <= std::max(light_part, light_share);
        (light && !reads_drivers(step.world, part) ? tasks : shared).push_back(part);
    }
    if (tasks.size() == 1) shared.push_back(std::exchange(tasks, {}).front());
    // A batch is solved by the same thread in each step, which has its records in its cache.
    std::stable_sort(tasks.begin(), tasks.end(), [](const Part& a, const Part& b) {
        return a.first % batch_count < b.first % batch_count;
    });
    for (const Part& part : shared) solve_part(step, part, drivers);
    TaskTeam alone(1);
    step.team.run_tasks(static_cast<int>(tasks.size()), [&](int k) {
        StepContext own{step.world, alone, step.dt, step.contacts};
        solve_part(own, tasks[static_cast<std::size_t>(k)], {});
    });
    step.world.profile.solver_tasks = static_cast<int>(tasks.size());
}

}  // namespace

Skipped solve_constraints(StepContext& step) {
    if (step.world.bodies.awake.empty()) return nobody_awake;
    StepScratch& scratch = step.world.scratch;
    sort_out_bodies(step.world);
    if (scratch.in_solver.all.empty()) return "nothing touches and nothing is jointed";
    scratch.hot.resize(step.world.bodies.awake.size() + 1);
    scratch.drive.resize(step.world.bodies.awake.size() + 1);
    scratch.gyroscopic_bodies.resize(step.world.bodies.awake.size() + 1);
    scratch.gyroscopic.assign(step.world.bodies.awake.size() + 1, 0);
    // What is frozen stands still and cannot be pushed.
    if (step.world.bodies.asleep_in_place > 0)
        for (std::size_t i = 0; i < step.world.bodies.awake.size(); i++)
            if (step.world.bodies.cold[step.world.bodies.awake[i].body].asleep_in_place)
                scratch.hot[i + 1] = {};
    solve_parts(step, make_parts(step));
    break_joints(step);
    return ran;
}

}  // namespace jostle::physics
