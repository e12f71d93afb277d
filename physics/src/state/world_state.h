// SPDX-License-Identifier: MIT
//
// The state of one world. Plain data: functions that maintain consistency between the stores are in
// this folder, the stages in stages/.
#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <vector>

#include "jostle/physics/profile.h"
#include "physics/src/foundation/thread_choice.h"
#include "physics/src/foundation/thread_pool.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/state/event_store.h"
#include "physics/src/state/listener_store.h"
#include "physics/src/state/world_stores.h"

namespace jostle::physics {

// Wake requests. Stages file them; they are applied at two points of the step in order of bodies,
// so that the result does not depend on the order of discovery (stages/sleep/wake_bodies.cpp). Not
// part of the state: empty after a step.
struct WakeRequest {
    std::uint32_t body = 0xffffffff;  // a body that sleeps, with its island or in place
    double mass = 0;                  // kg of its surroundings that wake with it
    // Only its load changed: it soon sleeps again if it still rests.
    bool briefly = false;
    auto operator<=>(const WakeRequest&) const = default;
};
using WakeRequests = std::vector<WakeRequest>;

// Returns the mass that a momentum in kg m/s would move at the speed gentle_speed, kg.
inline double mass_to_wake(double momentum) {
    return momentum / tuning::gentle_speed;
}

// Thread usage of the last step. It affects the distribution of work in the next step, never its
// result.
struct ThreadUsage {
    std::int64_t work = 0;  // StepProfile::work
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
    ThreadChoice thread_choice;
    ThreadUsage thread_usage;
};

}  // namespace jostle::physics
