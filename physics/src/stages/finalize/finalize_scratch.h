// SPDX-License-Identifier: MIT
//
// Results of finalize_body per awake body, for finalize, solve_continuous and quarantine. Bodies
// that wake later in the step have no entry.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

#include "physics/src/collision/broadphase/broad_phase_index.h"
#include "physics/src/state/body_store.h"

namespace jostle::physics {

// The pose of a body before the step.
struct PathStart {
    Vec3 center;  // m
    Quat rotation;
    bool moved = false;  // the other fields are valid
    // It may have left the fat boxes that the trees contain: it moved far, or left them.
    bool far = false;
};

struct FinalizeScratch {
    // Flags, by awake body.
    std::vector<std::uint8_t> left_fat_aabb;  // one of its shapes left its fat box
    std::vector<std::uint8_t> not_finite;     // or too fast or too far away: to be quarantined
    std::vector<std::uint8_t> fast;           // moved far, or may have bounced: to be swept
    std::vector<std::uint8_t> left_predicted_aabb;  // fast, and outside its predicted fat boxes
    // Not fast, but its displacement does not match its velocity: contacts deflected it in the
    // step. Or it may have bounced and is not swept itself.
    std::vector<std::uint8_t> deflected;
    std::vector<std::uint8_t> bouncing;  // ContactScratch::bouncing, by awake body
    // By awake body: its record before the step, if it is fast or deflected.
    std::vector<BodyWarm> previous;
    // For update_triggers, which resets them; empty in a world without triggers.
    std::vector<std::uint8_t> on_path;       // by awake body: has an entry
    std::vector<PathStart> path_starts;      // by body
    std::vector<std::uint32_t> path_bodies;  // with an entry

    std::atomic<int> any_fast = 0;
    // Free bodies that are integrated by sub-steps: their current motions and awake indices.
    std::vector<BodyWarm> moving;
    std::vector<std::uint32_t> moving_awake;
    std::vector<BroadPhaseIndex::Move> moves;  // of the fat boxes that were left
};

}  // namespace jostle::physics
