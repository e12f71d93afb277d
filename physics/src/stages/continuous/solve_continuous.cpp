// SPDX-License-Identifier: MIT
#include "physics/src/stages/continuous/solve_continuous.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "jostle/base/check.h"
#include "physics/src/stages/continuous/bounce_events.h"
#include "physics/src/stages/continuous/find_impacts.h"
#include "physics/src/stages/continuous/impact_queue.h"
#include "physics/src/stages/continuous/project_joints.h"
#include "physics/src/stages/continuous/resolve_cluster.h"
#include "physics/src/stages/continuous/resolve_toi_impact.h"
#include "physics/src/stages/continuous/start_toi_bodies.h"
#include "physics/src/stages/continuous/toi_policy.h"
#include "physics/src/stages/continuous/toi_state.h"
#include "physics/src/stages/continuous/update_dependents.h"
#include "physics/src/stages/step_scratch.h"

namespace jostle::physics {
namespace {

void process_impact(ToiState& state, ImpactQueue& queue, std::size_t index) {
    if (state.any_bounces) {
        if (const std::optional<ResolvedCluster> cluster = resolve_cluster(state, index)) {
            for (const DeflectedBody& deflected : cluster->bodies)
                if (const auto on_new_path = continue_after(state, cluster->impact, deflected))
                    update_dependents(state, queue, *on_new_path);
            return;
        }
    }
    const std::optional<ResolvedImpact> impact = resolve_toi_impact(state, index);
    if (!impact) return;
    for (const DeflectedBody* deflected : {&impact->a, &impact->b})
        if (const auto on_new_path = continue_after(state, *impact, *deflected))
            update_dependents(state, queue, *on_new_path);
}

void process_leg_end(ToiState& state, ImpactQueue& queue, std::size_t index) {
    next_leg(state.world, state.bodies[index], state.step.dt);
    update_dependents(state, queue, index);
}

// Processes impacts and ends of legs in the order of their times. Terminates, because each impact
// uses up one of a body's impacts, and the number of legs between two impacts is limited.
void process_events(ToiState& state) {
    ImpactQueue queue;
    while (!is_stopped(state.step)) {
        find_impacts(state, queue);
        const std::optional<std::size_t> next = queue.next();
        if (!next) return;
        const ToiBody& t = state.bodies[*next];
        if (t.fraction <= t.sweep.until)
            process_impact(state, queue, *next);
        else
            process_leg_end(state, queue, *next);
    }
}

// move_toi_bodies places the deflected bodies, once the bodies that they hit are awake.
void leave_deflected(std::vector<ToiBody>& bodies, std::vector<ToiBody>& deflected) {
    for (ToiBody& t : bodies)
        if (t.changed) deflected.push_back(std::move(t));
}

}  // namespace

Skipped solve_continuous(StepContext& step) {
    std::vector<ToiBody>& deflected = step.scratch.continuous.changed;
    deflected.clear();
    if (step.world.bodies.awake.empty()) return no_awake_bodies;
    if (!step.world.def.continuous) return "continuous collision is off";
    if (step.scratch.finalize.any_fast == 0) return "no body moved further than half its thickness";
    ToiState state(step);
    find_ignored_pairs(state);
    start_toi_bodies(state);
    if (state.bodies.empty()) return ran;
    process_events(state);
    report_bounces(step.world.events, state.bounces);
    leave_deflected(state.bodies, deflected);
    return ran;
}

Skipped move_toi_bodies(StepContext& step) {
    const std::vector<ToiBody>& deflected = step.scratch.continuous.changed;
    if (deflected.empty()) return "no impact between steps";
    std::vector<std::uint32_t> bodies;
    for (const ToiBody& t : deflected) {
        ASSERT(t.changed);
        finish_toi(step.world, t, step.dt);
        bodies.push_back(t.body);
    }
    std::sort(bodies.begin(), bodies.end());
    project_joints(step, bodies);
    return ran;
}

}  // namespace jostle::physics
