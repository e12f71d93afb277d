// SPDX-License-Identifier: MIT
//
// Memory that a step uses and the next one uses again. Neither description nor state: never saved,
// never hashed.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "collision/narrowphase/manifold.h"
#include "state/solver_body.h"

namespace jostle::physics {

// One narrow phase call and what came of it.
struct ContactCheck {
    std::uint32_t contact = 0;
    Manifold manifold;
    double gap_ahead =
        0;  // m: smallest gap of any point at the end of the step, as the bodies move now
    bool expected = false;  // near enough for a manifold
};

struct StepScratch {
    std::vector<HotBody> hot;              // [0] is the null body, awake body i is [i + 1]
    std::vector<BodyDrive> drive;          // as hot
    std::vector<std::uint32_t> in_solver;  // indices into awake with at least one manifold
    std::vector<std::uint32_t> free;       // the other awake bodies
    std::vector<std::pair<std::uint32_t, std::uint32_t>> new_pairs;  // shapes
    std::vector<ContactCheck> checks;
    std::vector<std::uint32_t> new_lanes, to_wake;
    std::vector<std::uint32_t> touch_changes;  // contacts whose touching flag changes
    std::vector<std::uint8_t> left_fat_box;    // by awake body: some shape of it did
    std::vector<std::uint8_t> not_finite;      // by awake body
    std::vector<double> island_quiet, island_most_quiet;
    std::vector<std::uint32_t> stack;
};

}  // namespace jostle::physics
