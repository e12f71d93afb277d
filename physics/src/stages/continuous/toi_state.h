// SPDX-License-Identifier: MIT
//
// Data of solve_continuous within one step. A TOI body is a body that is swept or was deflected by
// an impact; all other bodies move as the step computed. find_impacts, resolve_toi_impact and
// update_dependents read and write it, one after the other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "jostle/base/check.h"
#include "physics/src/stages/continuous/ccd_candidates.h"
#include "physics/src/stages/continuous/swept_motions.h"
#include "physics/src/stages/continuous/toi_body.h"
#include "physics/src/stages/step_context.h"
#include "physics/src/stages/step_scratch.h"

namespace jostle::physics {

struct ToiState {
    // Lists the fast bodies and records the motions of the step.
    explicit ToiState(StepContext& context);
    ToiState(const ToiState&) = delete;
    ToiState& operator=(const ToiState&) = delete;

    // Index of the TOI body of a body, or none.
    std::uint32_t index_of(std::uint32_t body) const {
        ASSERT(where.empty() || body < where.size());
        return where.empty() ? none : where[body];
    }

    StepContext& step;
    WorldState& world;
    const FinalizeScratch& finalize;  // how the step moved the awake bodies
    const bool any_bounces;           // some bodies may bounce in this step
    std::vector<std::uint32_t> fast;  // awake indices, sorted
    SweptMotions motions;             // over the whole step
    CcdCandidates candidates{world, finalize.previous, fast};
    std::vector<ToiBody> bodies;
    std::vector<std::uint32_t> where;  // by body: index of its TOI body; empty before the first
    std::vector<std::size_t>
        to_search;                   // TOI bodies with ToiBody::queued, in the order of requests
    std::uint32_t search_round = 0;  // number of calls of find_impacts
    std::vector<std::uint64_t> ignored_pairs;  // pair_key() of shapes without collision, sorted
    std::vector<ContactBegin> bounces;         // to be reported
};

// Adds a TOI body for a body that has none, and returns its index. A fast body is searched for
// impacts.
std::size_t add_toi_body(ToiState& state, std::uint32_t body, bool fast);

// Returns whether a TOI body searches for impacts after each change of its path.
bool searches(const ToiState& state, std::size_t index);

// Lets find_impacts search the whole remaining path of a TOI body again.
void request_search(ToiState& state, std::size_t index);
// Lets find_impacts test a TOI body, whose first impact is known, against a deflected body.
void request_search_for(ToiState& state, std::size_t index, std::uint32_t deflected_body);

}  // namespace jostle::physics
