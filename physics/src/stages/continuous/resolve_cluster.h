// SPDX-License-Identifier: MIT
//
// Resolves an impact on bodies that touch others: the impact and all impacts that it causes at the
// same time, together (constraints/impact_cluster.h). One by one, their result would depend on
// their order. Part of solve_continuous.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "physics/src/stages/continuous/resolve_toi_impact.h"

namespace jostle::physics {

// The bodies that the impacts deflect.
struct ResolvedCluster {
    ResolvedImpact impact;  // of the first pair
    std::vector<DeflectedBody> bodies;
};

// Resolves the first impact of a TOI body if it bounces and one of the two bodies touches two
// others off which it bounces. Otherwise changes nothing and returns nothing.
std::optional<ResolvedCluster> resolve_cluster(ToiState& state, std::size_t index);

}  // namespace jostle::physics
