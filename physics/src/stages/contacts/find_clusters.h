// SPDX-License-Identifier: MIT
//
// Crowds: bodies that are about to bounce off each other within one step, and whom something holds,
// a wall or what bears them. One after the other, a push that goes through a row of n and back
// leaves e^2n of its speed (Bernu and Mazighi, "One-dimensional bounce of inelastically colliding
// marbles on a wall", 1990, find where such a row collapses), friction takes its part, and all of
// them share the rest. Once each has less than what bounces at all, or than what gravity gives in
// two steps, nothing shows in which order they met: the contact solver resolves them together, and
// continuous collision sweeps as if they did not bounce. A pair, what loses nothing, and what flies
// freely are never a crowd.
#pragma once

#include "physics/src/stages/contacts/contact_scratch.h"
#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// Reads: checks that narrow_phase_pair is done with. Leaves in scratch: ContactScratch::crowds and
// cluster_of, for update_touching and solve_continuous. One thread.
void find_clusters(StepContext& step);

// Whether two shapes bounce off each other in a crowd: one of their bodies is in one.
bool bounces_in_cluster(const WorldState& world, const ContactScratch& scratch,
                        std::uint32_t shape_a, std::uint32_t shape_b);
// Whether they bounce off each other one at a time in this step, not in a crowd.
bool bounces_alone(const StepContext& step, std::uint32_t shape_a, std::uint32_t shape_b);

}  // namespace jostle::physics
