// SPDX-License-Identifier: MIT
#include "physics/src/stages/continuous/update_dependents.h"

#include <algorithm>
#include <vector>

#include "jostle/base/check.h"
#include "physics/src/stages/continuous/start_toi_bodies.h"
#include "physics/src/stages/continuous/toi_motion.h"

namespace jostle::physics {
namespace {

// Returns whether a TOI body hits a body next, as far as is known.
bool hits_next(const ToiState& state, std::size_t index, std::uint32_t body) {
    const ToiBody& t = state.bodies[index];
    return t.fraction <= 1 && state.world.shapes.shapes[t.other_shape].body == body;
}

void refresh_candidates(ToiState& state, std::size_t index) {
    ToiBody& t = state.bodies[index];
    t.swept = swept_aabb_of(state.world, t);
    t.candidates.clear();
    if (t.fast) state.candidates.find(t.body, t.swept, t.candidates);
    state.candidates.set_swept_aabb(t.body, t.swept);
    request_search(state, index);
}

// Finds the other fast TOI bodies whose paths overlap that of a TOI body, sorted, and adds it to
// their candidates.
std::vector<std::uint32_t> find_fast_bodies_on_path(ToiState& state, std::size_t index) {
    std::vector<std::uint32_t> found;
    const std::uint32_t body = state.bodies[index].body;
    state.candidates.for_each_swept(state.bodies[index].swept, [&](std::uint32_t other) {
        const std::uint32_t known = state.index_of(other);
        if (other != body && known != none && state.bodies[known].fast) found.push_back(known);
    });
    std::sort(found.begin(), found.end());
    for (const std::uint32_t k : found) state.candidates.insert(body, state.bodies[k].candidates);
    return found;
}

}  // namespace

void update_dependents(ToiState& state, ImpactQueue& queue, std::size_t index) {
    ASSERT(index < state.bodies.size());
    refresh_candidates(state, index);
    const std::uint32_t body = state.bodies[index].body;
    const bool finds_others = searches(state, index);
    if (!finds_others) start_toi_bodies_in(state, state.bodies[index].swept);
    for (const std::uint32_t k : find_fast_bodies_on_path(state, index)) {
        const ToiBody& t = state.bodies[k];
        if (!t.checked || is_exhausted(t)) continue;
        if (hits_next(state, k, body))
            request_search(state, k);
        else if (!finds_others)
            request_search_for(state, k, body);
    }
    // Bodies that expected to hit it on its previous path.
    queue.take_dependents(body, [&](std::size_t k) {
        if (hits_next(state, k, body)) request_search(state, k);
    });
}

}  // namespace jostle::physics
