// SPDX-License-Identifier: MIT
#include "physics/src/stages/continuous/toi_body.h"

#include <cmath>

#include "jostle/base/check.h"
#include "physics/src/constraints/free_motion.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/state/contact_constraints.h"
#include "physics/src/state/shape_proxy.h"

namespace jostle::physics {
namespace {

// The torque-free spin of a body with another orientation and angular velocity.
FreeSpin spin_of(const WorldState& world, std::uint32_t body, Quat rotation, Vec3 w, double dt) {
    BodyWarm there = warm_of(world, body);
    there.rotation = rotation;
    there.axes = to_matrix(rotation);
    there.w = w;
    there.torque = {};
    return free_spin(there, world.bodies.cold[body], dt);
}
FreeSpin spin_at(const WorldState& world, const ToiBody& t, double fraction, double dt) {
    return spin_of(world, t.body, t.spin_rotation, t.spin, (fraction - t.spin_at) * dt);
}

bool is_gyroscopic(const BodyCold& cold) {
    return cold.type == BodyType::dynamic && !cold.isotropic && cold.locks == 0;
}

// Computes the leg that begins at sweep.from, for a body on which only forces act from there on.
void start_leg(const WorldState& world, ToiBody& t, double dt) {
    const BodyCold& cold = world.bodies.cold[t.body];
    const double from = t.sweep.from, left = 1 - from;
    t.swept_shapes.known = false;
    t.sweep.until = 1;
    if (t.fast && is_gyroscopic(cold) && t.spin != Vec3{} && t.legs < tuning::max_legs) {
        // At its midpoint, a constant rotation over h deviates by |dw/dt| h^2 / 8.
        const Mat3 axes = to_matrix(t.spin_rotation);
        const Vec3 w = transposed_times(axes, t.spin);
        const double bend = length(cold.inverse_inertia * cross(w, cold.inertia * w));
        const double legs = left * dt * square_root(bend / (8 * tuning::leg_error));
        if (legs > 1) t.sweep.until = from + left / std::ceil(legs);
    }
    const bool last = t.sweep.until == 1;
    const Quat to = last ? t.end_rotation : spin_at(world, t, t.sweep.until, dt).rotation;
    const double part = t.sweep.until - from;
    t.sweep.rotation_vector =
        part > 0 ? rotation_vector_between(t.sweep.rotation, to, t.spin * (part * dt)) * (1 / part)
                 : Vec3{};
}

// Ends the current sweep at a fraction of the step.
void record_path(const WorldState& world, ToiBody& t, double fraction) {
    if (world.shapes.triggers.empty() || fraction <= t.sweep.from) return;
    t.past.push_back(t.sweep);
    t.past.back().until = fraction;
}

}  // namespace

Sweep even_sweep(const BodyWarm& previous, const BodyWarm& now, double dt) {
    ASSERT(previous.body == now.body);
    const Vec3 turn = rotation_vector_between(previous.rotation, now.rotation, now.w * dt);
    return {0, previous.center, previous.rotation, now.center - previous.center, turn};
}

Speed speed_at(const WorldState& world, const ToiBody& t, double fraction, double dt) {
    Speed s{t.velocity + t.gain * (fraction - t.sweep.from), t.spin};
    if (!is_gyroscopic(world.bodies.cold[t.body])) return s;
    // The sweep rotates at a constant rate, a gyroscopic body does not. The spin is transferred in
    // the body's own axes: with a slightly wrong orientation the same angular momentum would give a
    // thousandfold spin about the thin axis of a rod.
    const FreeSpin free = spin_at(world, t, fraction, dt);
    s.w = rotate(rotation_at(t.sweep, fraction) * conjugate(free.rotation), free.w);
    return s;
}

bool is_supported(const WorldState& world, const BodyCold& cold) {
    if (cold.set != BodySet::awake || cold.asleep_in_place || cold.first_joint != none) return true;
    if (cold.constraints == 0) return false;
    bool touching = false;
    for_each_manifold(world.contacts, cold, [&](std::uint32_t contact) {
        touching = touching || world.contacts.contacts[contact].touching;
    });
    return touching;
}

Vec3 gain_in_free_fall(const WorldState& world, const BodyCold& cold, double dt) {
    if (cold.type != BodyType::dynamic) return {};
    return scaled(world.def.gravity * (cold.gravity_scale * dt), free_directions(cold));
}

void begin_toi(const WorldState& world, ToiBody& t, const BodyWarm& previous, double dt) {
    const BodyWarm& now = warm_of(world, t.body);
    const BodyCold& cold = world.bodies.cold[now.body];
    ASSERT(cold.set == BodySet::awake && !cold.asleep_in_place);
    t.sweep = even_sweep(previous, now, dt);
    t.end_rotation = now.rotation;
    t.end_spin = now.w;
    t.velocity = now.v;
    t.spin = now.w;
    t.spin_rotation = now.rotation;
    if (cold.type != BodyType::dynamic || cold.first_joint != none) return;
    // Contacts without impulse do not prevent free flight.
    const Vec3 fall = gain_in_free_fall(world, cold, dt);
    const double least = 1e-3;  // m/s
    t.held =
        cold.constraints > 0 && length(now.v - previous.v - fall) > least + 0.05 * length(fall);
    if (t.held) return;
    t.velocity = previous.v;
    t.gain = now.v - previous.v;
    t.spin_at = 0;
    t.spin = previous.w;
    t.spin_rotation = previous.rotation;
    start_leg(world, t, dt);
}

void next_leg(const WorldState& world, ToiBody& t, double dt) {
    const double at = t.sweep.until;
    ASSERT(at < 1);
    t.legs++;
    record_path(world, t, at);
    const FreeSpin free = spin_at(world, t, at, dt);
    t.velocity += t.gain * (at - t.sweep.from);
    t.sweep.center = center_at(t.sweep, at);
    t.sweep.rotation = t.spin_rotation = free.rotation;
    t.sweep.from = t.spin_at = at;
    t.spin = free.w;
    start_leg(world, t, dt);
}

void depart(const WorldState& world, ToiBody& t, double fraction, const Departure& from,
            double dt) {
    const BodyCold& cold = world.bodies.cold[t.body];
    ASSERT(cold.type == BodyType::dynamic && fraction >= 0 && fraction <= 1);
    const double left = 1 - fraction, time = left * dt;
    record_path(world, t, fraction);
    // From here on the body flies freely, even if it was held before. The next step's contacts take
    // over.
    const FreeSpin free = time > 0 ? spin_of(world, t.body, from.rotation, from.w, time)
                                   : FreeSpin{from.rotation, from.w};
    t.end_rotation = free.rotation;
    t.end_spin = free.w;
    t.spin_at = t.flies_from = fraction;
    t.spin = from.w;
    t.spin_rotation = from.rotation;
    t.velocity = from.v;
    const Vec3 mean = from.v + t.gain * (0.5 * left);
    t.sweep = {fraction, from.center, from.rotation, mean * dt, {}};
    t.swept_shapes.known = false;
    t.changed = true;
    if (is_exhausted(t)) {
        t.sweep.translation = {};
        return;
    }
    const double displacement = (length(from.v) + length(from.w) * cold.radius) * time;
    t.fast |= cold.continuous && displacement > tuning::sweep_fraction * cold.inner_radius;
    start_leg(world, t, dt);
}

bool is_exhausted(const ToiBody& t) {
    return t.impacts >= tuning::sweep_impacts;
}

void move_body_to(WorldState& world, std::uint32_t body, Vec3 center, Quat rotation, double dt) {
    const BodyCold& cold = world.bodies.cold[body];
    ASSERT(cold.set == BodySet::awake && !cold.asleep_in_place);
    BodyWarm& warm = warm_of(world, body);
    MotionBound& motion = world.bodies.motion[body];
    const double turned = 3.2 * cold.radius;  // at most half a turn
    motion.travel += length(center - warm.center) + turned;
    motion.turned += turned;
    warm.center = center;
    warm.rotation = rotation;
    warm.axes = to_matrix(warm.rotation);
    warm.sleep_time = 0;
    update_motion_bound(world, body, dt);
    // The solver integrated their gaps along another path.
    for_each_manifold(world.contacts, cold, [&](std::uint32_t contact) {
        const ContactLaneRef lane_ref = lane_ref_of(world.graph, world.contacts.contacts[contact]);
        lane_ref.meta->set(LaneFlag::needs_rebuild, lane_ref.lane, true);
    });
    for (std::uint32_t s = cold.first_shape; s != none; s = world.shapes.shapes[s].next)
        if (!fits_fat_aabb(world.shapes.shapes[s], warm, cold.radius, dt))
            enlarge_proxy(world, s, warm, dt);
}

void finish_toi(WorldState& world, const ToiBody& t, double dt) {
    ASSERT(t.changed);
    const bool stayed = is_exhausted(t);
    const double until = stayed ? t.sweep.from : 1;
    BodyWarm& warm = warm_of(world, t.body);
    warm.v = t.velocity + t.gain * (until - t.sweep.from);
    warm.w = stayed ? t.spin : t.end_spin;
    move_body_to(world, t.body, center_at(t.sweep, until),
                 stayed ? rotation_at(t.sweep, until) : t.end_rotation, dt);
}

}  // namespace jostle::physics
