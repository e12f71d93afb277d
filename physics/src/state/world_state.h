// SPDX-License-Identifier: MIT
//
// The state of one world. Plain data: functions that maintain consistency between the stores are in
// this folder, the stages in stages/.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "jostle/physics/profile.h"
#include "physics/src/foundation/thread_pool.h"
#include "physics/src/foundation/threading_trial.h"
#include "physics/src/state/event_store.h"
#include "physics/src/state/graph_scratch.h"
#include "physics/src/state/listener_store.h"
#include "physics/src/state/wake_requests.h"
#include "physics/src/state/world_stores.h"

namespace jostle::physics {

// Thread usage of the last step. It affects the distribution of work in the next step, never its
// result.
struct ThreadUsage {
    double step_ms = 0;
    int solver_tasks = 0;
};

struct WorldState : WorldStores {
    // Modules are part of the state; a restore point stores theirs through their visitors.
    ListenerStore listeners;
    // Not part of the state.
    EventStore events;
    WakeRequests wake_requests;
    std::uint64_t static_revision = 0;  // World::static_revision()
    StepProfile profile;
    // Composite pairs of which a child began or ended to touch; merge_islands reports them.
    std::vector<std::uint32_t> changed_pairs;
    GraphScratch scratch;
    std::unique_ptr<ThreadPool> thread_pool;
    ThreadingTrial threading_trial;
    ThreadUsage thread_usage;
};

}  // namespace jostle::physics
