// SPDX-License-Identifier: MIT
#include "physics/src/stages/stages.h"

#include <algorithm>

#include "jostle/base/check.h"
#include "physics/src/stages/solver/gather_bodies.h"
#include "physics/src/stages/solver/joint_groups.h"
#include "physics/src/stages/solver/schedule_tasks.h"
#include "physics/src/stages/solver/solve_joints.h"
#include "physics/src/stages/step_scratch.h"

namespace jostle::physics {
namespace {

void resize_records(const BodyStore& bodies, SolverScratch& scratch) {
    const std::size_t count = bodies.awake.size() + 1;
    scratch.hot.resize(count);
    scratch.external.resize(count);
    scratch.spin_axes.assign(count, SpinAxes::world);
    // Bodies that sleep in place do not move, and impulses cannot move them.
    if (bodies.asleep_in_place == 0) return;
    for (std::size_t i = 0; i < bodies.awake.size(); i++)
        if (bodies.cold[bodies.awake[i].body].asleep_in_place) scratch.hot[i + 1] = {};
}

void count_direct_passes(const std::vector<SolverTask>& tasks, WorldState& world,
                         SolverScratch& scratch) {
    StepProfile& profile = world.profile;
    for (const SolverTask& task : tasks) {
        if (task.tier != SolverTier::direct) continue;
        const ContactGroups& groups = scratch.contact_groups[task.first];
        for (std::size_t k = 0; k < groups.used; k++) {
            profile.direct_work += groups.all[k].work();
            if (groups.all[k].missed())
                scratch.unsolved.push_back(world.bodies.awake[groups.lowest[k] - 1].body);
        }
        profile.direct_passes += groups.passes;
        profile.direct_passes_unsolved += groups.unsolved;
    }
}

}  // namespace

Skipped solve_constraints(StepContext& step) {
    const BodyStore& bodies = step.world.bodies;
    if (bodies.awake.empty()) return no_awake_bodies;
    SolverScratch& scratch = step.scratch.solver;
    scratch.unsolved.clear();
    find_joint_groups(step);
    gather_bodies(step);
    count_solver_work(step);
    ASSERT(!scratch.bodies.all.empty() ||
           std::none_of(step.world.graph.solved().begin(), step.world.graph.solved().end(),
                        [](const ColourSet& set) { return set.contacts != 0; }));
    if (scratch.bodies.all.empty() && scratch.groups.active.empty())
        return "nothing touches and nothing is jointed";
    if (!scratch.bodies.all.empty()) {
        resize_records(bodies, scratch);
        scratch.limited_groups.resize(step.world.joints.joints.size());
        const std::vector<SolverTask> tasks = make_tasks(step);
        run_tasks(step, tasks);
        count_direct_passes(tasks, step.world, scratch);
    }
    solve_joint_groups(step);
    break_joints(step);
    return ran;
}

}  // namespace jostle::physics
