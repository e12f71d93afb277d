// SPDX-License-Identifier: MIT
#include "physics/src/stages/continuous/start_toi_bodies.h"

#include <algorithm>

#include "jostle/base/check.h"
#include "physics/src/stages/contacts/find_clusters.h"
#include "physics/src/stages/continuous/find_sweep_candidates.h"
#include "physics/src/stages/continuous/toi_motion.h"
#include "physics/src/stages/continuous/toi_policy.h"

namespace jostle::physics {
namespace {

bool left_predicted_aabb(const ToiState& state, const ToiBody& t) {
    const BodyCold& cold = state.world.bodies.cold[t.body];
    ASSERT(cold.set == BodySet::awake && cold.at < state.finalize.left_predicted_aabb.size());
    return state.finalize.left_predicted_aabb[cold.at] != 0;
}

// Initializes a TOI body with the candidates among its contacts, if it is on its predicted path.
void begin_path(const ToiState& state, ToiBody& t, const std::vector<std::uint32_t>& candidates) {
    const WorldState& world = state.world;
    begin_toi(world, t, state.finalize.previous[world.bodies.cold[t.body].at], state.step.dt);
    t.swept = swept_aabb_of(world, t);
    if (left_predicted_aabb(state, t)) return;
    t.candidates = candidates;
    state.candidates.tidy(t.body, t.candidates);
}

void search_trees(ToiState& state, ToiBody& t) {
    if (left_predicted_aabb(state, t)) state.candidates.find(t.body, t.swept, t.candidates);
}

// Finds the shapes among a fast body's contacts that it may hit.
void find_candidates_in_contacts(const ToiState& state, std::uint32_t body,
                                 std::vector<std::uint32_t>& candidates) {
    candidates.clear();
    const WorldState& world = state.world;
    const BodyCold& cold = world.bodies.cold[body];
    const SweptMotion motion = state.motions.of(world, body);
    const auto& contacts = world.contacts.contacts;
    for (std::uint32_t edge = cold.first_edge; edge != none;) {
        ASSERT(edge / 2 < contacts.size());
        const Contact& c = contacts[edge / 2];
        edge = c.next[edge % 2];
        if (c.parent != none) continue;
        const bool is_a = c.body_a == body;
        const std::uint32_t other_shape = is_a ? c.shape_b : c.shape_a;
        const std::uint32_t other_body = is_a ? c.body_b : c.body_a;
        if (state.motions.may_collide(world, motion, cold, other_body, other_shape, [&] {
                return bounces_alone(state.step, c.shape_a, c.shape_b);
            }))
            candidates.push_back(other_shape);
    }
}

}  // namespace

void start_toi_bodies(ToiState& state) {
    StepContext& step = state.step;
    WorldState& world = state.world;
    find_sweep_candidates(step, state.motions, state.fast);
    const ContinuousScratch& found = step.scratch.continuous;
    ASSERT(found.sweep_candidates.size() >= state.fast.size());
    ASSERT(found.manifolds.size() >= state.fast.size());
    std::vector<std::size_t> starting;  // by TOI body: index of the fast body
    for (std::size_t k = 0; k < state.fast.size(); k++)
        if (!found.sweep_candidates[k].empty() ||
            state.finalize.left_predicted_aabb[state.fast[k]] != 0)
            starting.push_back(k);
    if (starting.empty()) return;
    state.bodies.reserve(starting.size() + starting.size() / 4);
    for (const std::size_t k : starting)
        add_toi_body(state, world.bodies.awake[state.fast[k]].body, true);
    step.thread_pool.run(static_cast<int>(starting.size()), 8, [&](int begin, int end) {
        for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); k++) {
            begin_path(state, state.bodies[k], found.sweep_candidates[starting[k]]);
            set_manifolds(state.bodies[k], found.manifolds[starting[k]]);
        }
    });
    step.thread_pool.finish();  // finalize updates the trees until here
    world.shapes.statics->flush();
    for (ToiBody& t : state.bodies) search_trees(state, t);
}

void start_toi_bodies_in(ToiState& state, Aabb box) {
    std::vector<std::uint32_t> bodies;
    state.candidates.for_each_swept(box, [&](std::uint32_t body) {
        if (state.index_of(body) == none) bodies.push_back(body);
    });
    std::sort(bodies.begin(), bodies.end());
    std::vector<std::uint32_t> candidates;
    for (const std::uint32_t body : bodies) {
        ToiBody& t = state.bodies[add_toi_body(state, body, true)];
        find_candidates_in_contacts(state, body, candidates);
        begin_path(state, t, candidates);
        search_trees(state, t);
    }
}

}  // namespace jostle::physics
