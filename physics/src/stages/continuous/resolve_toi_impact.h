// SPDX-License-Identifier: MIT
//
// Resolves the first impact of a TOI body at its time. Part of solve_continuous.
#pragma once

#include <optional>
#include <vector>

#include "physics/src/constraints/impact.h"
#include "physics/src/stages/continuous/toi_state.h"

namespace jostle::physics {

// A body after an impact.
struct DeflectedBody {
    std::uint32_t body = none;
    Quat rotation;  // at the impact
    ImpactBody after;
};
struct ResolvedImpact {
    double at = 0;  // fraction of the step
    bool bounced = false;
    DeflectedBody a, b;  // not yet on their new paths
};

// A body before the impact, with its mass at its pose there.
DeflectedBody body_at_impact(const ToiState& state, std::uint32_t body, double at);
// The materials of two shapes, as changed by listeners.
ContactModifier modifier_at_impact(const WorldState& world, std::uint32_t own, std::uint32_t other,
                                   const ImpactBody& a, const ImpactBody& b,
                                   const std::vector<ImpactPoint>& points);
// A sleeping body wakes after all impacts are resolved, with as much of its surroundings as the
// momentum of the other body moves.
void request_wake(WorldState& world, std::uint32_t body, std::uint32_t hit_body);
void report_impact(ToiState& state, std::uint32_t own, std::uint32_t other, const HardestPoint& hit,
                   bool bounces);

// Computes the velocities after the impact, reports it, and requests to wake a sleeping body.
// Returns nothing if a listener disabled the collision of the two shapes, which then ignore each
// other for the rest of the step.
std::optional<ResolvedImpact> resolve_toi_impact(ToiState& state, std::size_t index);

// Moves one of the two bodies on with its new velocity; it becomes a TOI body. Returns its index,
// or nothing if impulses cannot move it: it then keeps its path.
std::optional<std::size_t> continue_after(ToiState& state, const ResolvedImpact& impact,
                                          const DeflectedBody& deflected);

}  // namespace jostle::physics
