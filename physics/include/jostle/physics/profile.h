// SPDX-License-Identifier: MIT
//
// What the last step cost and did. Times are of the wall clock and differ from run to run; counters
// are exact.
#pragma once

#include <array>
#include <cstdint>

namespace jostle::physics {

enum class Stage {
    update_pairs,
    update_contacts,
    wake_bodies,
    begin_contacts,
    prepare_islands,
    merge_islands,
    solve_constraints,
    integrate_free,
    finalize,
    solve_continuous,
    quarantine,
    update_sleep,
    update_triggers,
    publish_events,
};
inline constexpr int stage_count = 14;

// The stage's name as in the enumeration.
const char* stage_name(Stage stage);

struct StepProfile {
    std::array<double, stage_count> stage_ms{};  // 0 when the stage was skipped
    // Why a stage was skipped, as a sentence; null when it ran. Lives as long as the program.
    std::array<const char*, stage_count> stage_skipped{};
    double step_ms = 0;  // the sum of stage_ms
    // The stage that took most of it, and how long that took.
    Stage worst_stage = Stage::update_pairs;
    double worst_stage_ms = 0;
    int bodies_awake = 0;  // dynamic bodies that are awake, and all kinematic ones
    // Bodies that sleep in an island that moves elsewhere. Not among bodies_awake.
    int bodies_asleep_in_place = 0;
    // Of bodies_awake: dynamic bodies with a manifold or a joint. All others are moved without the
    // solver.
    int bodies_in_solver = 0;
    int bodies_flat = 0;   // of bodies_in_solver: in flat and slow islands, half the sub-steps
    int bodies_tall = 0;   // ... in tall islands, twice the sub-steps
    int bodies_heavy = 0;  // ... in islands with a heavy load, four times the sub-steps
    // Pairs of shapes that are followed, awake or asleep; a pair with a mesh, a height field or a
    // compound counts once more for each of its manifolds.
    int pairs = 0;
    int pairs_checked = 0;       // narrow phase calls
    int composites_checked = 0;  // of those: with a mesh, a height field or a compound
    int manifolds = 0;           // that exist, but for those of sleeping islands
    int touching = 0;            // of manifolds: the ones that press
    int islands_awake = 0;
    int joints = 0;          // that were solved: of bodies_in_solver
    int joints_direct = 0;   // of joints: solved at once, in groups that nothing touches
    int joints_batched = 0;  // of joints: their points are solved at once, beside contacts
    // Of joints: JointSolver::direct was asked for, and they are neither of the two.
    int joints_direct_fallback = 0;
    std::int64_t body_substeps = 0;  // sub-steps of bodies_in_solver, summed
    // ... that were taken beside, to measure errors, in a world with a tolerance.
    std::int64_t trial_substeps = 0;
    // Contacts and joints that were solved, each times its sub-steps.
    std::int64_t contact_substeps = 0, joint_substeps = 0;
    int sweeps = 0;   // looks of a fast body at what it may meet on its way, between steps
    int impacts = 0;  // that were followed between steps
    // What the step did, in units of about 0.1 microseconds of one current core: only about that
    // (.6 to 2 times in the scenes of the laboratory), but counted, so the same for any machine and
    // any number of threads. WorldDef::step_budget.
    std::int64_t work = 0;
    int overload_level = 0;  // at which the step was taken: World::strain()
    int solver_tasks = 0;  // batches of islands that threads solved side by side; 0 with one thread
};

}  // namespace jostle::physics
