// SPDX-License-Identifier: MIT
#include "physics/src/stages/continuous/toi_policy.h"

#include <algorithm>

#include "jostle/base/check.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/continuous/ccd_policy.h"
#include "physics/src/stages/continuous/toi_motion.h"
#include "physics/src/state/contact_constraints.h"
#include "physics/src/state/contact_modifiers.h"
#include "physics/src/state/joint_graph.h"
#include "physics/src/state/pair_properties.h"

namespace jostle::physics {

void find_ignored_pairs(ToiState& state) {
    const ContactStore& contacts = state.world.contacts;
    for (const ContactModifier& modifier : contacts.modifiers) {
        ASSERT(modifier.contact < contacts.contacts.size());
        const Contact* pair = &contacts.contacts[modifier.contact];
        if (pair->parent != none) pair = &contacts.contacts[pair->parent];
        if (pass_through(state.world.contacts, *pair))
            state.ignored_pairs.push_back(pair_key(pair->shape_a, pair->shape_b));
    }
    std::sort(state.ignored_pairs.begin(), state.ignored_pairs.end());
}

void ignore_pair(ToiState& state, std::uint32_t shape_a, std::uint32_t shape_b) {
    state.ignored_pairs.push_back(pair_key(shape_a, shape_b));
    std::sort(state.ignored_pairs.begin(), state.ignored_pairs.end());
}

bool may_hit(const ToiState& state, std::uint32_t own, std::uint32_t other) {
    const WorldState& world = state.world;
    const ShapeRecord &a = world.shapes.shapes[own], &b = world.shapes.shapes[other];
    if (a.body == b.body || a.trigger || b.trigger || !may_collide(a.filter, b.filter))
        return false;
    const std::vector<std::uint64_t>& ignored = state.ignored_pairs;
    if (!ignored.empty() &&
        std::binary_search(ignored.begin(), ignored.end(), pair_key(own, other)))
        return false;
    const BodyType type_a = world.bodies.cold[a.body].type, type_b = world.bodies.cold[b.body].type;
    if (type_a != BodyType::dynamic && type_b != BodyType::dynamic) return false;
    return !joined_without_contact(world.bodies, world.joints, a.body, b.body);
}

bool is_deflected(const ToiState& state, const ToiBody& t, std::uint32_t other_index) {
    return t.changed || (other_index != none && state.bodies[other_index].changed);
}

bool needs_sweep(const ToiState& state, const ToiBody& t, std::uint32_t other_body) {
    const WorldState& world = state.world;
    const BodyCold &cold = world.bodies.cold[t.body], &other = world.bodies.cold[other_body];
    if (left_to_contacts(world, cold, other, state.any_bounces)) return false;
    const std::uint32_t known = state.index_of(other_body);
    const bool deflected = is_deflected(state, t, known);
    if (deflected && other.type != BodyType::dynamic) return true;
    double least = tuning::sweep_share * motion_without_sweep(cold, other);
    if (deflected)
        least = tuning::sweep_share_after_impact * tuning::sweep_fraction *
                minimum(cold.inner_radius, other.inner_radius);
    const double displacement = max_relative_displacement(
        {t.sweep.center, t.sweep.translation, t.sweep.rotation_vector, cold.radius},
        remaining_motion_of(state, other_body));
    return displacement * (1 - t.sweep.from) > least;
}

bool spheres_miss(const ToiState& state, const ToiBody& t, std::uint32_t other_body) {
    const WorldState& world = state.world;
    const BodyCold &cold = world.bodies.cold[t.body], &other = world.bodies.cold[other_body];
    if (other.type != BodyType::dynamic) return false;
    const std::uint32_t known = state.index_of(other_body);
    Vec3 center, translation;
    double from = 0, until = minimum(t.fraction, t.sweep.until);
    double reach = cold.radius + other.radius + 2 * tuning::sweep_gap;
    if (known != none) {
        const Sweep& sweep = state.bodies[known].sweep;
        center = sweep.center, translation = sweep.translation;
        from = sweep.from, until = minimum(until, sweep.until);
    } else {
        const BodyDisplacement motion = state.motions.of(world, other_body);
        center = motion.center, translation = motion.translation;
        // An upper bound of the distance between the path of a free body and its chord.
        reach += length(gain_in_free_fall(world, other, state.step.dt)) * state.step.dt;
    }
    const double start = maximum(t.sweep.from, from);
    if (start > until) return false;
    const Vec3 apart = (center + translation * (start - from)) - center_at(t.sweep, start);
    const Vec3 motion = translation - t.sweep.translation;
    const double nearest =
        clamp(-dot(apart, motion) / maximum(length_squared(motion), 1e-30), 0, until - start);
    return length_squared(apart + motion * nearest) > reach * reach;
}

bool continues_impact_chain(const ToiState& state, const ToiBody& t, std::uint32_t own,
                            std::uint32_t other) {
    const ShapeRecord &a = state.world.shapes.shapes[own], &b = state.world.shapes.shapes[other];
    const double restitution = pair_restitution(a.material, b.material);
    const std::uint32_t known = state.index_of(b.body);
    const int impacts = std::max(t.impact_chain_length,
                                 known == none ? 0 : state.bodies[known].impact_chain_length);
    double speed = 1;  // fraction of that of the first impact
    for (int k = 0; k < impacts; k++) speed *= restitution;
    return speed > tuning::min_impact_chain;
}

bool has_manifold(const WorldState& world, ToiBody& t, std::uint32_t own, std::uint32_t other) {
    const BodyCold& cold = world.bodies.cold[t.body];
    if (cold.constraints == 0) return false;
    if (!t.manifolds_known) {
        std::vector<std::uint64_t> pairs;
        for_each_manifold(world.contacts, cold, [&](std::uint32_t contact) {
            const Contact& c = world.contacts.contacts[contact];
            pairs.push_back(pair_key(c.shape_a, c.shape_b));
        });
        set_manifolds(t, pairs);
    }
    return std::binary_search(t.manifolds.begin(), t.manifolds.end(), pair_key(own, other));
}

void set_manifolds(ToiBody& t, const std::vector<std::uint64_t>& pairs) {
    t.manifolds_known = true;
    t.manifolds = pairs;
    std::sort(t.manifolds.begin(), t.manifolds.end());
}

bool solver_has_resolved(const StepContext& step, ToiBody& t, std::uint32_t own,
                         std::uint32_t other) {
    return uses_speculative_contact(step, own, other) && has_manifold(step.world, t, own, other);
}

double sweep_gap_of(const BodyCold& cold, const BodyCold& other) {
    return tuning::sweep_gap * size_scale(size_of_pair(cold, other));
}

}  // namespace jostle::physics
