// SPDX-License-Identifier: MIT
#include "physics/src/stages/contacts/contact_stages.h"

#include <algorithm>

#include "jostle/base/check.h"
#include "physics/src/constraints/write_manifold.h"
#include "physics/src/foundation/prefetch.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/contacts/find_clusters.h"
#include "physics/src/stages/contacts/pair_motion.h"
#include "physics/src/stages/step_scratch.h"
#include "physics/src/state/contact_constraints.h"
#include "physics/src/state/contact_graph.h"
#include "physics/src/state/contact_modifiers.h"
#include "physics/src/state/pair_properties.h"
#include "physics/src/state/separation_bounds.h"
#include "physics/src/state/shape_proxy.h"

namespace jostle::physics {
namespace {

// A plane has no box. Only b can be a plane.
bool boxes_overlap(const ShapedBodies& stores, const Contact& c) {
    const ShapeRecord &a = stores.shapes.shapes[c.shape_a], &b = stores.shapes.shapes[c.shape_b];
    if (is_plane(b)) return reaches_plane(stores, b, a.fat);
    return overlap(a.fat, b.fat);
}

// The pair has no manifold: it gets a separation bound, or ends if its boxes no longer overlap.
void bound_or_end(WorldState& world, const NarrowPhaseTask& task, double near) {
    Contact& c = world.contacts.contacts[task.contact];
    ASSERT(!c.has_bound && !c.composite);
    if (c.touching) {
        report_end(world, c, world.events.contacts_ended);
        end_touch(world, task.contact);
    }
    if (c.colour >= 0) remove_contact(world, task.contact);
    clear_modifier(world.contacts, task.contact);
    if (!boxes_overlap(world, c)) {
        destroy_contact(world, task.contact, world.events.contacts_ended);
        return;
    }
    const float* d = task.direction;
    add_separation_bound(world, world.contacts, task.contact, task.near - near,
                         {double{d[0]}, double{d[1]}, double{d[2]}});
}

// Returns whether a body sleeps, with its island or in place.
bool is_asleep(const BodyCold& cold) {
    return cold.set == BodySet::sleeping || cold.asleep_in_place;
}

bool has_asleep(const BodyStore& bodies, const Contact& c) {
    return is_asleep(bodies.cold[c.body_a]) || is_asleep(bodies.cold[c.body_b]);
}

// A kinematic body is not slowed down by others.
double mass_as_mover(const BodyStore& bodies, std::uint32_t mover, std::uint32_t other_body) {
    const BodyCold& cold = bodies.cold[mover];
    return cold.type == BodyType::dynamic
               ? cold.mass
               : tuning::kinematic_mass_ratio * bodies.cold[other_body].mass;
}

// Returns whether a manifold begins. With a sleeping body it begins only at contact, and wakes the
// body and its surroundings as far as the impact affects them.
bool begins(WorldState& world, const Contact& c, double predicted_gap) {
    const double scale = scale_of_pair(world.bodies, c);
    if (!has_asleep(world.bodies, c)) return predicted_gap < tuning::speculative_margin * scale;
    const double speed = max_closing_distance(world, c, 1);
    // A body that comes to rest next to a sleeping body does not wake it, however near it is.
    const double slow = tuning::sleep_speed * speed_scale(size_of_pair(world.bodies, c),
                                                          gravity_ratio_squared(world.def.gravity));
    if (predicted_gap >= (speed < slow ? 0 : tuning::wake_gap * scale)) return false;
    const auto meet = [&](std::uint32_t body, std::uint32_t other) {
        if (is_asleep(world.bodies.cold[body]))
            world.wake_requests.push_back(
                {body, mass_to_wake(speed * mass_as_mover(world.bodies, other, body))});
    };
    meet(c.body_a, c.body_b);
    meet(c.body_b, c.body_a);
    return true;
}

// The gap within which a manifold of the pair begins, m.
double begin_margin(const BodyStore& bodies, const Contact& c) {
    return (has_asleep(bodies, c) ? tuning::wake_gap : tuning::speculative_margin) *
           scale_of_pair(bodies, c);
}

// Ends children without a manifold, begins children for manifolds that may touch in this step, and
// gives the pair a bound until another child may come near.
void update_composite(WorldState& world, ContactScratch& scratch, std::uint32_t k) {
    const NarrowPhaseTask& task = scratch.tasks[k];
    auto& contacts = world.contacts.contacts;
    ASSERT(task.list >= 0 && task.list < scratch.child_list_count);
    const auto& found = scratch.children[static_cast<std::size_t>(task.list)];
    for (std::uint32_t p = contacts[task.contact].first_child; p != none;) {
        const std::uint32_t next = contacts[p].next_child;
        const bool persists = std::any_of(found.begin(), found.end(),
                                          [&](const FoundChild& f) { return f.contact == p; });
        if (persists)
            move_to_its_list(world, p);
        else
            destroy_contact(world, p, world.events.contacts_ended);
        p = next;
    }
    if (found.empty() && !boxes_overlap(world, contacts[task.contact])) {
        return destroy_contact(world, task.contact, world.events.contacts_ended);
    }
    ASSERT(!contacts[task.contact].has_bound);
    double clear = task.near;
    const double margin = begin_margin(world.bodies, contacts[task.contact]);
    for (std::size_t f = 0; f < found.size(); f++) {
        if (found[f].contact != none) continue;
        if (begins(world, contacts[task.contact], found[f].predicted_gap))
            scratch.begins.push_back({k, static_cast<std::int32_t>(f)});
        else
            clear = minimum(clear, found[f].predicted_gap - margin);
    }
    add_separation_bound(world, world.contacts, task.contact, clear);
}

void note_bouncing(const BodyStore& bodies, const Contact& c,
                   std::vector<std::uint32_t>& bouncing) {
    for (const std::uint32_t body : {c.body_a, c.body_b}) {
        const BodyCold& cold = bodies.cold[body];
        if (cold.type == BodyType::dynamic && !is_asleep(cold)) bouncing.push_back(body);
    }
}

// A pair that bounces in a cluster retains its manifold; other bouncing pairs have none.
void update_bounce(ContactGraph& stores, ContactScratch& scratch, NarrowPhaseTask& task) {
    const Contact& c = stores.contacts.contacts[task.contact];
    if (c.composite || !bounces_in_cluster(stores, scratch, c.shape_a, c.shape_b)) {
        note_bouncing(stores.bodies, c, scratch.bouncing);
        if (!c.composite) task.list = -1;
    } else if (task.list >= 0 && c.colour >= 0) {
        write_manifold(stores, c, scratch.fresh[static_cast<std::size_t>(task.list)], false);
        task.list = -1;
        task.persists = true;
    }
}

void decide(WorldState& world, ContactScratch& scratch, std::uint32_t k) {
    NarrowPhaseTask& task = scratch.tasks[k];
    ASSERT(world.contacts.ids.alive(task.contact));
    const Contact& c = world.contacts.contacts[task.contact];
    ASSERT(!c.queued);
    if (task.bounces) update_bounce(world, scratch, task);
    if (c.composite) return update_composite(world, scratch, k);
    // An existing manifold remains while it has points. A new one begins if the bodies may touch in
    // this step.
    if (task.persists) return move_to_its_list(world, task.contact);
    if (task.list >= 0 && begins(world, c, task.predicted_gap)) {
        scratch.begins.push_back({k, -1});
        return;
    }
    bound_or_end(world, task, begin_margin(world.bodies, c));
}

}  // namespace

void update_touching(StepContext& step) {
    WorldState& world = step.world;
    ContactScratch& scratch = step.scratch.contacts;
    std::vector<NarrowPhaseTask>& tasks = scratch.tasks;
    scratch.begins.clear();
    find_clusters(step);
    for (std::uint32_t k = 0; k < tasks.size(); k++) {
        if (k + 8 < tasks.size() && !tasks[k + 8].done)
            prefetch(world.contacts.contacts[tasks[k + 8].contact]);
        if (!tasks[k].done) decide(world, scratch, k);
    }
}

}  // namespace jostle::physics
