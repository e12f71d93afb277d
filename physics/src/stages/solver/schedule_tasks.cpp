// SPDX-License-Identifier: MIT
#include "physics/src/stages/solver/schedule_tasks.h"

#include <algorithm>
#include <utility>

#include "jostle/base/check.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/solver/substep_hooks.h"
#include "physics/src/stages/step_scratch.h"

namespace jostle::physics {
namespace {

SolverTask make_task(const ConstraintGraph& graph, const BodiesBySet& bodies, SolverTier tier,
                     std::size_t first, std::size_t last) {
    ASSERT(first < last && last <= solved_set_count);
    SolverTask task{tier, first, last, 0};
    task.weight = static_cast<std::uint32_t>(bodies.of(first, last).size());
    for (std::size_t k = first; k < last; k++)
        task.weight += static_cast<std::uint32_t>(graph.sets[k].contacts);
    return task;
}

// A kinematic body moves in each sub-step. The task that reads it moves it.
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

// The tasks of one thread each, and those that all threads share.
struct Schedule {
    std::vector<SolverTask> single, shared;
};

Schedule schedule(const StepContext& step, const std::vector<SolverTask>& tasks) {
    std::uint32_t weight = 0;
    for (const SolverTask& task : tasks) weight += task.weight;
    const auto light_share = weight / (2 * static_cast<std::uint32_t>(step.thread_pool.size()));
    const std::uint32_t light = std::max(tuning::light_task, light_share);
    Schedule result;
    for (const SolverTask& task : tasks) {
        const bool alone = task.weight <= light && !reads_kinematic(step, task);
        (alone ? result.single : result.shared).push_back(task);
    }
    if (result.single.size() == 1)
        result.shared.push_back(std::exchange(result.single, {}).front());
    // The same thread solves a batch in each step, because its cache contains the records.
    std::stable_sort(result.single.begin(), result.single.end(),
                     [](const SolverTask& a, const SolverTask& b) {
                         return a.first % batch_count < b.first % batch_count;
                     });
    ASSERT(result.single.size() + result.shared.size() == tasks.size());
    return result;
}

}  // namespace

std::vector<SolverTask> make_tasks(const StepContext& step) {
    const BodiesBySet& bodies = step.scratch.solver.bodies;
    std::vector<SolverTask> tasks;
    // Listeners are called with the same groups of bodies for any number of threads.
    const bool any_together =
        step.thread_pool.size() == 1 || listens_on_one_thread(step.world.listeners);
    const std::size_t together = any_together && !batches_differ(step.world) ? batch_count : 1;
    for (const SolverTier tier : all_tiers) {
        const std::size_t first = index_of(ColourSetKey{tier, 0});
        for (std::size_t k = first; k < first + batch_count; k += together)
            if (!bodies.of(k, k + together).empty())
                tasks.push_back(make_task(step.world.graph, bodies, tier, k, k + together));
    }
    return tasks;
}

void run_tasks(StepContext& step, const std::vector<SolverTask>& tasks) {
    const std::vector<std::uint32_t>& kinematic = step.scratch.solver.kinematic;
    if (step.thread_pool.size() == 1 || listens_on_one_thread(step.world.listeners)) {
        for (const SolverTask& task : tasks) solve_task(step, task, kinematic);
        return;
    }
    const Schedule plan = schedule(step, tasks);
    for (const SolverTask& task : plan.shared) solve_task(step, task, kinematic);
    ThreadPool alone(1);
    step.thread_pool.run_tasks(static_cast<int>(plan.single.size()), [&](int k) {
        StepContext own{step.world, step.scratch, alone, step.dt, step.contacts};
        solve_task(own, plan.single[static_cast<std::size_t>(k)], {});
    });
    step.world.profile.solver_tasks = static_cast<int>(plan.single.size());
}

}  // namespace jostle::physics
