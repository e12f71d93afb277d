// SPDX-License-Identifier: MIT
#include "physics/src/stages/stages.h"

#include <algorithm>
#include <span>
#include <utility>

#include "jostle/base/check.h"
#include "physics/src/constraint_graph/wide_rows.h"
#include "physics/src/constraints/contact_passes.h"
#include "physics/src/constraints/free_motion.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/solver/apply_joint_impacts.h"
#include "physics/src/stages/solver/error_trial.h"
#include "physics/src/stages/solver/joint_groups.h"
#include "physics/src/stages/solver/solve_joints.h"
#include "physics/src/stages/solver/substep_hooks.h"
#include "physics/src/stages/step_scratch.h"

namespace jostle::physics {
namespace {

void put(float* row, Vec3 linear, Vec3 angular) {
    row[0] = as_float(linear.x), row[1] = as_float(linear.y), row[2] = as_float(linear.z);
    row[3] = as_float(angular.x), row[4] = as_float(angular.y), row[5] = as_float(angular.z);
}

constexpr std::uint8_t no_set = 255;
static_assert(solved_set_count < no_set);

// The bodies of each colour set, one after the other.
template <class Takes>
void collect(const std::vector<std::uint8_t>& set_of, BodiesBySet& list, Takes&& takes) {
    std::array<std::uint32_t, solved_set_count> next{};
    for (std::uint32_t i = 0; i < set_of.size(); i++) {
        ASSERT(set_of[i] == no_set || set_of[i] < solved_set_count);
        if (set_of[i] != no_set && takes(i)) next[set_of[i]]++;
    }
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

void classify_bodies(const BodyStore& bodies, const IslandStore& islands, SolverScratch& scratch) {
    scratch.kinematic.clear();
    scratch.free.clear();
    scratch.set_of.assign(bodies.awake.size(), no_set);
    const auto cold_of = [&](std::uint32_t i) -> const BodyCold& {
        return bodies.cold[bodies.awake[i].body];
    };
    bool any_jointed = false;
    const bool grouped = !scratch.groups.active.empty();
    for (std::uint32_t i = 0; i < bodies.awake.size(); i++) {
        const BodyCold& cold = cold_of(i);
        const bool held = cold.constraints > 0 || cold.first_joint != none;
        if (cold.asleep_in_place) continue;
        if (grouped && scratch.groups.grouped[i] != 0) continue;
        if (cold.type == BodyType::kinematic) {
            // Moved by its velocity, whatever touches it; the solver reads it when something may.
            scratch.free.push_back(i);
            if (held || cold.first_edge != none) scratch.kinematic.push_back(i + 1);
        } else if (held) {
            ASSERT(islands.ids.alive(cold.island));
            const ColourSetKey set = islands.islands[cold.island].colour_set;
            scratch.set_of[i] = static_cast<std::uint8_t>(index_of(set));
            any_jointed = any_jointed || cold.first_joint != none;
        } else {
            scratch.free.push_back(i);
        }
    }
    collect(scratch.set_of, scratch.bodies, [](std::uint32_t) { return true; });
    collect(scratch.set_of, scratch.jointed,
            [&](std::uint32_t i) { return any_jointed && cold_of(i).first_joint != none; });
}

// For the profile.
void count_substeps(const StepContext& step, StepProfile& profile) {
    const SolverScratch& scratch = step.scratch.solver;
    for (std::size_t set = 0; set < solved_set_count; set++) {
        const auto bodies = static_cast<std::int64_t>(scratch.bodies.of(set, set + 1).size());
        const int substeps = step.contacts[set].substeps;
        profile.body_substeps += bodies * substeps;
        profile.contact_substeps += std::int64_t{step.world.graph.sets[set].contacts} * substeps;
        if (wants_trial(step, set)) profile.trial_substeps += bodies * (substeps / 2);
    }
    for (const std::uint32_t island : scratch.groups.active) {
        const Island& of = step.world.islands.islands[island];
        const int substeps = scratch.groups.of_island[island]->substeps;
        profile.body_substeps += std::int64_t{of.bodies} * substeps;
        if (wants_trial(step, index_of(of.colour_set)))
            profile.trial_substeps += std::int64_t{of.bodies} * (substeps / 2);
    }
}

void count_bodies(const BodyStore& bodies, const SolverScratch& scratch, StepProfile& profile) {
    profile.bodies_asleep_in_place = static_cast<int>(bodies.asleep_in_place);
    profile.bodies_awake = static_cast<int>(bodies.awake.size() - bodies.asleep_in_place);
    profile.bodies_in_solver = profile.bodies_awake - static_cast<int>(scratch.free.size());
    const auto bodies_of = [&](SolverTier tier) {
        const std::size_t first = index_of(ColourSetKey{tier, 0});
        return static_cast<int>(scratch.bodies.of(first, first + batch_count).size());
    };
    profile.bodies_flat = bodies_of(SolverTier::flat);
    profile.bodies_tall = bodies_of(SolverTier::tall);
    profile.bodies_heavy = bodies_of(SolverTier::heavy);
}

void put_inertia(SolverBody& hot, const Mat3& inverse) {
    hot.inertia[0] = as_float(inverse.x.x);
    hot.inertia[1] = as_float(inverse.y.y);
    hot.inertia[2] = as_float(inverse.z.z);
    hot.inertia[3] = as_float(inverse.x.y);
    hot.inertia[4] = as_float(inverse.x.z);
    hot.inertia[5] = as_float(inverse.y.z);
}

// The hot record of one body, and what changes it apart from contacts, at the start of the step.
void prepare_body(const StepContext& step, double h, std::uint32_t index) {
    const WorldState& world = step.world;
    SolverScratch& scratch = step.scratch.solver;
    SolverBody& hot = scratch.hot[index + 1];
    ExternalChange& external = scratch.external[index + 1];
    const BodyWarm& warm = world.bodies.awake[index];
    const BodyCold& cold = world.bodies.cold[warm.body];
    ASSERT(!cold.asleep_in_place);
    const bool touched = cold.constraints > 0;
    const bool gyroscopic = is_gyroscopic(
        warm, cold, step.dt, touched ? tuning::gyroscopic_turn : tuning::jointed_gyroscopic_turn);
    scratch.spin_axes[index + 1] = !gyroscopic ? SpinAxes::world
                                   : touched   ? SpinAxes::body
                                               : SpinAxes::world_by_substeps;
    if (gyroscopic) {
        const std::optional<PrincipalRatios> bend = principal_ratios(cold);
        scratch.gyroscopic[index + 1] = {
            warm.axes,       warm.rotation, warm.rotation, {}, bend ? bend->factors : Vec3{},
            bend.has_value()};
    }
    hot = {};
    hot.spins_along = gyroscopic && touched && cold.first_joint != none ? 1 : 0;
    external = {};
    for (float& retained : external.retained) retained = 1;
    put(hot.v, warm.v, warm.w);
    if (cold.type == BodyType::kinematic) return;
    ASSERT(h > 0);
    hot.inverse_mass = as_float(cold.inverse_mass);
    hot.inverse_spin = as_float(cold.inverse_inertia.x.x);
    const Mat3 inertia = world_inverse_inertia(warm, cold);
    put_inertia(hot, inertia);
    const Vec3 free = free_directions(cold);
    hot.free_x = as_float(free.x);
    hot.free_y = as_float(free.y);
    hot.free_z = as_float(free.z);

    const double linear = damping_factor(cold.linear_damping, h);
    const double angular = damping_factor(cold.angular_damping, h);
    for (int k = 0; k < 3; k++) {
        external.retained[k] = as_float(linear);
        external.retained[k + 3] = as_float(angular);
    }
    // The gyroscopic change of spin over the free step, spread evenly: it keeps L as the free step
    // does. Bodies that turn far in a step take it sub-step by sub-step: integrate_gyroscopic().
    // Isotropic ones have none.
    const bool torque_alone = (cold.isotropic && cold.locks == 0) || gyroscopic;
    const Vec3 spin_up = torque_alone ? inertia * warm.torque
                                      : (free_spin(warm, cold, step.dt).w - warm.w) / step.dt;
    put(external.push, acceleration_of(warm, cold, world.def.gravity) * h, spin_up * h);
}

EulerStep euler_step_of(const BodyStore& bodies, const GyroscopicBody& g, std::uint32_t hot_index,
                        Vec3 start, double h) {
    return g.principal ? euler_step(PrincipalRatios{g.bend}, start, h)
                       : euler_step(bodies.cold[bodies.awake[hot_index - 1].body], start, h);
}
// Not an impulse: it counts among what acts without contacts.
void add_spin(SolverBody& hot, Vec3 change) {
    for (int k = 0; k < 3; k++) {
        hot.w[k] += as_float(change[k]);
        hot.free[3 + k] += as_float(change[k]);
    }
}

// Euler's equations for one sub-step, before advance(), which adds h w to the rotation vector.
void turn_free(const BodyStore& bodies, SolverScratch& scratch, std::uint32_t hot_index, double h) {
    SolverBody& hot = scratch.hot[hot_index];
    const GyroscopicBody& g = scratch.gyroscopic[hot_index];
    const Vec3 start = transposed_times(g.axes, to_vec3(hot.w));
    add_spin(hot, g.axes * (euler_step_of(bodies, g, hot_index, start, h).w - start));
}
// The second half of what begin_gyroscopic() began: now the spin is what joints allow, and turns
// the body to where it goes exactly.
void turn_jointed(const BodyStore& bodies, SolverScratch& scratch, std::uint32_t hot_index,
                  double h) {
    SolverBody& hot = scratch.hot[hot_index];
    GyroscopicBody& g = scratch.gyroscopic[hot_index];
    const Vec3 mean = to_vec3(hot.w), own = transposed_times(g.axes, mean);
    g.now = normalized(g.now * from_rotation_vector(own * h));
    if (scratch.spin_axes[hot_index] == SpinAxes::world_by_substeps) {
        const BodyCold& cold = bodies.cold[bodies.awake[hot_index - 1].body];
        g.axes = to_matrix(g.now);
        put_inertia(hot, g.axes * cold.inverse_inertia * transpose(g.axes));
    }
    const Vec3 w = g.axes * (own + g.half_change);
    const Vec3 turn = rotation_vector_between(g.start, g.now, to_vec3(hot.dr) + mean * h) - w * h;
    for (int k = 0; k < 3; k++) hot.dr[k] = as_float(turn[k]);
    add_spin(hot, w - mean);
}

// Of bodies that joints hold, half of the gyroscopic change of a sub-step before their points are
// solved for the last time: what those allow is the mean spin of the sub-step.
void begin_gyroscopic(StepContext& step, std::span<const std::uint32_t> jointed, double h) {
    SolverScratch& scratch = step.scratch.solver;
    for (const std::uint32_t index : jointed) {
        if (scratch.spin_axes[index] == SpinAxes::world) continue;
        SolverBody& hot = scratch.hot[index];
        GyroscopicBody& g = scratch.gyroscopic[index];
        const Vec3 start = transposed_times(g.axes, to_vec3(hot.w));
        const EulerStep change = euler_step_of(step.world.bodies, g, index, start, h);
        g.half_change = (change.w - start) * 0.5;
        add_spin(hot, g.axes * g.half_change);
    }
}
void integrate_gyroscopic(StepContext& step, std::span<const std::uint32_t> bodies, double h) {
    SolverScratch& scratch = step.scratch.solver;
    for (const std::uint32_t hot : bodies) {
        if (scratch.spin_axes[hot] == SpinAxes::world) continue;
        const BodyStore& all = step.world.bodies;
        if (all.cold[all.awake[hot - 1].body].first_joint != none)
            turn_jointed(all, scratch, hot, h);
        else
            turn_free(all, scratch, hot, h);
    }
}

// ---- tasks ----

// What is solved by itself: all that is in the colour sets [first, last), which are of one tier and
// take as many sub-steps.
struct SolverTask {
    SolverTier tier;
    std::size_t first, last;
    std::uint32_t weight;  // bodies and contacts
};

SolverTask make_task(const ConstraintGraph& graph, const BodiesBySet& bodies, SolverTier tier,
                     std::size_t first, std::size_t last) {
    ASSERT(first < last && last <= solved_set_count);
    SolverTask task{tier, first, last, 0};
    task.weight = static_cast<std::uint32_t>(bodies.of(first, last).size());
    for (std::size_t k = first; k < last; k++)
        task.weight += static_cast<std::uint32_t>(graph.sets[k].contacts);
    return task;
}

// One thread fills the lanes of joint blocks best with all batches of a tier at once; several take
// a batch each. That changes no result: islands know nothing of each other.
std::vector<SolverTask> make_tasks(const StepContext& step) {
    const BodiesBySet& bodies = step.scratch.solver.bodies;
    std::vector<SolverTask> tasks;
    // Listeners see the same groups of bodies whatever the threads. With a tolerance batches differ
    // in their sub-steps.
    const bool any_together =
        step.thread_pool.size() == 1 || listens_on_one_thread(step.world.listeners);
    const std::size_t together = any_together && !controls_error(step.world.def) ? batch_count : 1;
    for (const SolverTier tier : all_tiers) {
        const std::size_t first = index_of(ColourSetKey{tier, 0});
        for (std::size_t k = first; k < first + batch_count; k += together)
            if (!bodies.of(k, k + together).empty())
                tasks.push_back(make_task(step.world.graph, bodies, tier, k, k + together));
    }
    return tasks;
}

// Kinematic bodies move on in each sub-step, and whoever solves a task with one moves them.
bool reads_kinematic(const StepContext& step, const SolverTask& task) {
    const WorldState& world = step.world;
    const SolverScratch& scratch = step.scratch.solver;
    if (scratch.kinematic.empty()) return false;
    const auto jointed = [&](std::uint32_t hot) {
        return world.bodies.cold[world.bodies.awake[hot - 1].body].first_joint != none;
    };
    if (!scratch.jointed.of(task.first, task.last).empty() &&
        std::any_of(scratch.kinematic.begin(), scratch.kinematic.end(), jointed))
        return true;
    for (std::size_t k = task.first; k < task.last; k++)
        for (int c = 0; c < colour_count; c++)
            if (pair_kind_of(c) == PairKind::kinematic &&
                world.graph.sets[k].colours[static_cast<std::size_t>(c)].contacts > 0)
                return true;
    return false;
}

// ---- one task ----

// Splits the work on the dynamic bodies of a task, by hot index, among the threads.
template <class Work>
void each_body(StepContext& step, const SolverTask& task, Work&& work) {
    const auto solved = step.scratch.solver.bodies.of(task.first, task.last);
    step.thread_pool.run(
        static_cast<int>(solved.size()), tuning::body_grain,
        [&](int begin, int end) {
            work(solved.subspan(static_cast<std::size_t>(begin),
                                static_cast<std::size_t>(end - begin)));
        },
        ThreadPool::Split::fixed);
}

BodyRange range_of(SolverScratch& scratch, std::span<const std::uint32_t> indices) {
    return {scratch.hot.data(), scratch.external.data(), indices.data(), 0,
            static_cast<int>(indices.size())};
}

void listen(StepContext& step, const SubstepInfo& substep_info, const SolverTask& task) {
    const BodiesBySet& bodies = step.scratch.solver.bodies;
    // By sets, however many of them this thread solves together.
    const std::size_t together = listens_at_once(step.world.listeners) ? 1 : task.last - task.first;
    for (std::size_t k = task.first; k < task.last; k += together)
        if (!bodies.of(k, k + together).empty())
            call_listeners(step, substep_info, bodies.of(k, k + together), k, k + together);
}

// Of what was prepared.
void run_substeps(StepContext& step, const SolverTask& task, const ContactSettings& set,
                  const JointTask& joints, std::span<const std::uint32_t> kinematic) {
    SolverScratch& scratch = step.scratch.solver;
    ASSERT(set.substeps >= 1);
    const double h = step.dt / set.substeps;
    const ContactTask contacts{scratch.colour_runs[task.first], scratch.hot.data(), set,
                               step.thread_pool};
    const Kernels& kernel = kernels();
    if (!scratch.jointed.of(task.first, task.last).empty())
        apply_joint_impacts(step, contacts.runs);
    const bool bounces = begin_restitution(contacts);
    const bool listened = has_substep_listeners(step.world.listeners);
    const std::vector<std::uint32_t>& in_fields = scratch.in_fields[task.first];
    for (int n = 0; n < set.substeps; n++) {
        const bool first = n == 0, last = n + 1 == set.substeps;
        if (!first && is_stopped(step)) break;
        SubstepInfo substep_info{n, set.substeps, h};
        if (listened) listen(step, substep_info, task);
        if (!in_fields.empty()) push_by_fields(step, substep_info, in_fields);
        each_body(step, task, [&](std::span<const std::uint32_t> some) {
            (first ? kernel.accelerate_first : kernel.accelerate)(range_of(scratch, some));
        });
        if (first && bounces) predict_approaches(contacts);
        // Later sub-steps are warm started by accelerate().
        if (first) warm_start(contacts);
        solve_joints(step, joints, h);
        solve_joint_batches(step, joints, h, false);
        solve(contacts);
        begin_gyroscopic(step, joints.bodies, h);
        solve_joint_batches(step, joints, h, true);
        each_body(step, task, [&](std::span<const std::uint32_t> some) {
            integrate_gyroscopic(step, some, h);
            kernel.advance(range_of(scratch, some), set.h);
        });
        kernel.advance(range_of(scratch, kinematic), set.h);
        relax_joints(step, joints, h);
        relax(contacts, last);
        relax_joint_batches(step, joints, h);
        if (bounces) record_peaks(contacts);
        substep_info.after = true;
        if (listened) listen(step, substep_info, task);
    }
    if (bounces) apply_restitution(contacts);
}

JointTask joints_of(StepContext& step, const SolverTask& task) {
    SolverScratch& scratch = step.scratch.solver;
    return {scratch.joints[task.first], scratch.joint_batches[task.first],
            scratch.jointed.of(task.first, task.last)};
}

// Prepares and runs them: bodies, contacts and joints are then where they go, but for what
// finish_joints() keeps.
void solve_with(StepContext& step, const SolverTask& task, const ContactSettings& set,
                std::span<const std::uint32_t> kinematic) {
    WorldState& world = step.world;
    SolverScratch& scratch = step.scratch.solver;
    const double h = step.dt / set.substeps;
    each_body(step, task, [&](std::span<const std::uint32_t> bodies) {
        for (const std::uint32_t hot : bodies) prepare_body(step, h, hot - 1);
    });
    for (const std::uint32_t hot : kinematic) prepare_body(step, 0, hot - 1);
    scratch.in_fields[task.first].clear();
    if (!world.fields.empty())
        find_in_fields(step, scratch.bodies.of(task.first, task.last),
                       scratch.in_fields[task.first]);
    const JointTask joints = joints_of(step, task);
    prepare_joints(step, joints, h);
    std::vector<ColourRun>& colours = scratch.colour_runs[task.first];
    list_runs(world.graph, task.first, task.last, colours);
    // Where threads share neither colours nor levels, passes over bodies would do nothing but carry
    // them from one cache to the other and back.
    const bool shared =
        shares_levels(joints) || std::any_of(colours.begin(), colours.end(),
                                             [](const ColourRun& run) { return run.shared; });
    ThreadPool alone(1);
    StepContext substeps{world, step.scratch, shared ? step.thread_pool : alone, step.dt,
                         step.contacts};
    run_substeps(substeps, task, set, joints, kinematic);
}

void solve_task(StepContext& step, const SolverTask& task,
                std::span<const std::uint32_t> kinematic) {
    const ContactSettings& set = step.contacts[task.first];
    const SolverScratch& scratch = step.scratch.solver;
    const auto bodies = scratch.bodies.of(task.first, task.last),
               jointed = scratch.jointed.of(task.first, task.last);
    const bool twice = wants_trial(step, task.first);
    if (twice) {
        ContactSettings coarse =
            contact_settings(step.dt, set.substeps / 2, task.tier, set.substeps);
        coarse.planar = set.planar;
        coarse.gravity_ratio = set.gravity_ratio;
        begin_trial(step, task.first, task.last, jointed);
        solve_with(step, task, coarse, kinematic);
        end_trial(step, task.first, task.last, bodies, jointed);
    }
    solve_with(step, task, set, kinematic);
    if (twice) compare_trial(step, task.first, task.last, bodies);
    finish_joints(step, joints_of(step, task));
}

// ---- all tasks ----

// A task that is so light, or so light a share of all, is one thread's: nobody waits for anybody
// until all are done. The threads share the colours of a heavier one.
void solve_tasks(StepContext& step, const std::vector<SolverTask>& tasks) {
    const std::vector<std::uint32_t>& kinematic = step.scratch.solver.kinematic;
    if (step.thread_pool.size() == 1 || listens_on_one_thread(step.world.listeners)) {
        for (const SolverTask& task : tasks) solve_task(step, task, kinematic);
        return;
    }
    std::uint32_t weight = 0;
    for (const SolverTask& task : tasks) weight += task.weight;
    const auto light_share = weight / (2 * static_cast<std::uint32_t>(step.thread_pool.size()));
    std::vector<SolverTask> single, shared;
    for (const SolverTask& task : tasks) {
        const bool light = task.weight <= std::max(tuning::light_task, light_share);
        (light && !reads_kinematic(step, task) ? single : shared).push_back(task);
    }
    if (single.size() == 1) shared.push_back(std::exchange(single, {}).front());
    // A batch is solved by the same thread in each step, which has its records in its cache.
    std::stable_sort(single.begin(), single.end(), [](const SolverTask& a, const SolverTask& b) {
        return a.first % batch_count < b.first % batch_count;
    });
    for (const SolverTask& task : shared) solve_task(step, task, kinematic);
    ThreadPool alone(1);
    step.thread_pool.run_tasks(static_cast<int>(single.size()), [&](int k) {
        StepContext own{step.world, step.scratch, alone, step.dt, step.contacts};
        solve_task(own, single[static_cast<std::size_t>(k)], {});
    });
    step.world.profile.solver_tasks = static_cast<int>(single.size());
}

}  // namespace

Skipped solve_constraints(StepContext& step) {
    const BodyStore& bodies = step.world.bodies;
    const ConstraintGraph& graph = step.world.graph;
    if (bodies.awake.empty()) return no_awake_bodies;
    SolverScratch& scratch = step.scratch.solver;
    find_joint_groups(step);
    classify_bodies(bodies, step.world.islands, scratch);
    count_bodies(bodies, scratch, step.world.profile);
    count_substeps(step, step.world.profile);
    ASSERT(!scratch.bodies.all.empty() ||
           std::all_of(graph.solved().begin(), graph.solved().end(),
                       [](const ColourSet& set) { return set.contacts == 0; }));
    if (scratch.bodies.all.empty()) {
        if (scratch.groups.active.empty()) return "nothing touches and nothing is jointed";
        solve_joint_groups(step);
        break_joints(step);
        return ran;
    }
    const std::size_t count = bodies.awake.size() + 1;
    scratch.hot.resize(count);
    scratch.external.resize(count);
    scratch.gyroscopic.resize(count);
    scratch.spin_axes.assign(count, SpinAxes::world);
    // What sleeps in place stands still and cannot be pushed.
    if (bodies.asleep_in_place > 0)
        for (std::size_t i = 0; i < bodies.awake.size(); i++)
            if (bodies.cold[bodies.awake[i].body].asleep_in_place) scratch.hot[i + 1] = {};
    solve_tasks(step, make_tasks(step));
    solve_joint_groups(step);
    break_joints(step);
    return ran;
}

}  // namespace jostle::physics
