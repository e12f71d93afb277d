// SPDX-License-Identifier: MIT
//
// What finalize_body finds out about each awake body, for finalize, solve_continuous and
// quarantine. Bodies that wake later in the step have no place here.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "physics/src/collision/broadphase/broad_phase_index.h"
#include "physics/src/state/body_store.h"

namespace jostle::physics {

struct FinalizeScratch {
    // By awake body: flags.
    std::vector<std::uint8_t> left_fat_aabb;        // some shape of it did
    std::vector<std::uint8_t> not_finite;           // or too fast or too far: to be quarantined
    std::vector<std::uint8_t> fast;                 // moved far, or may have bounced: to be swept
    std::vector<std::uint8_t> left_predicted_aabb;  // fast, and not where its fat boxes foresaw
    // Not fast, and did not go as its velocity says: contacts turned it round in the step. Or it
    // may have bounced and is not to be swept itself.
    std::vector<std::uint8_t> deflected;
    std::vector<std::uint8_t> bouncing;  // ContactScratch::bouncing, by awake body
    // By awake body: its record before the step, if it is fast or was thrown.
    std::vector<BodyWarm> previous;

    std::atomic<int> any_fast = 0;
    // Free bodies that are moved sub-step by sub-step: how they move now, and who they are.
    std::vector<BodyWarm> moving;
    std::vector<std::uint32_t> moving_awake;
    std::vector<BroadPhaseIndex::Move> moves;  // of the fat boxes that were left
};

}  // namespace jostle::physics
