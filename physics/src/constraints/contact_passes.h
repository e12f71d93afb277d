// SPDX-License-Identifier: MIT
//
// The passes over all blocks of all colours of some sets, in solve order; the blocks of each
// colour of a large set are shared among the threads.
#pragma once

#include <span>
#include <vector>

#include "physics/src/constraint_graph/constraint_graph.h"
#include "physics/src/constraints/kernels.h"
#include "physics/src/foundation/thread_pool.h"

namespace jostle::physics {

// A colour in use, with the list of its manifolds of one point: their bodies are distinct.
struct ColourRun {
    GraphColour* colour = nullptr;
    GraphColour* single = nullptr;  // null of an overflow list
    int number = 0;                 // of `colour`
    int blocks = 0, singles = 0;
    bool shared = false;  // among threads
};

// The colours in use of the sets [first, last), in solve order, set after set. Their unused
// lanes get bodies of their own.
void list_runs(ConstraintGraph& graph, std::size_t first, std::size_t last,
               std::vector<ColourRun>& runs);

// What every pass needs.
struct ContactTask {
    std::span<const ColourRun> runs;
    SolverBody* bodies;
    const ContactSettings& set;
    ThreadPool& thread_pool;
};

void warm_start(const ContactTask& task);
void solve(const ContactTask& task);
// `last`: ends the step; sets `needs_rebuild` and `touching_now` of every block.
void relax(const ContactTask& task, bool last);

// Restitution. begin_restitution says whether any block is bouncy; if none is, the others need not
// be called.
bool begin_restitution(const ContactTask& task);
void predict_approaches(const ContactTask& task);
void record_peaks(const ContactTask& task);
void apply_restitution(const ContactTask& task);

}  // namespace jostle::physics
