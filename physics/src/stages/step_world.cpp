// SPDX-License-Identifier: MIT
#include "physics/src/stages/step_world.h"

#include <utility>

#include "jostle/base/check.h"
#include "physics/src/foundation/size_scale.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/continuous/solve_continuous.h"
#include "physics/src/stages/stages.h"
#include "physics/src/stages/step_scratch.h"
#include "physics/src/state/impulse_scale.h"
#include "physics/src/state/shape_proxy.h"

namespace jostle::physics {
namespace {

// Contacts are softer at once if the step becomes longer, and stiffer only gradually if it becomes
// shorter, unless all bodies sleep: the contacts of a body that wakes start at the new stiffness.
void update_stiffness(WorldState& world, double dt) {
    const double last = stiffness_dt_of(world, world.last_dt),
                 next = last - (last - dt) * (1.0 / tuning::stiffening_steps);
    constexpr double equal = 1.01;
    const bool gradual = next > equal * dt && !world.bodies.awake.empty();
    world.stiffness_dt = gradual ? next : 0;
}

StepContext begin_step(WorldState& world, StepScratch& scratch, double dt) {
    world.events.begin_step();
    world.thread_pool->set_single_threaded(
        !world.thread_choice.shares_step(world.thread_usage.work));
    if (world.thread_usage.solver_tasks > 1) world.thread_pool->wake();
    world.profile = {};
    world.profile.overload_level = world.overload_level.level;
    world.profile.module_work = std::exchange(world.listeners.work, 0);
    if (dt != world.last_dt)
        for (const BodyWarm& warm : world.bodies.awake) update_motion_bound(world, warm.body, dt);
    if (dt != world.last_dt && world.last_dt > 0)
        change_step_length(world, world.joints, step_length_change(world, dt));
    update_stiffness(world, dt);
    world.last_dt = dt;
    return {world, scratch, *world.thread_pool, dt, {}};
}

// Reuses manifolds over larger motions, at any speed.
void reuse_longer(ContactSettings& set) {
    set.rebuild_drift *= tuning::overload_drift;
    set.rebuild_motion = set.single_rebuild_motion = tuning::any_motion;
}

// Skipped while all bodies sleep.
void set_contact_settings(StepContext& step) {
    const WorldState& world = step.world;
    if (world.bodies.awake.empty()) return;
    const auto gravity_ratio =
        static_cast<float>(square_root(gravity_ratio_squared(world.def.gravity)));
    const auto restitution_speed = static_cast<float>(bounce_speed(world.def.gravity, step.dt));
    for (const SolverTier tier : all_tiers)
        for (std::uint8_t batch = 0; batch < batch_count; batch++) {
            const ColourSetKey key{tier, batch};
            ContactSettings& set = step.contacts[index_of(key)];
            if (batch > 0 && !batches_differ(world)) {
                set = step.contacts[index_of(key) - 1];
                continue;
            }
            const int substeps = substeps_of(key, world);
            set = contact_settings(step.dt, substeps, tier,
                                   {stiffness_dt_of(world, step.dt), substeps});
            if (reuses_manifolds_longer(world.overload_level)) reuse_longer(set);
            set.planar = world.def.planar;
            set.gravity_ratio = gravity_ratio;
            set.restitution_speed = restitution_speed;
        }
}

// Records the time of one stage in the profile, or why it was skipped. A skipped stage reads no
// clock.
template <Skipped (*kStage)(StepContext&)>
void run(StepContext& step, Stage name) {
    StepProfile& profile = step.world.profile;
    ASSERT(step.stages_run == static_cast<int>(name));  // the order of Stage
    step.stages_run++;
    const auto index = static_cast<std::size_t>(name);
    profile.stage_skipped[index] = kStage(step);
    if (profile.stage_skipped[index] == ran) profile.stage_ms[index] = step.timer.lap_ms();
}

// The same for the second part of a stage: both parts are skipped, or the stage ran.
template <Skipped (*kStage)(StepContext&)>
void run_second(StepContext& step, Stage name) {
    StepProfile& profile = step.world.profile;
    ASSERT(step.stages_run > static_cast<int>(name));
    const auto index = static_cast<std::size_t>(name);
    if (kStage(step) != ran) return;
    profile.stage_skipped[index] = ran;
    profile.stage_ms[index] += step.timer.lap_ms();
}

void add_up_times(StepProfile& profile) {
    for (std::size_t k = 0; k < profile.stage_ms.size(); k++) {
        profile.step_ms += profile.stage_ms[k];
        if (profile.stage_ms[k] <= profile.worst_stage_ms) continue;
        profile.worst_stage = static_cast<Stage>(k);
        profile.worst_stage_ms = profile.stage_ms[k];
    }
}

}  // namespace

// One step, in execution order. Each stage is one file of this folder.
void step_world(WorldState& world, StepScratch& scratch, double dt) {
    ASSERT(dt > 0);
    StepContext step = begin_step(world, scratch, dt);
    const bool asleep = world.bodies.awake.empty();
    set_contact_settings(step);
    run<update_pairs>(step, Stage::update_pairs);        // shapes that may touch
    run<update_contacts>(step, Stage::update_contacts);  // contact points
    run<wake_before_solve>(step, Stage::wake_bodies);    // disturbed bodies
    if (asleep) set_contact_settings(step);              // bodies were woken
    run<begin_contacts>(step, Stage::begin_contacts);    // adds new manifolds
    const bool by_size = world.size_levels;
    run<prepare_islands>(step, Stage::prepare_islands);  // sub-steps by island
    if (world.size_levels != by_size) set_contact_settings(step);
    run<solve_constraints>(step, Stage::solve_constraints);      // sub-steps of all touching bodies
    run<merge_islands>(step, Stage::merge_islands);              // connected bodies
    run<integrate_free>(step, Stage::integrate_free);            // bodies without contacts
    run<finalize>(step, Stage::finalize);                        // poses, bounds, rest time
    run<solve_continuous>(step, Stage::solve_continuous);        // prevents tunnelling
    run_second<wake_after_impacts>(step, Stage::wake_bodies);    // sleeping bodies that were hit
    run_second<move_toi_bodies>(step, Stage::solve_continuous);  // deflected bodies
    run<quarantine>(step, Stage::quarantine);                    // rejects non-finite states
    run<update_sleep>(step, Stage::update_sleep);  // removes resting islands from the awake set
    step.thread_pool.finish();                     // completes the work started by finalize
    run<update_triggers>(step, Stage::update_triggers);  // trigger overlaps
    run<publish_events>(step, Stage::publish_events);    // sorts events for readers
    ASSERT(step.stages_run == stage_count);
    ASSERT(world.wake_requests.empty());
    ASSERT(world.bodies.asleep_in_place <= world.bodies.awake.size());
    ASSERT(world.bodies.awake.size() + world.bodies.statics.size() <=
           world.bodies.ids.alive_count());
    ASSERT(scratch.contacts.begins.empty());
    update_step_budget(world);
    world.steps++;
    world.time += dt;
    add_up_times(world.profile);
    world.thread_usage = {world.profile.work, world.profile.solver_tasks};
}

}  // namespace jostle::physics
