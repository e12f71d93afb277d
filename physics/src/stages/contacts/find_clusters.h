// SPDX-License-Identifier: MIT
//
// Clusters: bodies that are about to bounce off each other within one step and that are held by a
// wall or by their supports. Resolved one by one, an impulse that travels through a row of n bodies
// and back leaves e^2n of its speed (Bernu and Mazighi, "One-dimensional bounce of inelastically
// colliding marbles on a wall", 1990, derive when such a row collapses). Friction removes more, and
// all bodies share the rest. Once each body is slower than the restitution threshold, or than
// gravity makes it in two steps, the order of impacts has no visible effect. The contact solver
// then resolves them together, and continuous collision sweeps them as if they did not bounce.
// Pairs, elastic impacts and bodies in free flight never form a cluster.
#pragma once

#include "physics/src/stages/contacts/contact_scratch.h"
#include "physics/src/stages/step_context.h"

namespace jostle::physics {

// Reads: tasks after narrow_phase_pair. Leaves in scratch: ContactScratch::clusters and cluster_of,
// for update_touching and solve_continuous. Single-threaded.
void find_clusters(StepContext& step);

// Returns whether two shapes bounce off each other in a cluster, which contains at least one of
// their bodies.
bool bounces_in_cluster(const ShapedBodies& stores, const ContactScratch& scratch,
                        std::uint32_t shape_a, std::uint32_t shape_b);
// Returns whether two shapes bounce individually in this step, not in a cluster.
bool bounces_alone(const StepContext& step, std::uint32_t shape_a, std::uint32_t shape_b);

}  // namespace jostle::physics
