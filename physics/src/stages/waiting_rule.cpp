// SPDX-License-Identifier: MIT
#include "stages/waiting_rule.h"

#include "jostle/physics/tuning.h"
#include "state/links.h"

namespace jostle::physics {
namespace {

// What is left of a pair's slack, m, and how much of that this step may use up.
struct Slack {
    double left, next;
};

// Along a direction by what look() would see; else by the same bounds as look_ahead()'s, on their
// motion against each other.
Slack slack_of(const WorldState& world, const Waiting& w, double dt) {
    const BodyCold &a = world.bodies.cold[w.body_a], &b = world.bodies.cold[w.body_b];
    const BodyWarm &wa = warm_of(world, w.body_a), &wb = warm_of(world, w.body_b);
    const double turned = world.bodies.reach[w.body_a].turned + world.bodies.reach[w.body_b].turned;
    const double turning = length(wa.w) * a.radius + length(wb.w) * b.radius;
    const Vec3 kept = way_apart(w), apart = wb.center - wa.center, velocity = wb.v - wa.v;
    if (w.directed)
        return {w.budget + dot(kept, apart) - turned,
                dt * maximum(0, turning - dot(kept, velocity))};
    const auto force = [](const BodyWarm& warm, const BodyCold& cold) {
        return warm.force == Vec3{} ? 0 : length(warm.force) * cold.inverse_mass;
    };
    const double pull = 2 * length(world.def.gravity) + force(wa, a) + force(wb, b);
    return {w.budget - length(apart - kept) - turned,
            1.5 * dt * (length(velocity) + turning) + dt * dt * pull};
}

// Most new pairs are of bodies that fly along with each other: if the balls around them cannot
// touch in this step, the pair waits along their centres without a look. That happens once: a look
// ends pairs that have parted.
bool wait_as_balls(const WorldState& world, Waiting& w, double dt) {
    const BodyCold &a = world.bodies.cold[w.body_a], &b = world.bodies.cold[w.body_b];
    // What forces do not move may have a plane, which no ball holds.
    if (a.type != BodyType::dynamic || b.type != BodyType::dynamic) return false;
    const BodyWarm &wa = warm_of(world, w.body_a), &wb = warm_of(world, w.body_b);
    const Vec3 apart = wb.center - wa.center;
    const double distance = length(apart);
    const double slack =
        distance - a.radius - b.radius - tuning::speculative_margin - slack_held_back;
    if (slack <= 0) return false;
    const Vec3 direction = apart * (1 / distance);
    if (slack + dt * dot(direction, wb.v - wa.v) <= 0) return false;
    const BodyReach &ra = world.bodies.reach[w.body_a], &rb = world.bodies.reach[w.body_b];
    measure(w, apart, direction, slack, ra, rb);
    w.limit = ra.travel + rb.travel + slack;
    return true;
}

}  // namespace

bool is_due(const WorldState& world, Waiting& w, double dt) {
    const BodyReach &a = world.bodies.reach[w.body_a], &b = world.bodies.reach[w.body_b];
    if (a.reach + b.reach <= w.limit) return false;
    if (w.budget == Waiting::measured_by_limit) return !wait_as_balls(world, w, dt);
    const Slack slack = slack_of(world, w, dt);
    w.limit = a.travel + b.travel + slack.left;
    return slack.next > slack.left;
}

}  // namespace jostle::physics
