// SPDX-License-Identifier: MIT
//
// Memory that steps reuse, stage by stage. Neither description nor state: never saved, never
// hashed. The header of each stage documents what it leaves here for later stages.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <utility>
#include <vector>

#include "jostle/physics/vec3.h"
#include "physics/src/constraint_graph/solver_tier.h"
#include "physics/src/stages/contacts/contact_scratch.h"
#include "physics/src/stages/continuous/continuous_scratch.h"
#include "physics/src/stages/finalize/finalize_scratch.h"
#include "physics/src/stages/solver/solver_scratch.h"
#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// Scratch data that prepare_islands and merge_islands reuse from step to step. The solver reads
// `unknown`.
//
// Extent of the standing part of an island, by its bodies' centres of mass.
struct IslandExtent {
    double low = 1e300, high = -1e300;  // m, along the up direction
    double thickness = 0;               // m, sum over all bodies
    int bodies = 0;
    // Sums over the bodies of their horizontal positions, relative to the first of them, m and m^2.
    Vec3 first;
    double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
    bool solved_directly = false;  // SolverTier::direct is required
    bool tier_chosen = false;      // its tier was chosen together with another island's
};

struct IslandScratch {
    std::vector<std::uint32_t> awake;          // islands, in ascending order
    std::vector<IslandExtent> extents;         // indexed by island; valid for the awake ones
    std::vector<std::uint32_t> weights;        // indexed by island
    std::vector<double> smallest;              // m, indexed by island: size of its smallest body
    std::vector<std::uint32_t> touch_changes;  // contacts whose touching flag changes
    // By colour set, in a world with a tolerance: whether it has an island of unknown error.
    std::array<std::uint8_t, solved_set_count> unknown{};
};

// Scratch data of update_triggers.
//
// A shape with the box around its path of the step.
struct ShapePath {
    std::uint32_t shape = 0;
    Aabb box;  // not for planes
};

struct TriggerScratch {
    std::vector<std::uint32_t> near;        // shapes, of one query
    std::vector<ShapePath> triggers, far;   // far: shapes that may have left their fat box
    std::vector<Inside> pairs;              // that may overlap, ascending
    std::vector<std::uint8_t> presence;     // by pair
    std::vector<const ToiBody*> deflected;  // by body; null: not deflected by an impact
};

// Scratch data that update_pairs reuses from step to step.
//
// Results of one grain of update_pairs, a range of the moved shapes.
struct NewPairs {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;  // shapes
    std::vector<std::uint32_t> near;                             // shapes, of one query
    std::size_t skipped = 0;                                     // pairs, at least
};

struct PairScratch {
    std::vector<NewPairs> new_pairs;  // by grain; the first one finally holds all pairs
    TriggerScratch triggers;
};

// Scratch data that update_sleep and put_parts_to_sleep reuse from step to step. No later stage
// reads it.
struct SleepScratch {
    std::vector<std::uint32_t> islands;   // awake islands, in ascending order
    std::vector<std::uint32_t> to_split;  // awake islands that may consist of several parts
    // Indexed by island; valid for the awake ones: shortest and longest rest time of its bodies, s.
    std::vector<double> shortest, longest;
    std::vector<std::uint8_t> restless;  // by hot index: has not rested for long
    // By hot index: restless, touches a restless body, or is jointed to such a body.
    std::vector<std::uint8_t> near_restless;
    std::vector<std::uint32_t>
        resting;  // by island: number of bodies that could sleep in place, or do
    std::vector<std::uint32_t> falling_asleep;  // body indices
};

struct StepScratch {
    // May be set by any thread. The rest of the step then skips sub-steps and sweeps.
    std::atomic<bool> stopped{false};
    PairScratch pairs;
    ContactScratch contacts;
    IslandScratch islands;
    SolverScratch solver;
    FinalizeScratch finalize;
    ContinuousScratch continuous;
    SleepScratch sleep;
};

// The thread that runs a stage polls this between rounds and informs its helper threads.
inline bool is_stopped(const StepContext& step) {
    return step.scratch.stopped.load(std::memory_order_relaxed);
}

}  // namespace jostle::physics
