// SPDX-License-Identifier: MIT
#include "physics/src/stages/contacts/contact_stages.h"

#include <optional>

#include "jostle/base/check.h"
#include "physics/src/collision/narrowphase/collide.h"
#include "physics/src/collision/narrowphase/collide_pairs.h"
#include "physics/src/constraints/write_manifold.h"
#include "physics/src/foundation/size_scale.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/contacts/find_seam_neighbours.h"
#include "physics/src/stages/contacts/pair_motion.h"
#include "physics/src/stages/contacts/predicted_pair.h"
#include "physics/src/stages/continuous/ccd_policy.h"
#include "physics/src/stages/step_scratch.h"
#include "physics/src/state/contact_constraints.h"
#include "physics/src/state/pair_properties.h"

namespace jostle::physics {
namespace {

// Returns whether the pair will be swept (stages/continuous/solve_continuous.h). This requires a
// body that is fast, both absolutely and relative to the other body.
bool will_be_swept(const StepContext& step, const Contact& c, double displacement) {
    const WorldState& world = step.world;
    if (!world.def.continuous) return false;
    const BodyCold &a = world.bodies.cold[c.body_a], &b = world.bodies.cold[c.body_b];
    if (left_to_contacts(world, a, b, false)) return false;
    const auto sweeps = [&](const BodyCold& mover, const BodyCold& other) {
        if (!mover.continuous || mover.set != BodySet::awake) return false;
        if (displacement <= motion_without_sweep(mover, other)) return false;
        const BodyWarm& warm = world.bodies.awake[mover.at];
        return (length(warm.v) + length(warm.w) * mover.radius) * step.dt >
               tuning::sweep_fraction * mover.inner_radius;
    };
    return sweeps(a, b) || sweeps(b, a);
}

bool is_dynamic(const BodySets& sets, std::uint32_t body) {
    return sets.bodies.cold[body].type == BodyType::dynamic;
}
// Closing speed along a direction from a to b, m/s: of the centres of two dynamic bodies, otherwise
// at the centre of a.
double closing_along(const BodySets& sets, const Contact& c, Vec3 direction) {
    const BodyMotion a = motion_of(sets, c.body_a), b = motion_of(sets, c.body_b);
    if (is_dynamic(sets, c.body_b)) return dot(direction, a.v - b.v);
    return dot(direction, a.v - b.v - cross(b.w, a.center - b.center));
}
// Upper bound of the additional closing speed of any two points due to rotation, m/s.
double closing_by_turning(const BodySets& sets, const Contact& c) {
    const double radius_a = sets.bodies.cold[c.body_a].radius;
    const Vec3 wa = motion_of(sets, c.body_a).w, wb = motion_of(sets, c.body_b).w;
    if (!is_dynamic(sets, c.body_b)) return length(wa - wb) * radius_a;
    return length(wa) * radius_a + length(wb) * sets.bodies.cold[c.body_b].radius;
}

// Lookahead distance for contacts: the closing distance of the pair in a step, limited to the size
// of the smaller body. Beyond that a manifold would treat an edge that the body flies past as a
// plane.
double closing_reach(const BodyStore& bodies, const Contact& c, double displacement) {
    const BodyCold &a = bodies.cold[c.body_a], &b = bodies.cold[c.body_b];
    const double size = b.type == BodyType::dynamic ? minimum(a.radius, b.radius) : a.radius;
    return minimum(displacement, size);
}

// The smallest gap that any point may have at the end of the step, at the current velocities.
double expected_gap(const BodySets& sets, const Contact& c, const Manifold& m, double dt) {
    const BodyMotion a = motion_of(sets, c.body_a), b = motion_of(sets, c.body_b);
    double smallest = 1e300;
    for (int i = 0; i < m.count; i++) {
        const Vec3 va = a.v + cross(a.w, m.point[i] - a.center);
        const Vec3 vb = b.v + cross(b.w, m.point[i] - b.center);
        const double closing = maximum(0, -dot(m.normal, vb - va));
        smallest = minimum(smallest, m.gap[i] - closing * dt);
    }
    return smallest;
}

// Highest closing speed of any point at the start of the step, m/s.
double closing_speed(const BodySets& sets, const Contact& c, const Manifold& m) {
    const BodyMotion a = motion_of(sets, c.body_a), b = motion_of(sets, c.body_b);
    double fastest = 0;
    for (int i = 0; i < m.count; i++) {
        const Vec3 va = a.v + cross(a.w, m.point[i] - a.center);
        const Vec3 vb = b.v + cross(b.w, m.point[i] - b.center);
        fastest = maximum(fastest, -dot(m.normal, vb - va));
    }
    return fastest;
}

// Returns whether a bouncing pair will touch in this step, so that the sweep handles it
// (stages/continuous/ccd_policy.h). The contact solver handles faces in two cases: one end of the
// face rests while the other end approaches, because a sweep would release it; or the bodies have
// already touched next to others that gravity presses them against, because impacts would follow
// each other without end.
bool will_bounce(const StepContext& step, const Contact& c, const Manifold& m, bool touching) {
    const WorldState& world = step.world;
    const double scale = scale_of_pair(world.bodies, c),
                 margin = tuning::speculative_margin * scale;
    if (m.count == 0) return m.distance - max_closing_distance(world, c, step.dt) < margin;
    const auto leans = [&](std::uint32_t body) {
        const BodyCold& cold = world.bodies.cold[body];
        return cold.type == BodyType::dynamic && had_contacts(step.scratch.contacts, cold);
    };
    if (m.count > 1 && touching) return false;
    if (m.count > 1 && smallest_gap(m) <= 2 * tuning::sweep_gap * scale &&
        world.def.gravity != Vec3{} && (leans(c.body_a) || leans(c.body_b)))
        return false;
    return closing_speed(world, c, m) > bounce_speed(world.def.gravity, step.dt) &&
           expected_gap(world, c, m, step.dt) < margin;
}

// Returns whether a bouncing pair cannot touch in this step except at a speed that bounces. Such a
// pair needs no manifold and moves freely. `least`: speed of such an impact, m/s. This includes
// bodies that just bounced and separate.
bool stays_apart(const BodySets& sets, const Contact& c, const Manifold& m, bool touching,
                 double least, double dt) {
    if (touching) return false;
    const BodyMotion a = motion_of(sets, c.body_a), b = motion_of(sets, c.body_b);
    for (int i = 0; i < m.count; i++) {
        const Vec3 va = a.v + cross(a.w, m.point[i] - a.center);
        const Vec3 vb = b.v + cross(b.w, m.point[i] - b.center);
        if (m.gap[i] + dot(m.normal, vb - va) * dt <= least * dt) return false;
    }
    return true;
}

// Finds for each existing child the manifold that continues it: the same child key and, among
// pieces of a surface, the nearest normal.
void match_children(ContactGraph& stores, const Contact& pair, std::vector<FoundChild>& found) {
    for (std::uint32_t p = pair.first_child; p != none;
         p = stores.contacts.contacts[p].next_child) {
        const Contact& child = stores.contacts.contacts[p];
        if (child.colour < 0) continue;
        const Vec3 normal = normal_of(lane_ref_of(stores.graph, child));
        FoundChild* best = nullptr;
        double most = tuning::same_part;
        for (FoundChild& f : found) {
            if (f.contact != none || f.child.key != child.key) continue;
            const double like = dot(f.child.manifold.normal, normal);
            if (like > most) {
                most = like;
                best = &f;
            }
        }
        if (best == nullptr) continue;
        best->contact = p;
        write_manifold(stores, child, best->child.manifold, false);
    }
}

// Returns whether a child of a composite pair touches.
bool is_touching(const ContactStore& contacts, const Contact& pair, std::uint64_t key) {
    for (std::uint32_t p = pair.first_child; p != none; p = contacts.contacts[p].next_child)
        if (contacts.contacts[p].key == key && contacts.contacts[p].touching) return true;
    return false;
}

// Returns whether b is a surface that does not rotate.
bool is_even_surface(const ShapedBodies& stores, const Contact& c) {
    const ShapeKind kind = kind_of(stores.shapes.shapes[c.shape_b].geometry);
    return (kind == ShapeKind::mesh || kind == ShapeKind::height_field) &&
           motion_of(stores, c.body_b).w == Vec3{};
}

// The shapes next to those of the pair, as predicted at the same time.
SeamNeighbours predicted_neighbours(const WorldState& world, const Contact& c, double time) {
    const SeamShapes shapes = find_seam_neighbours(world, c);
    SeamNeighbours neighbours;
    for (const std::uint32_t shape : shapes.of_a)
        neighbours.of_a.push_back(predicted_shape(world, shape, time));
    for (const std::uint32_t shape : shapes.of_b)
        neighbours.of_b.push_back(predicted_shape(world, shape, time));
    return neighbours;
}

// The motion of a relative to b in the step, starting from the predicted pose.
SurfaceMotion surface_motion_of(const BodySets& sets, const Contact& c, const PredictedPair& pair,
                                double dt) {
    const BodyMotion a = motion_of(sets, c.body_a), b = motion_of(sets, c.body_b);
    const Vec3 u = a.v - b.v;
    const double time = pair.time(), left = dt - time;
    return {u * -time, u * left, a.w * maximum(time, left), a.center + a.v * time,
            (tuning::speculative_margin + tuning::composite_slack) * scale_of_pair(sets.bodies, c)};
}

void narrow_phase_composite(StepContext& step, NarrowPhaseTask& task) {
    WorldState& world = step.world;
    ContactScratch& scratch = step.scratch.contacts;
    const double dt = step.dt;
    const Contact& c = world.contacts.contacts[task.contact];
    const double displacement = max_closing_distance(world, c, dt);
    const double scale = scale_of_pair(world.bodies, c);
    task.near = closing_reach(world.bodies, c, displacement) + tuning::composite_slack * scale;
    const bool swept = will_be_swept(step, c, displacement);
    std::optional<double> contact_time;
    if (swept && uses_speculative_contact(step, c.shape_a, c.shape_b))
        contact_time = time_to_contact(world, c, dt);
    double time = contact_time && *contact_time > 0 ? *contact_time
                                                    : midpoint_time(world, c, displacement, dt);
    std::vector<ChildManifold> children;
    // Pairs that move by more than the slack are tested again in the next step. Until then only the
    // region that they approach matters.
    const bool moves_far = displacement > tuning::composite_slack * scale;
    // Returns whether a neighbour covers a contact.
    const auto collide_at = [&](const PredictedPair& pair) {
        std::optional<SurfaceMotion> motion;
        if (moves_far && is_even_surface(world, c)) motion = surface_motion_of(world, c, pair, dt);
        const SeamNeighbours neighbours = predicted_neighbours(world, c, pair.time());
        children.clear();
        return collide_composite(pair.shape_a(), pair.shape_b(),
                                 tuning::speculative_margin * scale + task.near, children,
                                 &step.scratch.stopped, motion ? &*motion : nullptr, &neighbours);
    };
    // A neighbour that covers a contact is tested at the time of its forces, when it may no longer
    // cover this one.
    if (collide_at({world, c, time}) && c.touching_children == 0) {
        time = time_of_forces(world, c, displacement, dt);
        collide_at({world, c, time});
    }
    const PredictedPair pair(world, c, time);
    const double lookahead = displacement * time / dt;
    if (is_stopped(step)) {
        task.done = true;  // unchanged
        return;
    }
    for (ChildManifold& child : children) pair.rewind_manifold(child.manifold, lookahead);
    task.near = moves_far && is_even_surface(world, c) ? 0 : task.near - lookahead;
    ASSERT(task.list >= 0 && task.list < scratch.child_list_count);
    std::vector<FoundChild>& found = scratch.children[static_cast<std::size_t>(task.list)];
    found.clear();
    task.predicted_gap = 1e300;
    const bool may_bounce = bounces(world, c.shape_a, c.shape_b);
    const double slow = bounce_speed(world.def.gravity, dt);
    for (const ChildManifold& child : children) {
        if (may_bounce) {
            const bool touches = is_touching(world.contacts, c, child.key);
            const bool will_touch = will_bounce(step, c, child.manifold, touches);
            task.bounces |= will_touch;
            if (will_touch || stays_apart(world, c, child.manifold, touches, slow, dt)) {
                task.near = minimum(task.near, 0);
                continue;
            }
        }
        if (swept && !contact_time && child.manifold.distance > tuning::touch_gap * scale) continue;
        found.push_back({child, expected_gap(world, c, child.manifold, dt), none});
        task.predicted_gap = minimum(task.predicted_gap, found.back().predicted_gap);
    }
    match_children(world, c, found);
}

// The closest approach of a pair that does not touch.
struct Approach {
    Vec3 normal;
    double gap = 0;  // m
};
// Determined from the existing manifold.
Approach approach_of(const ConstraintGraph& graph, const Contact& c) {
    const ContactLaneRef lane_ref = lane_ref_of(graph, c);
    double gap = no_point;
    for (const auto& row : lane_ref.block->gap) gap = minimum(gap, double{row[lane_ref.lane]});
    return {normal_of(lane_ref), gap};
}

// m: a pair that closes by less in a step does not approach.
constexpr double rounding_motion = 1e-7;

// Tests a pair at predicted poses. `covered`: whether a neighbour covers the contact.
Manifold test_pair(const WorldState& world, Contact& c, const PredictedPair& pair, double margin,
                   double lookahead, bool& covered) {
    const TransformedShape &a = pair.shape_a(), &b = pair.shape_b();
    Manifold m =
        world.def.planar ? collide_planar(a, b, margin, c.cache) : collide(a, b, margin, c.cache);
    covered = m.count > 0 && !world.def.planar && kind_of(*b.geometry) != ShapeKind::plane &&
              apply_seams(m, a, b, predicted_neighbours(world, c, pair.time()), margin);
    pair.rewind_manifold(m, lookahead);
    return m;
}

// The points where a pair may touch in this step.
Manifold predicted_manifold(const StepContext& step, Contact& c, bool& covered) {
    WorldState& world = step.world;
    const double dt = step.dt;
    const double displacement = max_closing_distance(world, c, dt),
                 scale = scale_of_pair(world.bodies, c);
    const double predicted = tuning::speculative_margin * scale, past = tuning::just_past * scale;
    const auto within = [&](double margin, const PredictedPair& pair) {
        return test_pair(world, c, pair, margin, displacement * pair.time() / dt, covered);
    };
    const PredictedPair pair(world, c, midpoint_time(world, c, displacement, dt));
    const bool swept = will_be_swept(step, c, displacement);
    if (swept && !uses_speculative_contact(step, c.shape_a, c.shape_b))
        return within(tuning::touch_gap * scale, pair);
    Approach near;
    std::optional<Manifold> now;
    if (c.colour < 0 || swept) {
        // Most pairs with a high relative speed miss each other. Testing that is cheaper than
        // finding points.
        now = within(predicted, pair);
        near = {now->normal, smallest_gap(*now)};
        const double most = closing_along(world, c, near.normal) + closing_by_turning(world, c);
        if (now->count == 0 && near.normal != Vec3{} && near.gap - most * dt >= predicted)
            return *now;
        const std::optional<double> contact_time =
            swept ? time_to_contact(world, c, dt) : std::optional(0.0);
        if (!contact_time) return *now;
        if (*contact_time > 0)
            return within(predicted,
                          PredictedPair(world, c, minimum(dt, *contact_time + past / most)));
    } else if (!c.touching) {
        near = approach_of(world.graph, c);
    }
    const double margin = predicted + closing_reach(world.bodies, c, displacement);
    const double closing = closing_along(world, c, near.normal);
    // Bodies that slide past each other close by rounding errors only.
    if (!c.touching && near.gap > 0 && near.gap < closing * dt &&
        closing * dt > rounding_motion * scale)
        return within(margin, PredictedPair(world, c, minimum(dt, (near.gap + past) / closing)));
    // Points beyond the usual margin matter only to pairs that may close it soon.
    if (now && now->count > 0 && displacement <= 0.5 * predicted) return *now;
    return within(margin, pair);
}

// Bodies that cannot rotate need one point: the deepest.
bool needs_one_point(const BodyStore& bodies, const Contact& c) {
    const BodyCold &a = bodies.cold[c.body_a], &b = bodies.cold[c.body_b];
    return !can_rotate(a) && b.type != BodyType::kinematic &&
           (b.type == BodyType::static_body || !can_rotate(b));
}

void keep_deepest_point(Manifold& m) {
    int deepest = 0;
    for (int i = 1; i < m.count; i++)
        if (m.gap[i] < m.gap[deepest]) deepest = i;
    m.point[0] = m.point[deepest];
    m.gap[0] = m.gap[deepest];
    m.count = 1;
}

// A neighbour that covers a contact is tested at the time of its forces, when it may no longer
// cover this one. A pair that does not touch is then tested at that time, too.
Manifold predicted_manifold(const StepContext& step, Contact& c) {
    WorldState& world = step.world;
    bool covered = false;
    const Manifold m = predicted_manifold(step, c, covered);
    if (!covered || c.touching) return m;
    const double displacement = max_closing_distance(world, c, step.dt);
    const double time = time_of_forces(world, c, displacement, step.dt);
    const double margin = tuning::speculative_margin * scale_of_pair(world.bodies, c) +
                          closing_reach(world.bodies, c, displacement);
    return test_pair(world, c, {world, c, time}, margin, displacement * time / step.dt, covered);
}

// For a pair that is about to bounce: update_touching decides whether it is in a cluster, in which
// case the contact solver handles the manifold.
void defer_to_clusters(StepContext& step, NarrowPhaseTask& task, const Manifold& manifold) {
    WorldState& world = step.world;
    ContactScratch& scratch = step.scratch.contacts;
    const Contact& c = world.contacts.contacts[task.contact];
    for (int k = 0; k < 3; k++) task.direction[k] = static_cast<float>(manifold.normal[k]);
    task.near = smallest_gap(manifold);
    task.predicted_gap = expected_gap(world, c, manifold, step.dt);
    task.closing = manifold.count > 0
                       ? closing_speed(world, c, manifold)
                       : closing_along(world, c, manifold.normal) + closing_by_turning(world, c);
    if (manifold.count == 0) return;
    task.list = scratch.fresh_count.fetch_add(1, std::memory_order_relaxed);
    ASSERT(static_cast<std::size_t>(task.list) < scratch.tasks.size());
    scratch.fresh[static_cast<std::size_t>(task.list)] = manifold;
}

}  // namespace

void narrow_phase_pair(StepContext& step, NarrowPhaseTask& task) {
    WorldState& world = step.world;
    ContactScratch& scratch = step.scratch.contacts;
    Contact& c = world.contacts.contacts[task.contact];
    ASSERT(c.queued);
    c.queued = false;
    if (c.composite) return narrow_phase_composite(step, task);
    Manifold manifold = predicted_manifold(step, c);
    if (manifold.count > 1 && needs_one_point(world.bodies, c)) keep_deepest_point(manifold);
    if (bounces(world, c.shape_a, c.shape_b)) {
        task.bounces = will_bounce(step, c, manifold, c.touching);
        if (task.bounces) return defer_to_clusters(step, task, manifold);
        if (manifold.count > 0 && stays_apart(world, c, manifold, c.touching,
                                              bounce_speed(world.def.gravity, step.dt), step.dt)) {
            manifold.distance = smallest_gap(manifold);
            manifold.count = 0;
        }
    }
    if (manifold.count == 0)
        for (int k = 0; k < 3; k++) task.direction[k] = static_cast<float>(manifold.normal[k]);
    task.near = smallest_gap(manifold);
    task.predicted_gap = expected_gap(world, c, manifold, step.dt);
    if (manifold.count > 0 && c.colour >= 0) {
        task.persists = true;
        write_manifold(world, c, manifold, false);
        task.done = is_in_its_list(world.graph, c);
    } else if (task.predicted_gap < tuning::speculative_margin * scale_of_pair(world.bodies, c)) {
        ASSERT(c.colour < 0 || manifold.count == 0);
        task.list = scratch.fresh_count.fetch_add(1, std::memory_order_relaxed);
        ASSERT(static_cast<std::size_t>(task.list) < scratch.tasks.size());
        scratch.fresh[static_cast<std::size_t>(task.list)] = manifold;
    }
}

}  // namespace jostle::physics
