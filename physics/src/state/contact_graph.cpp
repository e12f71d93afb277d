// SPDX-License-Identifier: MIT
#include "physics/src/state/contact_graph.h"

#include <algorithm>

#include "jostle/base/check.h"
#include "physics/src/collision/narrowphase/collide_composite.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/state/contact_constraints.h"
#include "physics/src/state/contact_load.h"
#include "physics/src/state/contact_modifiers.h"
#include "physics/src/state/islands.h"
#include "physics/src/state/separation_bounds.h"

namespace jostle::physics {
namespace {

void link_edge(ContactStore& store, std::uint32_t contact, unsigned side, BodyCold& body) {
    const std::uint32_t edge = contact * 2 + side;
    Contact& c = store.contacts[contact];
    ASSERT(side < 2 && c.next[side] == none && c.prev[side] == none);
    c.prev[side] = none;
    c.next[side] = body.first_edge;
    if (body.first_edge != none)
        store.contacts[body.first_edge / 2].prev[body.first_edge % 2] = edge;
    body.first_edge = edge;
}

void unlink_edge(ContactStore& store, std::uint32_t contact, unsigned side, BodyCold& body) {
    Contact& c = store.contacts[contact];
    ASSERT(side < 2 && body.first_edge != none);
    const std::uint32_t next = c.next[side], prev = c.prev[side];
    ASSERT(next == none || store.contacts[next / 2].prev[next % 2] == contact * 2 + side);
    ASSERT(prev == none ? body.first_edge == contact * 2 + side
                        : store.contacts[prev / 2].next[prev % 2] == contact * 2 + side);
    if (next != none) store.contacts[next / 2].prev[next % 2] = prev;
    if (prev != none)
        store.contacts[prev / 2].next[prev % 2] = next;
    else
        body.first_edge = next;
}

std::uint32_t new_contact(ContactGraph& stores, std::uint32_t shape_a, std::uint32_t shape_b) {
    ContactStore& store = stores.contacts;
    const std::uint32_t index = store.ids.take();
    ASSERT(index <= store.contacts.size());
    if (index == store.contacts.size()) store.contacts.emplace_back();
    Contact& c = store.contacts[index];
    c = Contact{.shape_a = shape_a,
                .shape_b = shape_b,
                .body_a = stores.shapes.shapes[shape_a].body,
                .body_b = stores.shapes.shapes[shape_b].body};
    ASSERT(c.body_a != c.body_b);
    ASSERT(is_dynamic(stores.bodies, c.body_a));
    link_edge(store, index, 0, stores.bodies.cold[c.body_a]);
    link_edge(store, index, 1, stores.bodies.cold[c.body_b]);
    return index;
}

void unlink_child(ContactStore& store, std::uint32_t child) {
    ASSERT(store.contacts[child].parent != none);
    std::uint32_t* at = &store.contacts[store.contacts[child].parent].first_child;
    while (*at != child) {
        ASSERT(*at != none);
        at = &store.contacts[*at].next_child;
    }
    *at = store.contacts[child].next_child;
}

}  // namespace

std::uint32_t create_contact(ContactGraph& stores, std::uint32_t shape_a, std::uint32_t shape_b) {
    ContactStore& store = stores.contacts;
    if (!is_dynamic(stores.bodies, stores.shapes.shapes[shape_a].body)) std::swap(shape_a, shape_b);
    const std::uint32_t index = new_contact(stores, shape_a, shape_b);
    store.contacts[index].composite =
        is_composite(kind_of(stores.shapes.shapes[shape_a].geometry)) ||
        is_composite(kind_of(stores.shapes.shapes[shape_b].geometry));
    ASSERT(!store.pairs.contains(pair_key(shape_a, shape_b)));
    store.pairs.insert(pair_key(shape_a, shape_b));
    ASSERT(store.pairs.size() <= store.ids.alive_count());
    count_pair(stores.bodies, store.contacts[index], 1);
    add_separation_bound(stores, stores.contacts, index, -1);
    return index;
}

std::uint32_t create_child_contact(ContactGraph& stores, std::uint32_t parent, std::uint64_t key) {
    auto& contacts = stores.contacts.contacts;
    ASSERT(contacts[parent].composite && contacts[parent].parent == none);
    const std::uint32_t index =
        new_contact(stores, contacts[parent].shape_a, contacts[parent].shape_b);
    contacts[index].parent = parent;
    contacts[index].key = key;
    // Append, so that children are in order of creation.
    std::uint32_t* last = &contacts[parent].first_child;
    while (*last != none) last = &contacts[*last].next_child;
    *last = index;
    return index;
}

void destroy_contact(WorldState& world, std::uint32_t contact, std::vector<ContactEnd>& ended) {
    ContactStore& store = world.contacts;
    ASSERT(store.ids.alive(contact));
    while (store.contacts[contact].first_child != none)
        destroy_contact(world, store.contacts[contact].first_child, ended);
    Contact& c = store.contacts[contact];
    if (c.parent != none) {
        if (c.touching) end_touch(world, contact);
        unlink_child(store, contact);
    } else if (c.touching) {
        report_end(world, c, ended);
        if (!c.composite) end_touch(world, contact);
    }
    if (c.colour >= 0) remove_contact(world, contact);
    clear_modifier(world.contacts, contact);
    if (c.has_bound)
        std::erase_if(store.bounds, [&](const SeparationBound& w) { return w.contact == contact; });
    if (world.bodies.cold[c.body_a].set == BodySet::sleeping) {
        Island& island = world.islands.islands[world.bodies.cold[c.body_a].island];
        std::erase_if(island.manifolds,
                      [&](const SavedContact& m) { return m.contact == contact; });
    }
    unlink_edge(store, contact, 0, world.bodies.cold[c.body_a]);
    unlink_edge(store, contact, 1, world.bodies.cold[c.body_b]);
    if (c.parent == none) {
        store.pairs.erase(pair_key(c.shape_a, c.shape_b));
        count_pair(world.bodies, c, -1);
    }
    c = Contact{};
    store.ids.release(contact);
}

void end_touch_of_pair(ContactGraph& stores, std::uint32_t pair, std::vector<ContactEnd>& ended) {
    Contact& c = stores.contacts.contacts[pair];
    ASSERT(stores.contacts.ids.alive(pair) && c.parent == none);
    ASSERT(c.composite || c.touching_children == 0);
    if (!c.touching || c.touching_children > 0) return;
    c.touching = false;
    report_end(stores, c, ended);
}

void report_end(const ShapedBodies& stores, const Contact& c, std::vector<ContactEnd>& ended) {
    ASSERT(c.parent == none);
    ended.push_back({shape_id(stores.shapes, c.shape_a), shape_id(stores.shapes, c.shape_b),
                     body_id(stores.bodies, c.body_a), body_id(stores.bodies, c.body_b)});
}

namespace {

// Destroying a pair destroys its children, so the list is collected first.
template <class Which>
void destroy_pairs(WorldState& world, const BodyCold& body, std::vector<ContactEnd>& ended,
                   Which&& selects) {
    std::vector<std::uint32_t> pairs;
    for_each_contact(world.contacts, body, [&](std::uint32_t contact) {
        const Contact& c = world.contacts.contacts[contact];
        if (c.parent == none && selects(c)) pairs.push_back(contact);
    });
    for (const std::uint32_t contact : pairs) destroy_contact(world, contact, ended);
}

}  // namespace

namespace {

// The island no longer carries the load of this body.
void record_lost_load(BodySets& sets, std::uint32_t body) {
    const BodyCold& cold = sets.bodies.cold[body];
    if (cold.island == none || cold.constraints == 0) return;
    ASSERT(sets.islands.ids.alive(cold.island));
    Island& island = sets.islands.islands[cold.island];
    island.remaining_load *= clamp(1 - cold.mass / island.mass, 0, 1);
    ASSERT(island.remaining_load >= 0 && island.remaining_load <= 1);
    sets.islands.some_lost = true;
}

}  // namespace

void destroy_contacts_of(WorldState& world, std::uint32_t body, std::vector<ContactEnd>& ended) {
    record_lost_load(world, body);
    destroy_pairs(world, world.bodies.cold[body], ended, [](const Contact&) { return true; });
}

void destroy_contacts_of_shape(WorldState& world, std::uint32_t shape,
                               std::vector<ContactEnd>& ended) {
    destroy_pairs(world, world.bodies.cold[world.shapes.shapes[shape].body], ended,
                  [&](const Contact& c) { return c.shape_a == shape || c.shape_b == shape; });
}

void destroy_contacts_between(WorldState& world, std::uint32_t body, std::uint32_t other,
                              std::vector<ContactEnd>& ended) {
    destroy_pairs(world, world.bodies.cold[body], ended,
                  [&](const Contact& c) { return c.body_a == other || c.body_b == other; });
}

namespace {

void note_masses(BodySets& sets, const Contact& c) {
    const double a = sets.bodies.cold[c.body_a].mass, b = sets.bodies.cold[c.body_b].mass;
    ASSERT(a > 0 && b > 0);
    if (maximum(a, b) >= tuning::heavy_ratio * minimum(a, b))
        sets.islands.islands[sets.bodies.cold[c.body_a].island].uneven = true;
}

}  // namespace

void begin_touch(ContactGraph& stores, JointStore& joints, std::uint32_t contact) {
    Contact& c = stores.contacts.contacts[contact];
    ASSERT(!c.touching && !c.composite);
    c.touching = true;
    if (is_dynamic(stores.bodies, c.body_b)) note_masses(stores, c);
    if (c.parent != none) stores.contacts.contacts[c.parent].touching_children++;
    ASSERT(stores.bodies.cold[c.body_a].island != none);
    if (is_dynamic(stores.bodies, c.body_b))
        join_islands(stores, joints, stores.bodies.cold[c.body_a].island,
                     stores.bodies.cold[c.body_b].island);
}

void end_touch(WorldState& world, std::uint32_t contact) {
    Contact& c = world.contacts.contacts[contact];
    ASSERT(c.touching && !c.composite);
    c.touching = false;
    for (const std::uint32_t body : {c.body_a, c.body_b})
        if (world.bodies.cold[body].asleep_in_place)
            world.wake_requests.push_back({body, supported_mass(world.def, c)});
    if (c.parent != none) {
        Contact& parent = world.contacts.contacts[c.parent];
        // Whether the pair as a whole separated is determined after all changes of the step.
        ASSERT(parent.touching_children > 0);
        parent.touching_children--;
        world.changed_pairs.push_back(c.parent);
    }
    if (is_dynamic(world.bodies, c.body_b))
        world.islands.islands[world.bodies.cold[c.body_a].island].may_be_split = true;
}

}  // namespace jostle::physics
