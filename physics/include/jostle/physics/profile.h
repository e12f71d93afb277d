// SPDX-License-Identifier: MIT
//
// Cost and counters of the last step, sub-steps and error per island, and the use of threads. Times
// are wall-clock times and vary between runs. Counters are exact and reproducible.
#pragma once

#include <array>
#include <cstdint>

#include "jostle/physics/ids.h"

namespace jostle::physics {

/// The stages of a step in execution order. wake_bodies and solve_continuous run in two parts;
/// their second parts run one after the other, before quarantine.
enum class Stage {
    update_pairs,       ///< broad phase: finds new collider pairs
    update_contacts,    ///< narrow phase: updates manifolds
    wake_bodies,        ///< wakes disturbed bodies
    begin_contacts,     ///< adds new manifolds to the solver
    prepare_islands,    ///< chooses the sub-steps of each island
    solve_constraints,  ///< solves contacts and joints in sub-steps
    merge_islands,      ///< merges islands that started to touch
    integrate_free,     ///< moves bodies without contacts and joints
    finalize,           ///< updates poses, bounding boxes and rest times
    solve_continuous,   ///< sweeps fast bodies
    quarantine,         ///< resets bodies whose state diverged
    update_sleep,       ///< splits islands and puts them to sleep
    update_triggers,    ///< finds the shapes inside triggers
    publish_events,     ///< collects and sorts the events
};
/// Number of stages.
inline constexpr int stage_count = 14;

/// Returns the name of the enumerator. The string has static storage duration.
const char* stage_name(Stage stage);

/// Profile of one step (World::profile).
struct StepProfile {
    /// Wall-clock time per stage, ms; 0 if the stage was skipped.
    std::array<double, stage_count> stage_ms{};
    /// Reason for which a stage was skipped, as a sentence; null if it ran. Static storage
    /// duration.
    std::array<const char*, stage_count> stage_skipped{};
    double step_ms = 0;  ///< sum of stage_ms, ms
    /// The slowest stage and its time in ms.
    Stage worst_stage = Stage::update_pairs;
    double worst_stage_ms = 0;
    int bodies_awake = 0;  ///< awake dynamic bodies and all kinematic bodies
    /// Bodies that sleep in place: in an island of which other bodies are awake. Not included in
    /// bodies_awake.
    int bodies_asleep_in_place = 0;
    /// Part of bodies_awake: dynamic bodies with a manifold or a joint. All others are integrated
    /// without the solver.
    int bodies_in_solver = 0;
    /// Part of bodies_in_solver: in flat and slow islands, with half the sub-steps.
    int bodies_flat = 0;
    int bodies_tall = 0;  ///< part of bodies_in_solver: in tall islands, with twice the sub-steps
    /// Part of bodies_in_solver: in heavily loaded islands, with four times the sub-steps.
    int bodies_heavy = 0;
    /// Part of bodies_in_solver: in small islands of very different masses, whose contacts are
    /// solved together.
    int bodies_direct = 0;
    /// Passes over the groups of bodies_direct, two per sub-step, and those that missed their
    /// tolerance.
    int direct_passes = 0, direct_passes_unsolved = 0;
    std::int64_t direct_work = 0;  ///< their work, in products of 6 x 6 blocks
    /// Tracked pairs of shapes, awake or asleep. A pair with a mesh, a height field or a compound
    /// counts once more for each of its manifolds.
    int pairs = 0;
    /// New pairs beyond WorldDef::max_pairs_per_shape; most count twice, once for each shape.
    int pairs_skipped = 0;
    int pairs_checked = 0;  ///< narrow-phase tests
    /// Part of pairs_checked: with a mesh, a height field or a compound.
    int composites_checked = 0;
    int manifolds = 0;  ///< manifolds, except those of sleeping islands
    int touching = 0;   ///< part of manifolds: those that touch
    int islands_awake = 0;
    int joints = 0;          ///< solved joints of bodies_in_solver
    int joints_direct = 0;   ///< part of joints: solved directly, in groups without contacts
    int joints_batched = 0;  ///< part of joints: points solved directly, with contacts
    /// Part of joints: those that requested JointSolver::direct but were solved iteratively.
    int joints_direct_fallback = 0;
    /// Sub-steps of directly solved groups: energy-momentum steps, because the joint forces
    /// oscillate too fast for h or the energy changed; halved steps; and first-order steps as the
    /// last resort.
    int joint_energy_steps = 0, joint_halvings = 0, joint_last_resorts = 0;
    std::int64_t body_substeps = 0;  ///< sub-steps, summed over bodies_in_solver
    /// Additional body sub-steps that measured the error, in a world with a tolerance.
    std::int64_t trial_substeps = 0;
    /// Solved contacts and joints, each multiplied by its sub-steps.
    std::int64_t contact_substeps = 0, joint_substeps = 0;
    /// Continuous collision tests of one fast body.
    int sweeps = 0;
    /// Part of sweeps: after the first impact of the step. After 2048 of them and 2 for each awake
    /// body, impacts between dynamic bodies are left to the contact solver, as on overload level 2;
    /// after 16384 and 16 if some bodies may bounce.
    int sweeps_after_impacts = 0;
    int impacts = 0;  ///< impacts handled by the continuous stage
    /// Work of the step in units of about 0.1 us of one current core. Estimated from counters
    /// (within a factor of 0.6 to 2 of the time in the benchmark scenes), so it is the same for any
    /// machine and any number of threads. See WorldDef::step_budget.
    std::int64_t work = 0;
    std::int64_t module_work = 0;  ///< part of `work`: counted by modules (World::count_work)
    int overload_level = 0;        ///< level at which the step was computed (World::overload_level)
    int solver_tasks = 0;  ///< Solver batches that threads solved in parallel; 0 with one thread.
};

/// Sub-steps and error of one awake island whose bodies have contacts or joints.
struct IslandSubsteps {
    BodyId body;  ///< the body of the island with the lowest id
    /// Counts of bodies, touching manifolds and joints.
    int bodies = 0, contacts = 0, joints = 0;
    bool direct = false;      ///< its joints were solved directly, because nothing touches it
    int substeps = 0;         ///< sub-steps in the next step, unless the island changes before
    int target_substeps = 0;  ///< larger than `substeps` only if the sub-step budget is exhausted
    /// Estimated error in m: distance between the island's bodies and the converged solution after
    /// one second of steps like the last measured one. 0 if unknown, as in a world without a
    /// tolerance.
    double error = 0;
};

/// If on, all threads of a world take part in every step, however short. The results of a step
/// never depend on the threads that take part; tests of that property use this. Process-wide, off
/// by default, thread-safe.
void share_short_steps(bool on);

}  // namespace jostle::physics
