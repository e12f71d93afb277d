// SPDX-License-Identifier: MIT
//
// The parts of prepare_islands. merge_islands also raises islands to the heavy tier.
#pragma once

#include <span>

#include "physics/src/stages/step_context.h"
#include "physics/src/state/world_stores.h"

namespace jostle::physics {

// Distributes the islands of a tier over batches so that threads get equal work. Islands are moved
// whole, with all islands coupled to them by manifolds, and only when the batches have become
// unequal. The result depends only on the world, so it is the same for any number of threads.
//
// Reads: awake bodies with their numbers of contacts and joints. Writes: Island::colour_set, and
// with it the colours of contacts.
void assign_batches(StepContext& step);

// With a tolerance (WorldDef::tolerance), chooses the number of sub-steps of each island: the
// smallest of substeps_per_level that keeps its error, as measured by stages/solver/error_trial.h,
// within the tolerance. Levels rise immediately and fall with a delay, because contacts move
// between sets.
//
// With a budget (WorldDef::substep_budget) the requested sub-steps are reduced: the island whose
// error would be the smallest at a lower level gives way first. An island's level then no longer
// depends on that island alone.
//
// Reads: Island::error. Writes: Island::error, Island::colour_set, contacts, impulses. Leaves in
// scratch, for the solver: which colour sets have an island of unknown error.
void choose_substep_levels(StepContext& step);

// Without a tolerance: chooses the size level of each island whose smallest body has a shorter time
// scale sqrt(size / gravity) than bodies of usual size at standard gravity
// (foundation/size_scale.h), in proportion to the length of the step. Levels rise immediately. In a
// world in which no island needs it, batches are not size levels.
//
// Reads: awake bodies with contacts. Writes: SteppingState::size_levels, Island::colour_set,
// contacts, impulses.
void choose_size_levels(StepContext& step);
// Returns whether levels may change: contacts of small bodies began, the step is longer than the
// last one, or lower levels are due.
bool needs_size_levels(const StepContext& step);

// Restores the order of lanes. As contacts begin and end, the lanes of a colour lose their order.
// Each thread that shares the colours would then load bodies from the caches of other threads.
//
// Reads and writes: the slots of contacts in the constraint graph.
//
// Sorts the contacts of large colour sets by their bodies if many are out of order.
void sort_constraints(StepContext& step);

// Heavy bodies on light ones: islands of few bodies get SolverTier::direct, others
// SolverTier::heavy. Islands that manifolds couple are considered together.
//
// Returns whether a body of the island rests only on bodies that are a hundred times lighter.
bool has_heavy_load(ContactGraph& stores, const Island& island, Vec3 up);

// Returns the largest load that a body of these islands carries, relative to its mass and to the
// layers above it: 1 in a stack of equal bodies. Bodies carry what lies on them, whether it touches
// them yet or not.
double largest_load_ratio(ContactGraph& stores, std::span<const std::uint32_t> islands, Vec3 up);

// Returns whether the islands are small enough for SolverTier::direct, without joints, without
// bodies that sleep in place and without bodies that touch side by side: friction with what lies on
// them can hold any pressure between those, so that a direct solver may find ever larger impulses.
bool may_be_solved_directly(const ContactGraph& stores, std::span<const std::uint32_t> islands);

// Returns whether at most a quarter of the bodies move relative to the others, none fast. In a
// tumbling heap loads pass before they could sink, and each new contact costs a direct solver
// iterations.
bool mostly_stand(const ContactGraph& stores, std::span<const std::uint32_t> islands);

// `bodies`: bodies that have begun to touch a much lighter body. Those that rest on nothing else
// raise their islands to SolverTier::heavy immediately; until the next update of all islands they
// would sink.
void raise_to_heavy_tier(ContactGraph& stores, JointStore& joints,
                         std::span<const std::uint32_t> bodies);
// `bodies`: bodies with a new manifold with a much lighter body. If they load it, their islands are
// solved directly from now on, if they are small enough.
void raise_to_direct_tier(ContactGraph& stores, JointStore& joints,
                          std::span<const std::uint32_t> bodies);
// Moves islands that have become too large for SolverTier::direct, or tumble, to SolverTier::heavy.
void leave_direct_tier(ContactGraph& stores, JointStore& joints);
// The same for the islands of these bodies, for which no solution was found.
void leave_direct_tier(ContactGraph& stores, JointStore& joints,
                       std::span<const std::uint32_t> bodies);

}  // namespace jostle::physics
