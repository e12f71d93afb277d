// SPDX-License-Identifier: MIT
//
// Scratch data that the narrow phase passes on within a step and reuses in the next. select_pairs
// fills the tasks, narrow_phase_pair their results, and update_touching the list of new contacts,
// which begin_contacts reads.
#pragma once

#include <atomic>
#include <cstdint>
#include <utility>
#include <vector>

#include "physics/src/collision/narrowphase/collide_composite.h"
#include "physics/src/foundation/uninitialized_array.h"

namespace jostle::physics {

// One narrow-phase task and its result. Kept small: there may be tens of thousands.
struct NarrowPhaseTask {
    std::uint32_t contact = 0;
    // For a composite pair: index of its children in ContactScratch::children. Otherwise: index of
    // the manifold that may begin in ContactScratch::fresh.
    std::int32_t list = -1;
    bool persists = false;    // has points, which were written to its lane
    bool done = false;        // and remains in its set: nothing is left to decide
    bool bounces = false;     // its bodies are swept at any speed: ccd_policy.h
    double closing = 0;       // m/s: closing speed of bodies that bounce
    float direction[3] = {};  // direction of their separation by `near`; zero if unknown
    // m: smallest gap of any point at the end of the step, at the current velocities.
    double predicted_gap = 0;
    // m: current smallest gap. For a composite pair, all children within this distance beyond the
    // speculative margin are in the list.
    double near = 0;
};

// One manifold of a composite pair.
struct FoundChild {
    ChildManifold child;
    double predicted_gap = 0;
    std::uint32_t contact = 0xffffffff;  // the contact that it continues; none: it may begin
};

// A manifold that enters the constraint graph: its task, and its index among the children (-1: the
// task's own manifold).
struct NewContact {
    std::uint32_t task = 0;
    std::int32_t child = -1;
};

// Bodies that are about to bounce off each other: see find_clusters.h.
struct BodyCluster {
    std::uint32_t cluster_parent = 0;  // itself, unless merged into another cluster
    int bodies = 0;
    int row = 0;         // number of bodies in its longest row of neighbours
    bool held = false;   // by a nearby wall, or by a body with contacts
    bool level = true;   // all impacts are level: gravity does not press their bodies together
    double fastest = 0;  // m/s: highest closing speed
    // Fraction of energy: impacts that retain less of it are resolved as a cluster.
    double min_retained_energy = 0;
};

struct ContactScratch {
    std::vector<std::uint8_t>
        due;  // indexed like the separation bounds: whether the bound may be used up
    std::vector<NarrowPhaseTask> tasks;
    std::int32_t child_list_count = 0;  // number of lists assigned to tasks of composite pairs
    // Manifolds of tasks without a lane. The first fresh_count are valid, in any order.
    UninitializedVector<Manifold> fresh;
    std::atomic<int> fresh_count = 0;
    std::vector<std::vector<FoundChild>> children;
    std::vector<NewContact> begins;
    // Indexed by awake body: whether it had contacts in the constraint graph at the start of the
    // step.
    std::vector<std::uint8_t> had_contacts;
    // Awake bodies that may bounce in this step, in any order, possibly more than once.
    std::vector<std::uint32_t> bouncing;
    std::vector<BodyCluster> clusters;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> cluster_edges;  // adjacent awake bodies
    std::vector<std::uint32_t>
        cluster_of;  // indexed by awake body; empty if no body is about to bounce
};

}  // namespace jostle::physics
