// SPDX-License-Identifier: MIT
//
// The passes over all blocks of all colours of some stores, in solve order; the blocks of each
// colour of a large store are shared among the threads.
#pragma once

#include <span>
#include <vector>

#include "constraints/kernels.h"
#include "foundation/task_team.h"
#include "state/step_scratch.h"

namespace jostle::physics {

// The colours in use of the stores [first, last), in solve order, store after store. Their unused
// lanes get bodies of their own.
void list_runs(ConstraintGraph& graph, std::size_t first, std::size_t last,
               std::vector<ColourRun>& runs);

// What every pass needs.
struct ContactPart {
    std::span<const ColourRun> runs;
    HotBody* bodies;
    const ContactSettings& set;
    TaskTeam& team;
};

void warm_start(const ContactPart& part);
void solve(const ContactPart& part);
// `last`: ends the step; sets `needs_rebuild` and `touching_now` of every block.
void relax(const ContactPart& part, bool last);

// Restitution. begin_restitution says whether any block is bouncy; if none is, the others need not
// be called.
bool begin_restitution(const ContactPart& part);
void predict_approaches(const ContactPart& part);
void record_peaks(const ContactPart& part);
void apply_restitution(const ContactPart& part);

}  // namespace jostle::physics
