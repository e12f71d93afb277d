// SPDX-License-Identifier: MIT
#include "physics/src/stages/continuous/toi_state.h"

#include <utility>

namespace jostle::physics {
namespace {

bool is_fast(const FinalizeScratch& finalize, std::uint32_t awake) {
    return finalize.fast[awake] != 0 && finalize.not_finite[awake] == 0;
}

void enqueue(ToiState& state, std::size_t index) {
    ToiBody& t = state.bodies[index];
    if (t.fast && !t.queued) state.to_search.push_back(index);
    t.queued = t.fast;
}

}  // namespace

ToiState::ToiState(StepContext& context)
    : step(context),
      world(context.world),
      finalize(context.scratch.finalize),
      any_bounces(!context.scratch.contacts.bouncing.empty()) {
    const std::size_t awake_count = finalize.fast.size();
    ASSERT(awake_count == world.bodies.awake.size());
    ASSERT(finalize.not_finite.size() == awake_count && finalize.deflected.size() == awake_count);
    std::vector<std::uint32_t> known;
    for (std::uint32_t awake = 0; awake < awake_count; awake++) {
        if (is_fast(finalize, awake)) fast.push_back(awake);
        if (is_fast(finalize, awake) || finalize.deflected[awake] != 0) known.push_back(awake);
    }
    motions.note(step, known, [&](std::uint32_t awake) {
        return even_sweep(finalize.previous[awake], world.bodies.awake[awake], step.dt);
    });
}

std::size_t add_toi_body(ToiState& state, std::uint32_t body, bool fast) {
    WorldState& world = state.world;
    ASSERT(body < world.bodies.cold.size());
    if (state.where.empty()) state.where.resize(world.bodies.cold.size(), none);
    ASSERT(state.where[body] == none);
    const std::size_t index = state.bodies.size();
    state.where[body] = static_cast<std::uint32_t>(index);
    ToiBody t;
    t.body = body;
    t.fast = fast;
    if (!fast && state.any_bounces) {
        const BodyCold& cold = world.bodies.cold[body];
        t.held = is_supported(world, cold);
        if (!t.held) t.gain = gain_in_free_fall(world, cold, state.step.dt);
    }
    state.bodies.push_back(std::move(t));
    enqueue(state, index);
    return index;
}

bool searches(const ToiState& state, std::size_t index) {
    return state.bodies[index].fast && !is_exhausted(state.bodies[index]);
}

void request_search(ToiState& state, std::size_t index) {
    state.bodies[index].checked = false;
    enqueue(state, index);
}

void request_search_for(ToiState& state, std::size_t index, std::uint32_t deflected_body) {
    ASSERT(state.bodies[index].body != deflected_body);
    state.bodies[index].deflected_bodies.push_back(deflected_body);
    enqueue(state, index);
}

}  // namespace jostle::physics
