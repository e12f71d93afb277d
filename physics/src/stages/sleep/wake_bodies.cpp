// SPDX-License-Identifier: MIT
#include "physics/src/stages/stages.h"

#include "physics/src/stages/sleep/put_parts_to_sleep.h"
#include "physics/src/state/wake.h"

namespace jostle::physics {
namespace {

Skipped wake_requested(WorldState& world) {
    if (world.wake_requests.empty()) return "no wake requests";
    apply_wake_requests(world, world.events.woke);
    return ran;
}

}  // namespace

Skipped wake_before_solve(StepContext& step) {
    request_disturbed_wakes(step);
    return wake_requested(step.world);
}

Skipped wake_after_impacts(StepContext& step) {
    return wake_requested(step.world);
}

}  // namespace jostle::physics
