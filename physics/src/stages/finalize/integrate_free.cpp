// SPDX-License-Identifier: MIT
#include "physics/src/stages/stages.h"

#include <algorithm>
#include <span>

#include "jostle/base/check.h"
#include "physics/src/foundation/tuning.h"

#include "physics/src/constraints/free_motion.h"
#include "physics/src/stages/finalize/finalize_body.h"
#include "physics/src/stages/solver/substep_hooks.h"
#include "physics/src/stages/step_scratch.h"
#include "physics/src/state/force_fields.h"

namespace jostle::physics {
namespace {

// ---- by sub-steps: bodies with listeners or force fields ----

// One sub-step. Fields act at the body's position in the middle of the sub-step, which is
// second-order and conserves the energy of a conservative field (position Verlet: Hairer, Lubich,
// Wanner, "Geometric numerical integration by the Stormer-Verlet method", 2003).
void advance(const WorldState& world, const SubstepInfo& substep_info, BodyWarm& now) {
    const BodyCold& cold = world.bodies.cold[now.body];
    const Vec3 force = now.force, torque = now.torque;
    if (!world.fields.empty()) {
        BodyWarm middle = now;
        middle.center += now.v * (0.5 * substep_info.h);
        const double time = world.time + substep_info.index * substep_info.h;
        const FieldPush push = field_push(world, middle, cold, time, substep_info.h);
        now.force += push.force;
        now.torque += push.torque;
    }
    const FreeMotion motion = free_motion(now, cold, world.def.gravity, substep_info.h);
    now.center += motion.displacement;
    now.rotation = motion.rotation;
    now.axes = to_matrix(now.rotation);
    now.v = motion.v;
    now.w = motion.w;
    now.force = force;
    now.torque = torque;
}

// Listeners before a sub-step also apply impulses at the bodies' midpoint positions. free_motion()
// then starts at a point from which the new velocity passes through the midpoint.
void listen_to(StepContext& step, const SubstepInfo& substep_info,
               std::span<const std::uint32_t> awake, std::span<BodyWarm> moving, std::size_t first,
               ListenedGroup& group) {
    const auto call = [&] {
        call_listeners(step, substep_info, awake, moving, static_cast<std::uint32_t>(first), group);
    };
    if (substep_info.after) return call();
    for (BodyWarm& now : moving) now.center += now.v * (0.5 * substep_info.h);
    call();
    for (BodyWarm& now : moving) now.center -= now.v * (0.5 * substep_info.h);
}

// Calls listeners for all bodies together or in chunks concurrently. The chunks depend only on the
// awake set.
void listen(StepContext& step, const SubstepInfo& substep_info,
            std::span<const std::uint32_t> awake, std::span<BodyWarm> moving) {
    const std::size_t chunk =
        listens_at_once(step.world.listeners) ? std::size_t{tuning::listened_chunk} : moving.size();
    const std::size_t chunks = (moving.size() + chunk - 1) / chunk;
    auto& groups = step.scratch.solver.listened_free;
    if (groups.size() < chunks) groups.resize(chunks);
    step.thread_pool.run_tasks(static_cast<int>(chunks), [&](int number) {
        const auto k = static_cast<std::size_t>(number);
        const std::size_t first = k * chunk, count = std::min(chunk, moving.size() - first);
        listen_to(step, substep_info, awake.subspan(first, count), moving.subspan(first, count),
                  first, groups[k]);
    });
}

// Integrates dynamic free bodies by sub-steps. Kinematic ones are appended to `others`.
void integrate_by_substeps(StepContext& step, std::vector<std::uint32_t>& others) {
    WorldState& world = step.world;
    SolverScratch& solver = step.scratch.solver;
    FinalizeScratch& scratch = step.scratch.finalize;
    std::vector<BodyWarm>& moving = scratch.moving;
    std::vector<std::uint32_t>& awake = scratch.moving_awake;
    moving.clear();
    awake.clear();
    solver.free_index.assign(world.bodies.awake.size(), none);
    for (const std::uint32_t i : solver.free) {
        if (!is_dynamic(world.bodies, world.bodies.awake[i].body)) {
            others.push_back(i);
            continue;
        }
        ASSERT(world.bodies.cold[world.bodies.awake[i].body].constraints == 0);
        solver.free_index[i] = static_cast<std::uint32_t>(awake.size());
        awake.push_back(i);
        moving.push_back(world.bodies.awake[i]);
    }
    if (awake.empty()) return;
    const int count = world.def.substeps;
    const bool listened = has_substep_listeners(world.listeners);
    for (int n = 0; n < count; n++) {
        SubstepInfo substep_info{n, count, step.dt / count};
        if (listened) listen(step, substep_info, awake, moving);
        step.thread_pool.run(
            static_cast<int>(moving.size()), tuning::body_grain, [&](int begin, int end) {
                for (int k = begin; k < end; k++)
                    advance(world, substep_info, moving[static_cast<std::size_t>(k)]);
            });
        substep_info.after = true;
        if (listened) listen(step, substep_info, awake, moving);
    }
    step.thread_pool.run(
        static_cast<int>(moving.size()), tuning::body_grain, [&](int begin, int end) {
            for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); k++) {
                const BodyWarm& now = moving[k];
                const Vec3 displacement = now.center - world.bodies.awake[awake[k]].center;
                finalize_body(step, awake[k], {displacement, now.rotation, now.v, now.w});
            }
        });
}

}  // namespace

Skipped integrate_free(StepContext& step) {
    if (step.world.bodies.awake.empty()) return no_awake_bodies;
    WorldState& world = step.world;
    // Each awake body is free, in the solver, in a joint group, or asleep in place.
    const JointGroupScratch& groups = step.scratch.solver.groups;
    ASSERT(step.scratch.solver.free.size() + step.scratch.solver.bodies.all.size() +
               groups.awake.size() + world.bodies.asleep_in_place ==
           world.bodies.awake.size());
    begin_finalize(world.bodies, step.scratch.contacts.bouncing, !world.shapes.triggers.empty(),
                   step.scratch.finalize);
    for (std::size_t k = 0; k < groups.awake.size(); k++)
        finalize_body(step, groups.awake[k], groups.motions[k]);
    std::vector<std::uint32_t> others;
    const bool by_substeps = has_substep_listeners(world.listeners) || !world.fields.empty();
    if (by_substeps) integrate_by_substeps(step, others);
    const std::vector<std::uint32_t>& free = by_substeps ? others : step.scratch.solver.free;
    step.thread_pool.run(
        static_cast<int>(free.size()), tuning::body_grain, [&](int begin, int end) {
            for (int k = begin; k < end; k++) {
                const std::uint32_t i = free[static_cast<std::size_t>(k)];
                ASSERT(i < world.bodies.awake.size());
                const BodyWarm& warm = world.bodies.awake[i];
                finalize_body(
                    step, i,
                    free_motion(warm, world.bodies.cold[warm.body], world.def.gravity, step.dt));
            }
        });
    return ran;
}

}  // namespace jostle::physics
