// SPDX-License-Identifier: MIT
//
// What the narrow phase hands on within a step, and uses again in the next. select_pairs fills the
// checks, narrow_phase_pair their results, update_touching what begins; begin_contacts reads that.
#pragma once

#include <atomic>
#include <cstdint>
#include <utility>
#include <vector>

#include "physics/src/collision/narrowphase/collide_composite.h"
#include "physics/src/foundation/uninitialized_array.h"

namespace jostle::physics {

// One narrow phase call and what came of it. Small: there may be tens of thousands.
struct NarrowPhaseTask {
    std::uint32_t contact = 0;
    // Of a composite pair: its parts are in ContactScratch::parts[list]. Else: the manifold that
    // may begin is ContactScratch::fresh[list].
    std::int32_t list = -1;
    bool persists = false;     // has points, and a lane that they were written to ...
    bool done = false;         // ... and stays in: nothing is left to decide
    bool bounces = false;      // its bodies are to be swept, however slow: ccd_policy.h
    double closing = 0;        // m/s: how fast those do that bounce
    float direction[3] = {};   // along which they are apart by `near`; zero: not known
    double predicted_gap = 0;  // m: smallest gap of any point at the end of the step, as the bodies
                               // move now
    // m: the smallest gap now. Of a composite pair: everything nearer than this beyond the
    // speculative margin is among its parts.
    double near = 0;
};

// One manifold of a composite pair.
struct FoundChild {
    ChildManifold child;
    double predicted_gap = 0;
    std::uint32_t contact = 0xffffffff;  // whose manifold it continues; none: it may begin
};

// A manifold that enters the constraint graph: of a check, and which part of it (-1: the check's
// own).
struct NewContact {
    std::uint32_t task = 0;
    std::int32_t child = -1;
};

// Bodies that are about to bounce off each other: find_clusters.h.
struct BodyCluster {
    std::uint32_t cluster_parent = 0;  // itself, unless it was joined to another
    int bodies = 0;
    int row = 0;         // bodies in its longest row, from one to the next
    bool held = false;   // by a wall that is near, or by what one of them leans on
    double fastest = 0;  // m/s: closing speed
    double min_retained_energy =
        0;  // what keeps less of its energy at an impact bounces in a crowd
};

struct ContactScratch {
    std::vector<std::uint8_t> due;  // by separation bound: whether it is used up
    std::vector<NarrowPhaseTask> tasks;
    std::int32_t child_list_count = 0;  // given to checks of composite pairs
    // Of checks without a lane, as far as fresh_count, in any order.
    UninitializedVector<Manifold> fresh;
    std::atomic<int> fresh_count = 0;
    std::vector<std::vector<FoundChild>> children;
    std::vector<NewContact> begins;
    // By awake body: whether it had contacts in the constraint graph when the step began.
    std::vector<std::uint8_t> had_contacts;
    // Bodies that may bounce off something in this step: awake, in any order, some more than once.
    std::vector<std::uint32_t> bouncing;
    std::vector<BodyCluster> clusters;
    std::vector<std::pair<std::uint32_t, std::uint32_t>>
        cluster_edges;                      // awake bodies side by side
    std::vector<std::uint32_t> cluster_of;  // by awake body; empty where nobody is about to bounce
};

}  // namespace jostle::physics
