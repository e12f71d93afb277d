// SPDX-License-Identifier: MIT
//
// What the last step cost and did. Times are wall-clock and so differ from run to run; counters are
// exact.
#pragma once

#include <array>

namespace jostle::physics {

enum class Stage {
    update_pairs,
    update_contacts,
    wake_bodies,
    begin_contacts,
    prepare_islands,
    link_islands,
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
    double step_ms = 0;              // of all stages
    int bodies_awake = 0;            // dynamic and kinematic bodies that the step moved
    int bodies_asleep_in_place = 0;  // bodies at rest in islands that are awake elsewhere
    int bodies_in_solver = 0;        // of those, the ones with a manifold; the others fly free
    int bodies_flat = 0;    // of those, the ones in flat and slow islands: half the sub-steps
    int bodies_tall = 0;    // ... in tall islands: twice the sub-steps
    int bodies_heavy = 0;   // ... and in islands with a heavy load: four times the sub-steps
    int pairs = 0;          // shapes whose fat boxes overlap
    int pairs_checked = 0;  // narrow phase calls
    int manifolds = 0;      // awake, in the constraint graph
    int touching = 0;       // of those, the ones that press
    int islands_awake = 0;
    int joints = 0;        // of awake bodies
    int solver_tasks = 0;  // batches of islands that threads solved side by side; 0 with one thread
};

}  // namespace jostle::physics
