// SPDX-License-Identifier: MIT
//
// Islands: dynamic bodies connected by touching contacts and joints. They persist between steps:
// merged when a contact begins to touch, split when a part has come to rest and contacts have ended
// since. A sleeping island owns the warm records and manifolds of its bodies, so that the awake
// arrays contain only moving bodies.
#pragma once

#include <cstdint>
#include <vector>

#include "physics/src/constraint_graph/constraint_graph.h"
#include "physics/src/constraint_graph/solver_tier.h"
#include "physics/src/foundation/id_pool.h"
#include "physics/src/state/body_store.h"

namespace jostle::physics {

// In a world with a tolerance: the estimated error of the sub-steps relative to the converged
// solution (stages/solver/error_trial.h).
struct IslandError {
    double estimate = 0;  // m after one second of such steps; 0: unknown
    // Sub-step level required by the tolerance, regardless of the budget.
    std::uint8_t target_level = 0;
    std::uint8_t easy = 0;  // consecutive tests that a coarser level would have passed
    bool fresh = false;     // measured, but not yet used
};

struct Island {
    std::uint32_t first = none, last = none;  // bodies, through BodyCold::island_next
    std::uint32_t bodies = 0;
    // Budget of multiplications per joint (joint_solver_preferences.h) known to be too small for
    // the direct solver; -1: none. Determined by the solver and valid until bodies or joints of the
    // island change. Not saved.
    std::int64_t too_dense_for = -1;
    bool may_be_split = false;  // a touching contact has ended since it was formed
    bool asleep = false;
    ColourSetKey colour_set;     // of its manifolds
    std::uint8_t calm = 0;       // consecutive tests in which a lower tier would have sufficed
    bool uneven = false;         // a touch began between bodies of very different mass
    std::uint64_t split_at = 0;  // step of the last attempt to split it
    double mass = 0;             // total mass of its bodies, kg
    double remaining_load = 1;  // fraction of its mass that remains after calls since the last step
    IslandError error;
    // Length of the step in which the island fell asleep, in s, to which its stored impulses apply;
    // multiplied by the lengthening of its sub-steps. Valid while asleep.
    double dt = 0;
    std::vector<BodyWarm> sleepers;       // while asleep, in the order of the list
    std::vector<SavedContact> manifolds;  // while asleep
};

// Contacts of bodies that may need more sub-steps (choose_size_levels). Not saved: after loading,
// all count as begun.
enum class SmallContacts : std::uint8_t { absent, known, began };

struct IslandStore {
    IdPool ids;
    std::vector<Island> islands;
    bool some_lost = true;  // conservative: some remaining_load may be below 1; not saved
    SmallContacts small = SmallContacts::absent;
    double levels_dt = 0;  // s: length of the step in which size levels were last chosen; not saved
};

}  // namespace jostle::physics
