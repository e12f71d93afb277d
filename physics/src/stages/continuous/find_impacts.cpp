// SPDX-License-Identifier: MIT
#include "physics/src/stages/continuous/find_impacts.h"

#include <algorithm>

#include "jostle/base/check.h"
#include "physics/src/stages/continuous/sweep_against.h"

namespace jostle::physics {
namespace {

// Returns whether the TOI body of another body sweeps this pair in the same round, which suffices.
bool is_swept_by_other(const ToiState& state, std::size_t index, std::uint32_t other_body) {
    const std::uint32_t known = state.index_of(other_body);
    if (known == none || known >= index ||
        state.bodies[known].full_search_round != state.search_round)
        return false;
    const WorldState& world = state.world;
    const std::vector<std::uint32_t>& candidates = state.bodies[known].candidates;
    for (std::uint32_t s = world.bodies.cold[state.bodies[index].body].first_shape; s != none;
         s = world.shapes.shapes[s].next)
        if (!world.shapes.shapes[s].trigger &&
            !std::binary_search(candidates.begin(), candidates.end(), s))
            return false;
    return searches(state, known);
}

// Finds the first impact on the remaining path.
void search_path(const ToiState& state, std::size_t index, ToiBody& t) {
    t.fraction = Impact::never;
    if (!searches(state, index)) return;
    for (const std::uint32_t shape : t.candidates)
        if (!is_swept_by_other(state, index, state.world.shapes.shapes[shape].body))
            sweep_against(state, t, shape);
}

// Tests whether bodies that were deflected since the last search are hit before the known impact.
void search_deflected(const ToiState& state, ToiBody& t) {
    const WorldState& world = state.world;
    for (const std::uint32_t body : t.deflected_bodies)
        for (std::uint32_t s = world.bodies.cold[body].first_shape; s != none;
             s = world.shapes.shapes[s].next)
            sweep_against(state, t, s);
}

void find_impact(ToiState& state, std::size_t index) {
    ToiBody& t = state.bodies[index];
    ASSERT(t.fast && t.queued);
    if (t.checked)
        search_deflected(state, t);
    else
        search_path(state, index, t);
    t.checked = true;
    t.queued = false;
    t.deflected_bodies.clear();
}

}  // namespace

void find_impacts(ToiState& state, ImpactQueue& queue) {
    state.search_round++;
    const std::vector<std::size_t>& to_search = state.to_search;
    for (const std::size_t k : to_search) {
        ToiBody& t = state.bodies[k];
        if (!t.checked) t.full_search_round = state.search_round;
        state.world.profile.sweeps +=
            static_cast<int>(t.checked ? t.deflected_bodies.size() : t.candidates.size());
    }
    state.step.thread_pool.run(static_cast<int>(to_search.size()), 1, [&](int begin, int end) {
        for (int k = begin; k < end; k++)
            find_impact(state, to_search[static_cast<std::size_t>(k)]);
    });
    for (const std::size_t k : to_search) queue.update(state, k);
    state.to_search.clear();
}

}  // namespace jostle::physics
