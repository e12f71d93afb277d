// SPDX-License-Identifier: MIT
#include "physics/src/stages/solver/solve_joints.h"

#include "physics/src/constraints/joints/write_joint.h"
#include "physics/src/constraints/kernels.h"
#include "physics/src/stages/step_scratch.h"

namespace jostle::physics {
namespace {

// Calls visit(view) for every batch, on any thread.
template <class Visit>
void each_batch(StepContext& step, const JointTask& task, Visit&& visit) {
    const auto batches = task.batches.batches();
    if (batches.empty()) return;
    step.thread_pool.run(static_cast<int>(batches.size()), 1, [&](int begin, int end) {
        for (int k = begin; k < end; k++)
            visit(view_of(batches[static_cast<std::size_t>(k)], task.levels));
    });
}

}  // namespace

void find_joint_batches(StepContext& step, const JointTask& task) {
    const WorldState& world = step.world;
    JointLevels& levels = task.levels;
    std::vector<std::uint8_t>& is_point = task.batches.is_point;
    is_point.resize(levels.joints.size());
    std::vector<JointSolverPreferences>& preferences = task.batches.preferences;
    preferences.resize(levels.joints.size());
    const SolverBodies& hot = step.scratch.solver.hot;
    const auto is_locked = [&](std::int32_t body) {
        if (body <= 0) return false;
        const SolverBody& of = hot[static_cast<std::size_t>(body)];
        return of.free_x == 0 || of.free_y == 0 || of.free_z == 0;
    };
    std::vector<std::uint8_t>& locked = task.batches.locked;
    locked.resize(levels.joints.size());
    for (std::size_t k = 0; k < is_point.size(); k++) {
        const Joint& joint = world.joints.joints[levels.joints[k].joint];
        is_point[k] = holds_point(joint.kind) ? 1 : 0;
        preferences[k] = preference_bit(joint.solver);
        locked[k] = is_locked(levels.joints[k].a) || is_locked(levels.joints[k].b) ? 1 : 0;
    }
    const JointSolver of_world = world.def.joint_solver;
    find_batches(task.batches, levels, is_point, step.scratch.solver.hot.size(),
                 {preferences, of_world, direct_budget(world.joints.ids.alive_count()), locked});
    task.batches.refused = 0;
    for (std::size_t k = 0; k < preferences.size(); k++)
        if (solver_of(preferences[k], of_world) == JointSolver::direct &&
            task.batches.found[k] == 0)
            task.batches.refused++;
}

void load_joint_batches(StepContext& step, const JointTask& task, double h) {
    for (JointBatch& batch : task.batches.batches()) {
        load_batch(batch, task.levels);
        kernels().factor_batch(view_of(batch, task.levels), step.scratch.solver.hot.data(),
                               joint_step(h));
    }
}

void solve_joint_batches(StepContext& step, const JointTask& task, double h, bool again) {
    const JointStep numbers = joint_step(h);
    const BatchKernel solve = again ? kernels().solve_batch_again : kernels().solve_batch;
    each_batch(step, task, [&](const BatchView& batch) {
        solve(batch, step.scratch.solver.hot.data(), numbers);
    });
}

void relax_joint_batches(StepContext& step, const JointTask& task, double h) {
    const JointStep numbers = joint_step(h);
    each_batch(step, task, [&](const BatchView& batch) {
        kernels().factor_batch(batch, step.scratch.solver.hot.data(), numbers);
        kernels().relax_batch(batch, step.scratch.solver.hot.data(), numbers);
    });
}

}  // namespace jostle::physics
