// SPDX-License-Identifier: MIT
#include "physics/src/state/separation_bounds.h"

#include "jostle/base/check.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/geometry/support.h"
#include "physics/src/math/is_unit.h"
#include "physics/src/state/contact_store.h"
#include "physics/src/state/pair_properties.h"

namespace jostle::physics {

void set_separation_bound(SeparationBound& w, Vec3 apart, Vec3 direction, double slack,
                          const MotionBound& a, const MotionBound& b) {
    w.directed = direction != Vec3{};
    const Vec3 retained = w.directed ? direction : apart;
    ASSERT(!w.directed || is_unit(direction));
    for (int k = 0; k < 3; k++) w.apart[k] = static_cast<float>(retained[k]);
    w.budget = slack + a.turned + b.turned - (w.directed ? dot(direction_of(w), apart) : 0);
}

void add_separation_bound(const BodySets& sets, ContactStore& contacts, std::uint32_t contact,
                          double slack, Vec3 direction) {
    Contact& c = contacts.contacts[contact];
    ASSERT(contacts.ids.alive(contact) && c.parent == none && c.colour < 0);
    ASSERT(contacts.bounds.size() < contacts.contacts.size() || c.has_bound);
    c.dormant = false;
    if (c.has_bound) return;  // it was dormant: retains its position and limit
    c.has_bound = true;
    const MotionBound &a = sets.bodies.motion[c.body_a], &b = sets.bodies.motion[c.body_b];
    SeparationBound w{.contact = contact, .body_a = c.body_a, .body_b = c.body_b};
    w.limit = a.travel + b.travel + slack;
    const Vec3 apart = warm_of(sets, c.body_b).center - warm_of(sets, c.body_a).center;
    const double scale = scale_of_pair(sets.bodies, c);
    if (slack >= 0 && length_squared(apart) <= 1e6 * scale * scale)
        set_separation_bound(w, apart, direction, slack - tuning::slack_reserve * scale, a, b);
    c.limit = w.limit;
    contacts.bounds.push_back(w);
}

void resume_separation_bound(ContactStore& contacts, std::uint32_t contact) {
    Contact& c = contacts.contacts[contact];
    ASSERT(contacts.ids.alive(contact) && c.parent == none && c.colour < 0);
    c.dormant = false;
    if (c.has_bound) return;
    c.has_bound = true;
    contacts.bounds.push_back(
        {.contact = contact, .body_a = c.body_a, .body_b = c.body_b, .limit = c.limit});
}

namespace {

// The remaining slack of a pair, and how much of it the next step may use, m.
struct Slack {
    double left, next;
};

// Along a direction if there is one, otherwise with the bounds of update_motion_bound() applied to
// the relative motion.
Slack slack_of(const BodySets& sets, const WorldDef& def, const SeparationBound& w, double dt) {
    const BodyCold &a = sets.bodies.cold[w.body_a], &b = sets.bodies.cold[w.body_b];
    const BodyWarm &wa = warm_of(sets, w.body_a), &wb = warm_of(sets, w.body_b);
    const double turned = sets.bodies.motion[w.body_a].turned + sets.bodies.motion[w.body_b].turned;
    const double turning = length(wa.w) * a.radius + length(wb.w) * b.radius;
    const Vec3 retained = direction_of(w), apart = wb.center - wa.center, velocity = wb.v - wa.v;
    if (w.directed)
        return {w.budget + dot(retained, apart) - turned,
                dt * maximum(0, turning - dot(retained, velocity))};
    const auto force = [](const BodyWarm& warm, const BodyCold& cold) {
        return warm.force == Vec3{} ? 0 : length(warm.force) * cold.inverse_mass;
    };
    const double pull = 2 * length(def.gravity) + force(wa, a) + force(wb, b);
    return {w.budget - length(apart - retained) - turned,
            1.5 * dt * (length(velocity) + turning) + dt * dt * pull};
}

// Most new pairs consist of bodies that move in parallel. If their bounding spheres cannot touch in
// this step, the pair gets a bound along the centres without a narrow-phase test. This happens
// once: a test ends pairs that have separated.
bool bound_by_spheres(const BodySets& sets, SeparationBound& w, double dt) {
    const BodyCold &a = sets.bodies.cold[w.body_a], &b = sets.bodies.cold[w.body_b];
    // Other bodies may have a plane, which has no bounding sphere.
    if (a.type != BodyType::dynamic || b.type != BodyType::dynamic) return false;
    const BodyWarm &wa = warm_of(sets, w.body_a), &wb = warm_of(sets, w.body_b);
    const Vec3 apart = wb.center - wa.center;
    const double distance = length(apart), scale = size_scale(size_of_pair(a, b));
    const double slack = distance - a.radius - b.radius - tuning::speculative_margin * scale -
                         tuning::slack_reserve * scale;
    if (slack <= 0) return false;
    ASSERT(distance > 0);
    const Vec3 direction = apart * (1 / distance);
    if (slack + dt * dot(direction, wb.v - wa.v) <= 0) return false;
    const MotionBound &ra = sets.bodies.motion[w.body_a], &rb = sets.bodies.motion[w.body_b];
    set_separation_bound(w, apart, direction, slack, ra, rb);
    w.limit = ra.travel + rb.travel + slack;
    return true;
}

}  // namespace

bool is_due(const BodySets& sets, const WorldDef& def, SeparationBound& w, double dt) {
    const MotionBound &a = sets.bodies.motion[w.body_a], &b = sets.bodies.motion[w.body_b];
    if (a.bound + b.bound <= w.limit) return false;
    if (w.budget == SeparationBound::not_measured) return !bound_by_spheres(sets, w, dt);
    const Slack slack = slack_of(sets, def, w, dt);
    w.limit = a.travel + b.travel + slack.left;
    return slack.next > slack.left;
}

namespace {

// How far a shape extends along n from the centre of mass of its body, m.
double reach_along(const ShapeRecord& shape, const BodyWarm& body, Vec3 n) {
    const Convex convex = convex_of({&shape.geometry, body.axes * shape.offset,
                                     shape.aligned ? body.axes : body.axes * shape.axes},
                                    {});
    return dot(support(convex, n), n) + convex.radius * length(n);
}

}  // namespace

bool renew_separation_bound(const ContactGraph& stores, SeparationBound& w, double dt) {
    if (!w.directed || w.budget == SeparationBound::not_measured || stores.def.planar) return false;
    const Contact& c = stores.contacts.contacts[w.contact];
    const ShapeRecord &sa = stores.shapes.shapes[c.shape_a], &sb = stores.shapes.shapes[c.shape_b];
    // The narrow phase ends pairs whose boxes have parted.
    if (c.composite || is_plane(sb) || !overlap(sa.fat, sb.fat)) return false;
    const BodyWarm &a = warm_of(stores, w.body_a), &b = warm_of(stores, w.body_b);
    const Vec3 n = direction_of(w), apart = b.center - a.center;
    const double along = dot(n, apart), scale = scale_of_pair(stores.bodies, c);
    const double separation = along - reach_along(sa, a, n) - reach_along(sb, b, -n);
    const double slack = separation - (tuning::speculative_margin + tuning::slack_reserve) * scale;
    if (slack <= 0) return false;
    const double next = slack_of(stores, stores.def, w, dt).next;
    if (next > slack) return false;
    const MotionBound &ra = stores.bodies.motion[w.body_a], &rb = stores.bodies.motion[w.body_b];
    w.budget = slack + ra.turned + rb.turned - along;
    w.limit = ra.travel + rb.travel + slack;
    return true;
}

bool stayed_apart(const BodyStore& bodies, const SeparationBound& w, Vec3 previous, Vec3 now) {
    const MotionBound &a = bodies.motion[w.body_a], &b = bodies.motion[w.body_b];
    if (a.travel + b.travel < w.limit) return true;
    // Rotation only decreases the budget, and with linear motion the minimum is at the start or the
    // end.
    const double left = w.budget - a.turned - b.turned;
    const Vec3 retained = direction_of(w);
    if (w.directed) return left + minimum(dot(retained, previous), dot(retained, now)) > 0;
    return left > maximum(length(previous - retained), length(now - retained));
}

}  // namespace jostle::physics
