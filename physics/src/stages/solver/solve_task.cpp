// SPDX-License-Identifier: MIT
#include "physics/src/stages/solver/solve_task.h"

#include <algorithm>
#include <span>
#include <vector>

#include "jostle/base/check.h"
#include "physics/src/constraint_graph/wide_rows.h"
#include "physics/src/constraints/contact_passes.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/solver/apply_joint_impacts.h"
#include "physics/src/stages/solver/contact_groups.h"
#include "physics/src/stages/solver/error_trial.h"
#include "physics/src/stages/solver/gather_bodies.h"
#include "physics/src/stages/solver/hold_limits.h"
#include "physics/src/stages/solver/integrate_gyroscopic.h"
#include "physics/src/stages/solver/solve_joints.h"
#include "physics/src/stages/solver/substep_hooks.h"
#include "physics/src/stages/step_scratch.h"

namespace jostle::physics {
namespace {

// Distributes the dynamic bodies of a task, by hot index, over the threads.
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
    // One group per set, regardless of how many sets this thread solves together.
    const std::size_t together = listens_at_once(step.world.listeners) ? 1 : task.last - task.first;
    for (std::size_t k = task.first; k < task.last; k += together)
        if (!bodies.of(k, k + together).empty())
            call_listeners(step, substep_info, bodies.of(k, k + together), k, k + together);
}

// The contact passes of the sub-steps: by sweeps, or group by group. A group without a solution
// gets a sweep.
class ContactPasses {
public:
    ContactPasses(const ContactTask& contacts, ContactGroups* groups)
        : contacts_(contacts), groups_(groups) {}

    // Later sub-steps are warm-started by accelerate(). Groups need no warm start.
    bool warm_starts() const { return groups_ == nullptr; }
    void begin() const {
        if (groups_ == nullptr) warm_start(contacts_);
    }
    void solve() const {
        if (groups_ == nullptr) return physics::solve(contacts_);
        bool solved = true;
        for (ContactGroup& group : groups_->groups()) solved &= count(group.solve(contacts_.set));
        if (solved) return;
        physics::solve(contacts_);
        store();
    }
    void relax(bool last) const {
        if (groups_ == nullptr) return physics::relax(contacts_, last);
        bool solved = true;
        for (ContactGroup& group : groups_->groups()) solved &= count(group.relax(contacts_.set));
        // The pass that ends the step also measures gaps and ages of the manifolds.
        if (solved && !last) return;
        physics::relax(contacts_, last);
        store();
    }

private:
    bool count(bool solved) const {
        groups_->passes++;
        groups_->unsolved += solved ? 0 : 1;
        return solved;
    }
    // Restores the groups that were solved after sweeps over all contacts.
    void store() const {
        for (const ContactGroup& group : groups_->groups()) group.store();
    }

    const ContactTask& contacts_;
    ContactGroups* groups_;  // null: by sweeps
};

void run_substeps(StepContext& step, const SolverTask& task, const ContactSettings& set,
                  const JointTask& joints, std::span<const std::uint32_t> kinematic,
                  ContactGroups* groups) {
    SolverScratch& scratch = step.scratch.solver;
    ASSERT(set.substeps >= 1);
    const double h = step.dt / set.substeps;
    const ContactTask contacts{scratch.colour_runs[task.first], scratch.hot.data(), set,
                               step.thread_pool};
    const ContactPasses passes(contacts, groups);
    const Kernels& kernel = kernels();
    if (!scratch.jointed.of(task.first, task.last).empty())
        apply_joint_impacts(step, contacts.runs);
    const bool bounces = begin_restitution(contacts);
    const bool listened = has_substep_listeners(step.world.listeners);
    const std::vector<std::uint32_t>& in_fields = scratch.in_fields[task.first];
    GyroscopicBodies& gyroscopic = scratch.gyroscopic[task.first];
    for (int n = 0; n < set.substeps; n++) {
        const bool first = n == 0, last = n + 1 == set.substeps;
        if (!first && is_stopped(step)) break;
        SubstepInfo substep_info{n, set.substeps, h};
        if (listened) listen(step, substep_info, task);
        if (!in_fields.empty()) push_by_fields(step, substep_info, in_fields);
        each_body(step, task, [&](std::span<const std::uint32_t> some) {
            (first || !passes.warm_starts() ? kernel.accelerate_first
                                            : kernel.accelerate)(range_of(scratch, some));
        });
        if (first && bounces) predict_approaches(contacts);
        if (first) passes.begin();
        solve_joints(step, joints, h);
        solve_joint_batches(step, joints, h, false);
        passes.solve();
        begin_gyroscopic(step, gyroscopic, h);
        solve_joint_batches(step, joints, h, true);
        hold_limited_groups(step, joints, h);
        end_gyroscopic(step, gyroscopic, h);
        each_body(step, task, [&](std::span<const std::uint32_t> some) {
            kernel.advance(range_of(scratch, some), set.h);
        });
        kernel.advance(range_of(scratch, kinematic), set.h);
        relax_joints(step, joints, h);
        passes.relax(last);
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
            scratch.limited[task.first], scratch.jointed.of(task.first, task.last)};
}

// Prepares and runs all sub-steps. Afterwards bodies, contacts and joints have their final values,
// except those that finish_joints() writes.
void solve_with(StepContext& step, const SolverTask& task, const ContactSettings& set,
                std::span<const std::uint32_t> kinematic) {
    WorldState& world = step.world;
    SolverScratch& scratch = step.scratch.solver;
    const double h = step.dt / set.substeps;
    each_body(step, task, [&](std::span<const std::uint32_t> bodies) {
        for (const std::uint32_t hot : bodies) prepare_body(step, h, hot);
    });
    for (const std::uint32_t hot : kinematic) prepare_body(step, 0, hot);
    find_gyroscopic(step, scratch.bodies.of(task.first, task.last), scratch.gyroscopic[task.first]);
    scratch.in_fields[task.first].clear();
    if (!world.fields.empty())
        find_in_fields(step, scratch.bodies.of(task.first, task.last),
                       scratch.in_fields[task.first]);
    const JointTask joints = joints_of(step, task);
    prepare_joints(step, joints, h);
    find_limited_groups(step, joints);
    std::vector<ColourRun>& colours = scratch.colour_runs[task.first];
    list_runs(world.graph, task.first, task.last, colours);
    // If threads share neither colours nor levels, sharing the passes over bodies would only move
    // records from one cache to another and back.
    const bool shared =
        shares_levels(joints) || std::any_of(colours.begin(), colours.end(),
                                             [](const ColourRun& run) { return run.shared; });
    ThreadPool alone(1);
    StepContext substeps{world, step.scratch, shared ? step.thread_pool : alone, step.dt,
                         step.contacts};
    const bool direct = task.tier == SolverTier::direct;
    if (direct)
        find_contact_groups(step, scratch.bodies.of(task.first, task.last),
                            scratch.contact_groups[task.first]);
    run_substeps(substeps, task, set, joints, kinematic,
                 direct ? &scratch.contact_groups[task.first] : nullptr);
}

}  // namespace

void solve_task(StepContext& step, const SolverTask& task,
                std::span<const std::uint32_t> kinematic) {
    const ContactSettings& set = step.contacts[task.first];
    const SolverScratch& scratch = step.scratch.solver;
    const auto bodies = scratch.bodies.of(task.first, task.last),
               jointed = scratch.jointed.of(task.first, task.last);
    const bool twice = wants_trial(step, task.first);
    if (twice) {
        ContactSettings coarse =
            contact_settings(step.dt, set.substeps / 2, task.tier,
                             {stiffness_dt_of(step.world, step.dt), set.substeps});
        coarse.planar = set.planar;
        coarse.gravity_ratio = set.gravity_ratio;
        coarse.restitution_speed = set.restitution_speed;
        begin_trial(step, task.first, task.last, jointed);
        solve_with(step, task, coarse, kinematic);
        end_trial(step, task.first, task.last, bodies, jointed);
    }
    solve_with(step, task, set, kinematic);
    if (twice) compare_trial(step, task.first, task.last, bodies);
    finish_joints(step, joints_of(step, task));
}

}  // namespace jostle::physics
