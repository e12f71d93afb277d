// SPDX-License-Identifier: MIT
//
// The passes over all blocks of all colours of some sets, in solve order. Threads share the blocks
// of each colour of a large set.
#pragma once

#include <span>
#include <vector>

#include "physics/src/constraint_graph/constraint_graph.h"
#include "physics/src/constraints/kernels.h"
#include "physics/src/foundation/thread_pool.h"

namespace jostle::physics {

// A non-empty colour with the list of its single-point manifolds, whose bodies are distinct.
struct ColourRun {
    GraphColour* colour = nullptr;
    GraphColour* single = nullptr;  // null for an overflow list
    int number = 0;                 // of `colour`
    int blocks = 0, singles = 0;
    bool shared = false;  // among threads
};

// Lists the non-empty colours of the sets [first, last), in solve order, set by set. Assigns
// separate dummy bodies to their unused lanes.
void list_runs(ConstraintGraph& graph, std::size_t first, std::size_t last,
               std::vector<ColourRun>& runs);

// Parameters of every pass.
struct ContactTask {
    std::span<const ColourRun> runs;
    SolverBody* bodies;
    const ContactSettings& set;
    ThreadPool& thread_pool;
};

void warm_start(const ContactTask& task);
void solve(const ContactTask& task);
// `last`: the pass that ends the step. It sets `needs_rebuild` and `touching_now` of every block.
void relax(const ContactTask& task, bool last);

// Restitution. begin_restitution() returns whether any block bounces; if not, the other functions
// need not be called.
bool begin_restitution(const ContactTask& task);
void predict_approaches(const ContactTask& task);
void record_peaks(const ContactTask& task);
void apply_restitution(const ContactTask& task);

}  // namespace jostle::physics
