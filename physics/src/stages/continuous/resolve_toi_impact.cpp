// SPDX-License-Identifier: MIT
#include "physics/src/stages/continuous/resolve_toi_impact.h"

#include <utility>

#include "jostle/base/check.h"
#include "physics/src/foundation/size_scale.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/contacts/call_contact_listeners.h"
#include "physics/src/stages/continuous/bounce_events.h"
#include "physics/src/stages/continuous/toi_motion.h"
#include "physics/src/stages/continuous/toi_policy.h"
#include "physics/src/state/contact_constraints.h"
#include "physics/src/state/contact_modifiers.h"

namespace jostle::physics {
namespace {

void report_hit(WorldState& world, std::uint32_t own, std::uint32_t other,
                const HardestPoint& hit) {
    if (hit.approach < world.def.hit_speed || hit.approach <= 0) return;
    const std::vector<ShapeRecord>& shapes = world.shapes.shapes;
    world.events.hits.push_back({shape_id(world.shapes, own), shape_id(world.shapes, other),
                                 body_id(world.bodies, shapes[own].body),
                                 body_id(world.bodies, shapes[other].body), hit.point.position,
                                 hit.point.normal, hit.approach});
}

// An impact without approach on a body that has used up its impacts stops the TOI body too: it
// would be hit again and again.
void count_impact(ToiState& state, ToiBody& t, std::uint32_t other_body, const HardestPoint& hit) {
    const std::uint32_t other = state.index_of(other_body);
    if (hit.approach <= 0 && other != none && is_exhausted(state.bodies[other]))
        t.impacts = tuning::sweep_impacts;
    else
        t.impacts++;
}

// Returns whether a velocity separates a body from everything that touches it.
bool leaves_support(const ToiState& state, std::uint32_t body, Vec3 v, double at) {
    const WorldState& world = state.world;
    const double least = 0.05 * size_scale(world.bodies.cold[body].radius);  // m/s
    bool leaves = true;
    for_each_manifold(world.contacts, world.bodies.cold[body], [&](std::uint32_t contact) {
        const Contact& c = world.contacts.contacts[contact];
        if (!leaves || !c.touching) return;
        const bool is_a = c.body_a == body;
        const Vec3 u = speed_of(state, is_a ? c.body_b : c.body_a, at).v - v;
        const ContactLaneRef lane_ref = lane_ref_of(world.graph, c);
        leaves = dot(normal_of(lane_ref), u) * (is_a ? 1 : -1) > least;
    });
    return leaves;
}

}  // namespace

DeflectedBody body_at_impact(const ToiState& state, std::uint32_t body, double at) {
    const WorldState& world = state.world;
    const Sweep path = sweep_of(state, body);
    const BodyCold& cold = world.bodies.cold[body];
    BodyWarm warm = warm_of(world, body);
    warm.rotation = rotation_at(path, at);
    warm.axes = to_matrix(warm.rotation);
    const Speed speed = speed_of(state, body, at);
    DeflectedBody result{
        .body = body,
        .rotation = warm.rotation,
        .after = {.center = center_at(path, at), .inverse_mass = {}, .v = speed.v, .w = speed.w}};
    if (cold.inverse_mass == 0) return result;
    result.after.inverse_mass = free_directions(cold) * cold.inverse_mass;
    result.after.inverse_inertia = world_inverse_inertia(warm, cold);
    return result;
}

ContactModifier modifier_at_impact(const WorldState& world, std::uint32_t own, std::uint32_t other,
                                   const ImpactBody& a, const ImpactBody& b,
                                   const std::vector<ImpactPoint>& points) {
    const ContactModifier modifier = material_modifier(world, own, other);
    if (!has_pre_solve_listeners(world.listeners) || points.empty()) return modifier;
    Vec3 point;
    for (const ImpactPoint& p : points)
        point += p.position * (1.0 / static_cast<double>(points.size()));
    const Vec3 va = a.v + cross(a.w, point - a.center), vb = b.v + cross(b.w, point - b.center);
    return call_contact_listeners(world.listeners, world,
                                  {own, other, points.front().normal, point, vb - va}, modifier);
}

void request_wake(WorldState& world, std::uint32_t body, std::uint32_t hit_body) {
    const BodyCold& cold = world.bodies.cold[hit_body];
    if (cold.set != BodySet::sleeping && !cold.asleep_in_place) return;
    const double momentum = world.bodies.cold[body].mass * length(warm_of(world, body).v);
    world.wake_requests.push_back({hit_body, mass_to_wake(momentum)});
}

void report_impact(ToiState& state, std::uint32_t own, std::uint32_t other, const HardestPoint& hit,
                   bool bounces) {
    report_hit(state.world, own, other, hit);
    report_impulse(state.world, own, other, hit);
    if (bounces && hit.approach > bounce_speed(state.world.def.gravity, state.step.dt))
        note_bounce(state.world, own, other, hit, state.bounces);
}

std::optional<ResolvedImpact> resolve_toi_impact(ToiState& state, std::size_t index) {
    WorldState& world = state.world;
    ToiBody& t = state.bodies[index];
    const double at = t.fraction;
    ASSERT(at >= t.sweep.from && at <= t.sweep.until && at <= 1);
    ASSERT(searches(state, index));
    const std::uint32_t own = t.own_shape, other = t.other_shape;
    const std::uint32_t other_body = world.shapes.shapes[other].body;
    std::vector<ImpactPoint> points = std::move(t.points);
    ASSERT(!points.empty());
    ResolvedImpact impact{.at = at,
                          .a = body_at_impact(state, t.body, at),
                          .b = body_at_impact(state, other_body, at)};
    ImpactBody &a = impact.a.after, &b = impact.b.after;
    const ContactModifier modifier = modifier_at_impact(world, own, other, a, b, points);
    if (!modifier.enabled) {
        ignore_pair(state, own, other);
        request_search(state, index);
        return std::nullopt;
    }
    impact.bounced = modifier.restitution > 0;
    world.profile.impacts++;
    request_wake(world, t.body, other_body);
    if (impact.bounced && !t.at_start)
        put_on_parabolas(a, fall_of(state, t.body), b, fall_of(state, other_body), points, at,
                         state.step.dt);
    const HardestPoint hit = resolve_impact(a, b, points, modifier.restitution, modifier.friction,
                                            bounce_speed(world.def.gravity, state.step.dt));
    report_impact(state, own, other, hit, impact.bounced);
    count_impact(state, t, other_body, hit);
    request_search(state, index);
    return impact;
}

std::optional<std::size_t> continue_after(ToiState& state, const ResolvedImpact& impact,
                                          const DeflectedBody& deflected) {
    const ImpactBody& after = deflected.after;
    if (after.inverse_mass == Vec3{} && after.inverse_inertia == diagonal({0, 0, 0}))
        return std::nullopt;
    const std::uint32_t body = deflected.body, known = state.index_of(body);
    const Sweep path = sweep_of(state, body);
    const std::size_t index = known == none ? add_toi_body(state, body, false) : known;
    ToiBody& t = state.bodies[index];
    t.sweep = path;
    const BodyCold& cold = state.world.bodies.cold[body];
    if (impact.bounced) {
        t.fast |= cold.continuous;  // it may bounce off another body next
        t.impact_chain_length++;
        if (t.held && cold.first_joint == none && leaves_support(state, body, after.v, impact.at)) {
            t.held = false;
            t.gain = gain_in_free_fall(state.world, cold, state.step.dt);
        }
    }
    depart(state.world, t, impact.at, {after.center, deflected.rotation, after.v, after.w},
           state.step.dt);
    return index;
}

}  // namespace jostle::physics
