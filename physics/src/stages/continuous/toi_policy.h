// SPDX-License-Identifier: MIT
//
// Decides which shapes a TOI body is swept against, and whether an impact is left to the contact
// solver. Extends ccd_policy.h by the deflections of the current step. Part of solve_continuous.
#pragma once

#include <cstdint>
#include <vector>

#include "physics/src/stages/continuous/toi_state.h"

namespace jostle::physics {

// Lists the pairs whose collision listeners have disabled, as ToiState::ignored_pairs.
void find_ignored_pairs(ToiState& state);
void ignore_pair(ToiState& state, std::uint32_t shape_a, std::uint32_t shape_b);

// Returns whether two shapes collide, according to filters, body types, joints and listeners.
bool may_hit(const ToiState& state, std::uint32_t own, std::uint32_t other);

// Returns whether an impact has deflected the TOI body or the other body, whose TOI body is
// `other_index` (or none).
bool is_deflected(const ToiState& state, const ToiBody& t, std::uint32_t other_index);
// Returns whether the relative motion of a TOI body and another body is large enough for a sweep.
// Smaller motions are left to the contact solver; after an impact fewer of them, because contacts
// did not predict the new path.
bool needs_sweep(const ToiState& state, const ToiBody& t, std::uint32_t other_body);
// Returns whether the bounding spheres of two bodies stay apart until the first known impact of the
// TOI body. Rejects most candidates, without reading their shapes.
bool spheres_miss(const ToiState& state, const ToiBody& t, std::uint32_t other_body);

// Returns whether two touching shapes propagate an impact. They do until tuning::min_impact_chain
// of its speed is left. Further impacts, which would never end in a cluster with low restitution,
// are left to the contact solver.
bool continues_impact_chain(const ToiState& state, const ToiBody& t, std::uint32_t own,
                            std::uint32_t other);

// Returns whether two shapes have a manifold. Records the manifolds of the TOI body on first use.
bool has_manifold(const WorldState& world, ToiBody& t, std::uint32_t own, std::uint32_t other);
// Records the manifolds of a TOI body, as pair_key() of their shapes in any order.
void set_manifolds(ToiBody& t, const std::vector<std::uint64_t>& pairs);
// Returns whether the contact solver has resolved the impact of two shapes, which update_contacts
// predicted.
bool solver_has_resolved(const StepContext& step, ToiBody& t, std::uint32_t own,
                         std::uint32_t other);

// The gap at which the sweep of two bodies stops, m.
double sweep_gap_of(const BodyCold& cold, const BodyCold& other);

}  // namespace jostle::physics
