// SPDX-License-Identifier: MIT
#include "state/links.h"

#include <algorithm>

#include "collision/narrowphase/collide_composite.h"
#include "foundation/check.h"
#include "jostle/physics/tuning.h"
#include "state/contact_constraints.h"
#include "state/island_tiers.h"
#include "state/partial_sleep.h"
#include "state/shape_proxy.h"

namespace jostle::physics {
namespace {

bool is_dynamic(const WorldState& world, std::uint32_t body) {
    return world.bodies.cold[body].type == BodyType::dynamic;
}

// A kinematic body without velocity: as good as fixed.
bool is_parked(const WorldState& world, std::uint32_t body) {
    const BodyWarm& warm = warm_of(world, body);
    return !is_dynamic(world, body) && warm.v == Vec3{} && warm.w == Vec3{};
}

void link_edge(ContactStore& store, std::uint32_t contact, unsigned side, BodyCold& body) {
    const std::uint32_t edge = contact * 2 + side;
    Contact& c = store.contacts[contact];
    c.prev[side] = none;
    c.next[side] = body.first_edge;
    if (body.first_edge != none)
        store.contacts[body.first_edge / 2].prev[body.first_edge % 2] = edge;
    body.first_edge = edge;
}

void unlink_edge(ContactStore& store, std::uint32_t contact, unsigned side, BodyCold& body) {
    Contact& c = store.contacts[contact];
    const std::uint32_t next = c.next[side], prev = c.prev[side];
    if (next != none) store.contacts[next / 2].prev[next % 2] = prev;
    if (prev != none)
        store.contacts[prev / 2].next[prev % 2] = next;
    else
        body.first_edge = next;
}

std::uint32_t new_contact(WorldState& world, std::uint32_t shape_a, std::uint32_t shape_b) {
    ContactStore& store = world.contacts;
    const std::uint32_t index = store.ids.take();
    if (index == store.contacts.size()) store.contacts.emplace_back();
    Contact& c = store.contacts[index];
    c = Contact{.shape_a = shape_a,
                .shape_b = shape_b,
                .body_a = world.shapes.shapes[shape_a].body,
                .body_b = world.shapes.shapes[shape_b].body};
    ASSERT(is_dynamic(world, c.body_a));
    link_edge(store, index, 0, world.bodies.cold[c.body_a]);
    link_edge(store, index, 1, world.bodies.cold[c.body_b]);
    return index;
}

void unlink_part(ContactStore& store, std::uint32_t part) {
    std::uint32_t* at = &store.contacts[store.contacts[part].parent].first_part;
    while (*at != part) at = &store.contacts[*at].next_part;
    *at = store.contacts[part].next_part;
}

}  // namespace

// --- contacts ---

std::uint32_t create_contact(WorldState& world, std::uint32_t shape_a, std::uint32_t shape_b) {
    ContactStore& store = world.contacts;
    if (!is_dynamic(world, world.shapes.shapes[shape_a].body)) std::swap(shape_a, shape_b);
    const std::uint32_t index = new_contact(world, shape_a, shape_b);
    store.contacts[index].composite =
        is_composite(kind_of(world.shapes.shapes[shape_a].geometry)) ||
        is_composite(kind_of(world.shapes.shapes[shape_b].geometry));
    store.pairs.insert(pair_key(shape_a, shape_b));
    add_separation_bound(world, index, -1);
    return index;
}

std::uint32_t create_part(WorldState& world, std::uint32_t parent, std::uint64_t key) {
    auto& contacts = world.contacts.contacts;
    const std::uint32_t index =
        new_contact(world, contacts[parent].shape_a, contacts[parent].shape_b);
    contacts[index].parent = parent;
    contacts[index].key = key;
    // At the end: parts keep the order in which they came.
    std::uint32_t* last = &contacts[parent].first_part;
    while (*last != none) last = &contacts[*last].next_part;
    *last = index;
    return index;
}

void set_separation_bound(SeparationBound& w, Vec3 apart, Vec3 direction, double slack,
                          const MotionBound& a, const MotionBound& b) {
    w.directed = direction != Vec3{};
    const Vec3 kept = w.directed ? direction : apart;
    for (int k = 0; k < 3; k++) w.apart[k] = static_cast<float>(kept[k]);
    w.budget = slack + a.turned + b.turned - (w.directed ? dot(direction_of(w), apart) : 0);
}

void add_separation_bound(WorldState& world, std::uint32_t contact, double slack, Vec3 direction) {
    Contact& c = world.contacts.contacts[contact];
    c.dormant = false;
    if (c.has_bound) return;  // was dormant meanwhile: keeps its place and limit
    c.has_bound = true;
    const MotionBound &a = world.bodies.motion[c.body_a], &b = world.bodies.motion[c.body_b];
    SeparationBound w{.contact = contact, .body_a = c.body_a, .body_b = c.body_b};
    w.limit = a.travel + b.travel + slack;
    const Vec3 apart = warm_of(world, c.body_b).center - warm_of(world, c.body_a).center;
    if (slack >= 0 && length_squared(apart) <= 1e6)
        set_separation_bound(w, apart, direction, slack - slack_reserve, a, b);
    c.limit = w.limit;
    world.contacts.bounds.push_back(w);
}

void resume_separation_bound(WorldState& world, std::uint32_t contact) {
    Contact& c = world.contacts.contacts[contact];
    c.dormant = false;
    if (c.has_bound) return;
    c.has_bound = true;
    world.contacts.bounds.push_back(
        {.contact = contact, .body_a = c.body_a, .body_b = c.body_b, .limit = c.limit});
}

void destroy_contact(WorldState& world, std::uint32_t contact, std::vector<ContactEnd>& ended) {
    ContactStore& store = world.contacts;
    while (store.contacts[contact].first_part != none)
        destroy_contact(world, store.contacts[contact].first_part, ended);
    Contact& c = store.contacts[contact];
    if (c.parent != none) {
        if (c.touching) end_touch(world, contact);
        unlink_part(store, contact);
    } else if (c.touching) {
        report_end(world, c, ended);
        if (!c.composite) end_touch(world, contact);
    }
    if (c.colour >= 0) remove_contact(world, contact);
    if (c.has_bound)
        std::erase_if(store.bounds, [&](const SeparationBound& w) { return w.contact == contact; });
    if (world.bodies.cold[c.body_a].set == BodySet::sleeping) {
        Island& island = world.islands.islands[world.bodies.cold[c.body_a].island];
        std::erase_if(island.manifolds,
                      [&](const SavedContact& m) { return m.contact == contact; });
    }
    unlink_edge(store, contact, 0, world.bodies.cold[c.body_a]);
    unlink_edge(store, contact, 1, world.bodies.cold[c.body_b]);
    if (c.parent == none) store.pairs.erase(pair_key(c.shape_a, c.shape_b));
    c = Contact{};
    store.ids.give_back(contact);
}

void settle_pair(WorldState& world, std::uint32_t pair) {
    Contact& c = world.contacts.contacts[pair];
    if (!c.touching || c.parts_touching > 0) return;
    c.touching = false;
    report_end(world, c, world.events.contacts_ended);
}

void report_end(const WorldState& world, const Contact& c, std::vector<ContactEnd>& ended) {
    ended.push_back({shape_id(world, c.shape_a), shape_id(world, c.shape_b),
                     body_id(world, c.body_a), body_id(world, c.body_b)});
}

namespace {

// Destroying a pair takes its parts along, so the list is read first.
template <class Which>
void destroy_pairs(WorldState& world, const BodyCold& body, std::vector<ContactEnd>& ended,
                   Which&& which) {
    std::vector<std::uint32_t> pairs;
    for_each_contact(world.contacts, body, [&](std::uint32_t contact) {
        const Contact& c = world.contacts.contacts[contact];
        if (c.parent == none && which(c)) pairs.push_back(contact);
    });
    for (const std::uint32_t contact : pairs) destroy_contact(world, contact, ended);
}

}  // namespace

namespace {

// Its island bears it no more.
void note_lost_load(WorldState& world, std::uint32_t body) {
    const BodyCold& cold = world.bodies.cold[body];
    if (cold.island == none || cold.constraints == 0) return;
    Island& island = world.islands.islands[cold.island];
    island.kept_load *= clamp(1 - cold.mass / island.mass, 0, 1);
    world.islands.some_lost = true;
}

}  // namespace

void destroy_contacts_of(WorldState& world, std::uint32_t body, std::vector<ContactEnd>& ended) {
    note_lost_load(world, body);
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

// --- joints ---

namespace {

void link_joint_edge(JointStore& store, std::uint32_t joint, unsigned side, BodyCold& body) {
    Joint& j = store.joints[joint];
    j.prev[side] = none;
    j.next[side] = body.first_joint;
    if (body.first_joint != none)
        store.joints[body.first_joint / 2].prev[body.first_joint % 2] = joint * 2 + side;
    body.first_joint = joint * 2 + side;
}

void unlink_joint_edge(JointStore& store, std::uint32_t joint, unsigned side, BodyCold& body) {
    const std::uint32_t next = store.joints[joint].next[side],
                        prev = store.joints[joint].prev[side];
    if (next != none) store.joints[next / 2].prev[next % 2] = prev;
    if (prev != none)
        store.joints[prev / 2].next[prev % 2] = next;
    else
        body.first_joint = next;
}

}  // namespace

void link_joint(WorldState& world, std::uint32_t joint) {
    const Joint& j = world.joints.joints[joint];
    link_joint_edge(world.joints, joint, 0, world.bodies.cold[j.body_a]);
    link_joint_edge(world.joints, joint, 1, world.bodies.cold[j.body_b]);
    if (is_dynamic(world, j.body_a) && is_dynamic(world, j.body_b))
        join_islands(world, world.bodies.cold[j.body_a].island, world.bodies.cold[j.body_b].island);
}

void destroy_joint(WorldState& world, std::uint32_t joint) {
    Joint& j = world.joints.joints[joint];
    const std::uint32_t a = j.body_a, b = j.body_b;
    unlink_joint_edge(world.joints, joint, 0, world.bodies.cold[a]);
    unlink_joint_edge(world.joints, joint, 1, world.bodies.cold[b]);
    if (is_dynamic(world, a) && is_dynamic(world, b))
        world.islands.islands[world.bodies.cold[a].island].may_be_split = true;
    const bool collided = j.collide_connected;
    j = Joint{};
    world.joints.ids.give_back(joint);
    if (collided) return;
    // Their shapes may meet from now on.
    for (const std::uint32_t body : {a, b})
        for (std::uint32_t s = world.bodies.cold[body].first_shape; s != none;
             s = world.shapes.shapes[s].next)
            buffer_move(world, s);
}

bool joined_without_contact(const WorldState& world, std::uint32_t a, std::uint32_t b) {
    if (world.bodies.cold[a].first_joint == none || world.bodies.cold[b].first_joint == none)
        return false;
    bool joined = false;
    for_each_joint(world.joints, world.bodies.cold[a], [&](std::uint32_t joint) {
        const Joint& j = world.joints.joints[joint];
        joined = joined || (!j.collide_connected && (j.body_a == b || j.body_b == b));
    });
    return joined;
}

// --- islands ---

std::uint32_t create_island(WorldState& world) {
    const std::uint32_t index = world.islands.ids.take();
    if (index == world.islands.islands.size()) world.islands.islands.emplace_back();
    world.islands.islands[index] = Island{};
    return index;
}

void add_to_island(WorldState& world, std::uint32_t island_index, std::uint32_t body) {
    Island& island = world.islands.islands[island_index];
    BodyCold& cold = world.bodies.cold[body];
    cold.island = island_index;
    cold.island_prev = island.last;
    cold.island_next = none;
    if (island.last != none)
        world.bodies.cold[island.last].island_next = body;
    else
        island.first = body;
    island.last = body;
    island.bodies++;
    island.mass += cold.mass;
}

void remove_from_island(WorldState& world, std::uint32_t body) {
    BodyCold& cold = world.bodies.cold[body];
    const std::uint32_t index = cold.island;
    Island& island = world.islands.islands[index];
    if (cold.island_prev != none)
        world.bodies.cold[cold.island_prev].island_next = cold.island_next;
    else
        island.first = cold.island_next;
    if (cold.island_next != none)
        world.bodies.cold[cold.island_next].island_prev = cold.island_prev;
    else
        island.last = cold.island_prev;
    cold.island = cold.island_prev = cold.island_next = none;
    island.mass -= world.bodies.cold[body].mass;
    if (--island.bodies == 0) {
        island = Island{};
        world.islands.ids.give_back(index);
    }
}

void join_islands(WorldState& world, std::uint32_t a, std::uint32_t b) {
    if (a == b) return;
    match_sets(world, a, b);
    const Island &ia = world.islands.islands[a], &ib = world.islands.islands[b];
    ASSERT(!ia.asleep && !ib.asleep);
    if (ia.bodies < ib.bodies || (ia.bodies == ib.bodies && b < a)) std::swap(a, b);
    Island& into = world.islands.islands[a];
    Island& from = world.islands.islands[b];
    for (std::uint32_t body = from.first; body != none; body = world.bodies.cold[body].island_next)
        world.bodies.cold[body].island = a;
    world.bodies.cold[into.last].island_next = from.first;
    world.bodies.cold[from.first].island_prev = into.last;
    into.last = from.last;
    into.bodies += from.bodies;
    into.may_be_split = into.may_be_split || from.may_be_split;
    into.uneven = into.uneven || from.uneven;
    into.split_at = std::max(into.split_at, from.split_at);
    into.mass += from.mass;
    into.kept_load = minimum(into.kept_load, from.kept_load);
    from = Island{};
    world.islands.ids.give_back(b);
}

namespace {

void note_masses(WorldState& world, const Contact& c) {
    const double a = world.bodies.cold[c.body_a].mass, b = world.bodies.cold[c.body_b].mass;
    if (maximum(a, b) >= tuning::heavy_ratio * minimum(a, b))
        world.islands.islands[world.bodies.cold[c.body_a].island].uneven = true;
}

}  // namespace

void begin_touch(WorldState& world, std::uint32_t contact) {
    Contact& c = world.contacts.contacts[contact];
    c.touching = true;
    if (is_dynamic(world, c.body_b)) note_masses(world, c);
    if (c.parent != none) world.contacts.contacts[c.parent].parts_touching++;
    if (is_dynamic(world, c.body_b))
        join_islands(world, world.bodies.cold[c.body_a].island, world.bodies.cold[c.body_b].island);
}

void end_touch(WorldState& world, std::uint32_t contact) {
    Contact& c = world.contacts.contacts[contact];
    c.touching = false;
    for (const std::uint32_t body : {c.body_a, c.body_b})
        if (world.bodies.cold[body].asleep_in_place)
            world.scratch.support_lost.push_back({body, mass_borne_by(world, c)});
    if (c.parent != none) {
        Contact& parent = world.contacts.contacts[c.parent];
        // Whether the pair as a whole parted is seen when the step's changes are all in.
        parent.parts_touching--;
        world.scratch.pairs_changed.push_back(c.parent);
    }
    if (is_dynamic(world, c.body_b))
        world.islands.islands[world.bodies.cold[c.body_a].island].may_be_split = true;
}

// --- sets ---

void enter_fixed(WorldState& world, const BodyWarm& warm) {
    BodyCold& cold = world.bodies.cold[warm.body];
    cold.set = BodySet::fixed;
    cold.at = static_cast<std::uint32_t>(world.bodies.fixed.size());
    world.bodies.fixed.push_back(warm);
}

void enter_awake(WorldState& world, const BodyWarm& warm) {
    BodyCold& cold = world.bodies.cold[warm.body];
    cold.set = BodySet::awake;
    cold.at = static_cast<std::uint32_t>(world.bodies.awake.size());
    world.bodies.awake.push_back(warm);
}

void leave_set(WorldState& world, std::uint32_t body) {
    const BodyCold& cold = world.bodies.cold[body];
    ASSERT(cold.set != BodySet::sleeping);
    auto& set = cold.set == BodySet::fixed ? world.bodies.fixed : world.bodies.awake;
    const std::uint32_t hole = cold.at;
    if (hole + 1 < set.size()) {
        set[hole] = set.back();
        BodyCold& moved = world.bodies.cold[set[hole].body];
        moved.at = hole;
        if (moved.set == BodySet::awake)
            for_each_contact(world.contacts, moved, [&](std::uint32_t contact) {
                const Contact& c = world.contacts.contacts[contact];
                if (c.colour >= 0) write_body_indices(world, c);
            });
    }
    set.pop_back();
}

namespace {

// Those of an island that a touch leaves as they lie: all but what a kinematic body leads.
std::vector<std::uint32_t> who_stays_asleep(WorldState& world,
                                            const std::vector<BodyWarm>& sleepers) {
    std::vector<std::uint32_t> still;
    if (!world.def.sleeping || sleepers.size() < tuning::partial_sleep_least) return still;
    for_each_jointed(world, sleepers, [&](const JointedBodies& jointed) {
        if (!jointed.to_driver)
            still.insert(still.end(), jointed.bodies.begin(), jointed.bodies.end());
    });
    if (still.size() < tuning::partial_sleep_least) still.clear();
    return still;
}

}  // namespace

void wake_island(WorldState& world, std::uint32_t island_index, std::vector<BodyId>& woke) {
    Island& island = world.islands.islands[island_index];
    if (!island.asleep) return;
    island.asleep = false;
    const std::vector<BodyWarm> sleepers = std::move(island.sleepers);
    const std::vector<SavedContact> manifolds = std::move(island.manifolds);
    island.sleepers = {};
    island.manifolds = {};
    for (const BodyWarm& warm : sleepers) enter_awake(world, warm);
    const std::vector<std::uint32_t> still = who_stays_asleep(world, sleepers);
    for (const std::uint32_t body : still) hold_still(world, body);
    for (const BodyWarm& warm : sleepers)
        if (!world.bodies.cold[warm.body].asleep_in_place)
            woke.push_back(body_id(world, warm.body));
    for (const SavedContact& saved : manifolds) {
        restore_contact(world, saved);
        if (!still.empty()) keep_load(world, saved.contact);
        world.contacts.contacts[saved.contact].dormant = false;
    }
    // What has no manifold waits as before. A contact with another island that still sleeps is
    // awake now on one side.
    for (const BodyWarm& warm : sleepers)
        for_each_contact(world.contacts, world.bodies.cold[warm.body], [&](std::uint32_t contact) {
            const Contact& c = world.contacts.contacts[contact];
            if (c.dormant) resume_separation_bound(world, contact);
        });
}

namespace {

// How many it has, so that a heap's memory is taken once.
std::size_t manifolds_of(const WorldState& world, std::uint32_t island) {
    std::size_t count = 0;
    for (std::uint32_t body = world.islands.islands[island].first; body != none;
         body = world.bodies.cold[body].island_next)
        for_each_contact(world.contacts, world.bodies.cold[body], [&](std::uint32_t index) {
            const Contact& c = world.contacts.contacts[index];
            const bool first =
                c.body_a == body || world.bodies.cold[c.body_a].island != island;  // of two
            count += c.colour >= 0 && first ? 1 : 0;
        });
    return count;
}

}  // namespace

void put_island_to_sleep(WorldState& world, std::uint32_t island_index) {
    Island& island = world.islands.islands[island_index];
    ASSERT(!island.asleep && island.sleepers.empty());
    island.sleepers.reserve(island.bodies);
    island.manifolds.reserve(manifolds_of(world, island_index));
    // Manifolds first, while the hot indices still mean something. Each contact is met at its body
    // a, or at b when only b is of this island.
    for (std::uint32_t body = island.first; body != none;
         body = world.bodies.cold[body].island_next) {
        for_each_contact(world.contacts, world.bodies.cold[body], [&](std::uint32_t contact) {
            Contact& c = world.contacts.contacts[contact];
            if (c.dormant) return;
            const std::uint32_t other = c.body_a == body ? c.body_b : c.body_a;
            const BodyCold& other_cold = world.bodies.cold[other];
            const bool inside = other_cold.island == island_index;
            const bool other_moves =
                other_cold.set == BodySet::awake && !inside && !is_parked(world, other);
            if (c.colour >= 0) {
                // A manifold with an awake outsider (near, not touching) or a kinematic one ends;
                // the pair waits.
                const bool keep = inside || !other_moves;
                if (keep) island.manifolds.push_back(save_contact(world, contact));
                remove_contact(world, contact);
                if (!keep) {
                    if (c.parent != none) {
                        const std::uint32_t parent = c.parent;
                        destroy_contact(world, contact, world.events.contacts_ended);
                        settle_pair(world, parent);
                        return;
                    }
                    if (c.touching) {
                        report_end(world, c, world.events.contacts_ended);
                        end_touch(world, contact);
                    }
                    add_separation_bound(world, contact, -1);
                    return;
                }
            }
            if (!other_moves) c.dormant = world.contacts.some_dormant = true;
        });
    }
    for (std::uint32_t body = island.first; body != none;
         body = world.bodies.cold[body].island_next) {
        BodyCold& cold = world.bodies.cold[body];
        BodyWarm warm = world.bodies.awake[cold.at];
        warm.v = warm.w = {};
        leave_set(world, body);
        cold.set = BodySet::sleeping;
        cold.at = static_cast<std::uint32_t>(island.sleepers.size());
        island.sleepers.push_back(warm);
        world.bodies.motion[body].bound = world.bodies.motion[body].travel;
    }
    island.asleep = true;
}

void wake_body(WorldState& world, std::uint32_t body) {
    const BodyCold& cold = world.bodies.cold[body];
    if (cold.type != BodyType::dynamic) return;
    ensure_awake(world, body, world.events.pending.woke);
    warm_of(world, body).sleep_time = 0;
}

void wake_neighbours(WorldState& world, std::uint32_t body) {
    std::vector<std::uint32_t> others;
    for_each_joint(world.joints, world.bodies.cold[body], [&](std::uint32_t joint) {
        const Joint& j = world.joints.joints[joint];
        others.push_back(j.body_a == body ? j.body_b : j.body_a);
    });
    for_each_contact(world.contacts, world.bodies.cold[body], [&](std::uint32_t contact) {
        const Contact& c = world.contacts.contacts[contact];
        others.push_back(c.body_a == body ? c.body_b : c.body_a);
    });
    std::sort(others.begin(), others.end());
    for (const std::uint32_t other : others) wake_body(world, other);
}

}  // namespace jostle::physics
