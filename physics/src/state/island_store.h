// SPDX-License-Identifier: MIT
//
// Islands: dynamic bodies that hang together by touching contacts. Kept from step to step: joined
// when a contact begins to touch, split when something in it has come to rest and contacts have
// ended since. A sleeping island owns its bodies' warm records and manifolds, so that the awake
// arrays hold only what moves.
#pragma once

#include <cstdint>
#include <vector>

#include "physics/src/constraint_graph/constraint_graph.h"
#include "physics/src/constraint_graph/solver_tier.h"
#include "physics/src/foundation/id_pool.h"
#include "physics/src/state/body_store.h"

namespace jostle::physics {

// In a world with a tolerance: what is known of how far the sub-steps lead from the motion that
// endlessly many would give (stages/solver/error_trial.h).
struct IslandError {
    double estimate = 0;            // m in a second of such steps; 0: not known
    std::uint8_t target_level = 0;  // the rung that the tolerance asks for, whatever the budget
    std::uint8_t easy = 0;          // looks in a row that a coarser one would have passed
    bool fresh = false;             // measured, and not yet acted upon
};

struct Island {
    std::uint32_t first = none, last = none;  // bodies, through BodyCold::island_next
    std::uint32_t bodies = 0;
    // Multiplications that each of its joints may take (joint_solver_preferences.h) that are known
    // to be too few for all of them, -1: none. Found by the solver and true until the island's
    // bodies or joints change: not saved.
    std::int64_t too_dense_for = -1;
    bool may_be_split = false;  // a touching contact ended since it was formed
    bool asleep = false;
    ColourSetKey colour_set;     // of its manifolds
    std::uint8_t calm = 0;       // how often in a row the rule would have been content with less
    bool uneven = false;         // a touch began between bodies of very different mass
    std::uint64_t split_at = 0;  // the step of the last attempt to split it
    double mass = 0;             // kg, of its bodies
    double remaining_load = 1;   // share of its mass that the user has left it since the last step
    IslandError error;
    // s, when asleep: of the step in which it fell asleep, whose impulses it keeps; as much longer
    // as its sub-steps were.
    double dt = 0;
    std::vector<BodyWarm> sleepers;       // when asleep, in the order of the list
    std::vector<SavedContact> manifolds;  // when asleep
};

struct IslandStore {
    IdPool ids;
    std::vector<Island> islands;
    bool some_lost = true;  // some remaining_load may be below 1; not saved
};

}  // namespace jostle::physics
