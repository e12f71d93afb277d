// SPDX-License-Identifier: MIT
//
// The stages of the step, in execution order: what each reads, what it writes, and what it leaves
// in scratch for which later stage. step_world.cpp calls them. Each stage is one source in a folder
// of its subject; stages/continuous has its own headers.
#pragma once

#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// Broad phase: finds shapes that may touch. Shapes that are new or left their fat box are queried
// for new neighbours, on several threads. The results are sorted, so that contacts get the same
// indices for any number of threads and any broad phase.
//
// Reads: ShapeStore::moved (written by finalize in the previous step and by API calls), fat boxes,
// filters, joints. Writes: a contact for each new pair, with a separation bound that is due; files
// a wake request for a pair without awake bodies; clears ShapeStore::moved. Leaves nothing in
// scratch.
Skipped update_pairs(StepContext& step);

// Narrow phase: finds the contact points of pairs. Selects the pairs whose bodies may have touched
// and the manifolds that moved too far to be reused (select_pairs), tests each on any thread
// (narrow_phase_pair), and applies the results serially (update_touching). All other pairs are
// unchanged.
//
// Reads: bodies, shapes, pairs. Writes: separation bounds, continuing manifolds, ended contacts,
// wake requests. Leaves in scratch: ContactScratch::begins for begin_contacts, had_contacts for
// solve_continuous (ccd_policy.h).
Skipped update_contacts(StepContext& step);

// The two points of the step at which bodies wake: before the solve, and after impacts. All stages
// file requests (state/wake_requests.h); bodies wake nowhere else.
//
// Read and clear: WorldState::wake_requests. Write: body sets, islands, manifolds of sleeping
// islands back into the constraint graph, wake events. Leave nothing in scratch.

// Files requests for disturbed bodies that sleep in place, then wakes all requested bodies: those
// with new neighbours, new contacts or ended contacts.
Skipped wake_before_solve(StepContext& step);

// Wakes sleeping bodies that were hit by impacts or have lost a contact since.
Skipped wake_after_impacts(StepContext& step);

// Adds manifolds that may touch in this step to the constraint graph. Runs after wake_before_solve,
// so their bodies are awake.
//
// Reads: ContactScratch::begins, and the manifolds found. Writes: constraint graph, contacts,
// colour sets of islands. Leaves nothing in scratch.
Skipped begin_contacts(StepContext& step);

// Chooses the solver effort for each island from the island alone. A world therefore behaves
// independently of its other content and of the speed of the machine.
//
// A contact is a spring whose stiffness is proportional to the square of the sub-step rate. A wall
// of n layers stands while the tilt stiffness of its contacts exceeds the overturning moment, which
// is proportional to the cube of n (Greenhill, "Height consistent with stability", 1881). A heavy
// body on a light one loads a spring dimensioned for the light one. Both need more sub-steps.
//
// An island that lost a load starts with its impulses reduced accordingly. Otherwise these
// impulses, which warm-start the next step, would throw it upwards.
//
// Reads: awake bodies, touching contacts, joints, Island::remaining_load. Writes: tier and batch of
// islands (Island::colour_set), and with them the colours and slots of contacts; impulses of
// islands that lost a load. Runs every eighth step and after a load was lost; with a tolerance, in
// every step (choose_substep_levels). Leaves nothing else in scratch.
Skipped prepare_islands(StepContext& step);

// The sub-step loop: integrates velocities from forces, joints and contacts, and positions from
// velocities. Soft contacts with relaxation (Catto, "Soft Constraints", GDC 2011; "Solver2D",
// 2024).
//
// Reads: awake bodies, joints, Island::colour_set, StepContext::contacts. Writes: impulses, gaps
// and flags (touching_now, needs_rebuild) in the constraint graph, impulses and loads of joints;
// broken joints with their events. Does not change the warm records. Leaves in scratch:
// SolverScratch::hot, bodies and spin_axes for finalize, free for integrate_free, jointed for
// update_sleep; bodies and free are also set if there is nothing to solve.
Skipped solve_constraints(StepContext& step);

// Updates islands: contacts that began to touch merge islands, contacts that ended mark an island
// that may be split, and both become events. Runs after solve_constraints, because only then the
// touching contacts are known, and before the warm records change, because events report the
// approach velocity.
//
// Reads: the flags of the last relaxing pass in the constraint graph, warm records before the
// solve, WorldState::changed_pairs. Writes: contacts, islands, begin, end and hit events; files
// wake requests for bodies that sleep in place and lost a contact. Leaves nothing in scratch.
Skipped merge_islands(StepContext& step);

// Integrates bodies without manifolds and joints, and all kinematic bodies: an exact parabola under
// constant force, and a free rotation that conserves energy and angular momentum
// (constraints/free_motion.h). Runs after merge_islands, whose events need the velocities before
// the integration.
//
// Reads: SolverScratch::free, warm records, gravity. Writes: see finalize_body. Leaves in scratch:
// FinalizeScratch with space for all awake bodies, filled for the free ones.
Skipped integrate_free(StepContext& step);

// The end of a step for solved bodies: writes the solver's float results back to the double records
// (finalize_body). Bodies that were not solved were finalized in integrate_free.
//
// Reads: SolverScratch::hot, bodies and spin_axes. Writes: see finalize_body; and ShapeStore::moved
// for all shapes that left their fat box. Updates the moving broad phase with their new boxes,
// concurrently with the following stages: a stage that queries it must call ThreadPool::finish()
// first. Leaves in scratch: FinalizeScratch, for solve_continuous and quarantine.
Skipped finalize(StepContext& step);

// Quarantine: no non-finite state leaves the step. finalize_body has left a diverged body at its
// previous pose, at rest. This stage reports it and resets the impulses and bounds of its contacts
// and joints.
//
// Reads: FinalizeScratch::not_finite. Writes: quarantine events; impulses of the body's joints; its
// manifolds, which are marked for a rebuild; its separation bounds; its motion bound. Leaves
// nothing in scratch.
Skipped quarantine(StepContext& step);

// Moves resting islands out of the awake set. Resting parts of other islands fall asleep in place
// (put_parts_to_sleep.h). An island of several parts is split first, one per step.
//
// Reads: rest times (finalize_body), SolverScratch::jointed, contacts with kinematic bodies.
// Writes: islands, body sets, manifolds removed from the constraint graph, sleep and end events;
// resets the rest time of bodies that a moving kinematic body carries or tows. Leaves nothing in
// scratch.
Skipped update_sleep(StepContext& step);

// Determines which shapes overlap which triggers at the end of the step, or did so within it. Runs
// after all motion, and after the trees are updated (ThreadPool::finish() in step_world). Shapes
// that moved far are found by the boxes around their paths, all others by the trees.
//
// Reads: current shapes, the broad phases, FinalizeScratch::path_starts,
// ContinuousScratch::changed, the TriggerStore of the previous step. Writes: TriggerStore, and
// trigger events. Leaves nothing in scratch.
Skipped update_triggers(StepContext& step);

// The last stage: makes events available through World::events(), each list sorted by ids.
//
// Reads: EventStore as filled by the stages and by calls between steps; for contacts with
// report_stays, impulses and flags in the constraint graph. Writes: EventStore, sorted and with
// EventStore::contacts. Leaves nothing in scratch.
Skipped publish_events(StepContext& step);

// The end of a step: sums up its work and, in a world with a budget, derives the overload level of
// the next step (OverloadState). The level rises by one after a step of more work than the
// budget, so no step is ever truncated, and falls by one after many cheap steps in a row.

// Computed from the step's own counters; independent of the number of threads.
std::int64_t step_work(const StepProfile& profile);

// Reads: the profile's counters, WorldDef::step_budget. Writes: StepProfile::work,
// WorldState::overload_level, and the impulses that warm-start the next step if its sub-steps have
// another length. Runs last, because events refer to the sub-steps of this step.
void update_step_budget(WorldState& world);

}  // namespace jostle::physics
