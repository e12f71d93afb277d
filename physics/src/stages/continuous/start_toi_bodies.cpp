// SPDX-License-Identifier: MIT
#include "physics/src/stages/continuous/start_toi_bodies.h"

#include <algorithm>

#include "jostle/base/check.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/contacts/find_clusters.h"
#include "physics/src/stages/continuous/ccd_policy.h"
#include "physics/src/stages/continuous/toi_motion.h"
#include "physics/src/stages/continuous/toi_policy.h"
#include "physics/src/stages/step_scratch.h"
#include "physics/src/state/separation_bounds.h"

namespace jostle::physics {

namespace {

class SweepCandidateFinder {
public:
    SweepCandidateFinder(StepContext& step, const SweptMotions& motions,
                         const std::vector<std::uint32_t>& fast)
        : step_(step),
          world_(step.world),
          motions_(motions),
          fast_(fast),
          scratch_(step.scratch.continuous) {}

    void run() {
        record_center_motions();
        if (scratch_.sweep_candidates.size() < fast_.size())
            scratch_.sweep_candidates.resize(fast_.size());
        if (scratch_.manifolds.size() < fast_.size()) scratch_.manifolds.resize(fast_.size());
        for (std::size_t k = 0; k < fast_.size(); k++) {
            scratch_.sweep_candidates[k].clear();
            scratch_.manifolds[k].clear();
        }
        const auto& bounds = world_.contacts.bounds;
        collect(
            bounds.size(), [&](std::size_t k) { return bounds[k].contact; },
            [&](std::size_t k) { return ends_within(bounds[k]); });
        std::vector<std::uint32_t>& held = scratch_.with_manifold;
        held.clear();
        for_each_colour(world_.graph.sets, [&](const GraphColour& colour) {
            for (const ContactConstraintWideMeta& meta : colour.metas)
                for (const std::uint32_t contact : meta.contact)
                    if (contact != none) held.push_back(contact);
        });
        collect(
            held.size(), [&](std::size_t k) { return held[k]; },
            [&](std::size_t k) { return ends_held(world_.contacts.contacts[held[k]]); });
    }

private:
    // Which bodies of a pair are fast and may have hit the other, and which are fast and have a
    // manifold.
    enum Ends : std::uint8_t { neither = 0, a = 1, b = 2, manifold_of_a = 4, manifold_of_b = 8 };

    // Start and end positions of all awake bodies in contiguous memory, because there are many
    // bounds.
    void record_center_motions() {
        const BodyStore& bodies = world_.bodies;
        scratch_.fast_body.assign(bodies.cold.size(), not_fast);
        for (std::size_t k = 0; k < fast_.size(); k++)
            scratch_.fast_body[bodies.awake[fast_[k]].body] = static_cast<std::uint32_t>(k);
        scratch_.center_motions.resize(bodies.cold.size());
        for (const BodyWarm& warm : bodies.awake)
            scratch_.center_motions[warm.body] = {motions_.of(world_, warm.body).center,
                                                  warm.center};
    }
    CenterMotion center_motion_of(std::uint32_t body) const {
        const BodyCold& cold = world_.bodies.cold[body];
        if (cold.set == BodySet::awake) return scratch_.center_motions[body];
        const Vec3 center = warm_of(world_, body).center;
        return {center, center};
    }
    std::uint32_t fast_index(std::uint32_t body) const { return scratch_.fast_body[body]; }

    // Tests pairs in parallel and records the results in order.
    template <class ContactOf, class EndsOf>
    void collect(std::size_t count, ContactOf&& contact_of, EndsOf&& ends) {
        std::vector<std::uint8_t>& found = scratch_.ends;
        found.resize(count);
        step_.thread_pool.run(static_cast<int>(count), tuning::bound_grain,
                              [&](int begin, int end) {
                                  for (auto k = static_cast<std::size_t>(begin);
                                       k < static_cast<std::size_t>(end); k++)
                                      found[k] = ends(k);
                              });
        for (std::size_t k = 0; k < count; k++) {
            if (found[k] == neither) continue;
            const Contact& c = world_.contacts.contacts[contact_of(k)];
            const std::uint64_t key = pair_key(c.shape_a, c.shape_b);
            const std::uint32_t of_a = fast_index(c.body_a), of_b = fast_index(c.body_b);
            if ((found[k] & a) != 0) scratch_.sweep_candidates[of_a].push_back(c.shape_b);
            if ((found[k] & b) != 0) scratch_.sweep_candidates[of_b].push_back(c.shape_a);
            if ((found[k] & manifold_of_a) != 0) scratch_.manifolds[of_a].push_back(key);
            if ((found[k] & manifold_of_b) != 0) scratch_.manifolds[of_b].push_back(key);
        }
    }

    std::uint8_t ends_within(const SeparationBound& bound) const {
        if (fast_index(bound.body_a) == not_fast && fast_index(bound.body_b) == not_fast)
            return neither;
        const CenterMotion wa = center_motion_of(bound.body_a), wb = center_motion_of(bound.body_b);
        if (stayed_apart(world_.bodies, bound, wb.from - wa.from, wb.to - wa.to)) return neither;
        return ends_of(world_.contacts.contacts[bound.contact]);
    }
    std::uint8_t ends_held(const Contact& c) const {
        const int held = (fast_index(c.body_a) != not_fast ? manifold_of_a : neither) |
                         (fast_index(c.body_b) != not_fast ? manifold_of_b : neither);
        return static_cast<std::uint8_t>(ends_of(c) | held);
    }
    std::uint8_t ends_of(const Contact& c) const {
        if (c.parent != none) return neither;  // its parent has a bound
        const auto may_collide = [&](std::uint32_t mover, std::uint32_t hit_body,
                                     std::uint32_t shape) {
            return fast_index(mover) != not_fast &&
                   motions_.may_collide(world_, motions_.of(world_, mover),
                                        world_.bodies.cold[mover], hit_body, shape,
                                        [&] { return bounces_alone(step_, c.shape_a, c.shape_b); });
        };
        return static_cast<std::uint8_t>(
            (may_collide(c.body_a, c.body_b, c.shape_b) ? a : neither) |
            (may_collide(c.body_b, c.body_a, c.shape_a) ? b : neither));
    }

    static constexpr std::uint32_t not_fast = 0xffffffff;

    StepContext& step_;
    const WorldState& world_;
    const SweptMotions& motions_;
    const std::vector<std::uint32_t>& fast_;
    ContinuousScratch& scratch_;
};

}  // namespace

void find_sweep_candidates(StepContext& step, const SweptMotions& motions,
                           const std::vector<std::uint32_t>& fast) {
    SweepCandidateFinder(step, motions, fast).run();
}

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
    const BodyDisplacement motion = state.motions.of(world, body);
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
