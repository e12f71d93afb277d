// SPDX-License-Identifier: MIT
#include "physics/src/state/validate.h"

#include <algorithm>

#include "jostle/physics/limits.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/state/force_fields.h"

namespace jostle::physics {
namespace {

using Fault = std::optional<std::string>;

std::string at(const char* what, std::size_t index, const char* problem) {
    return std::string(what) + "[" + std::to_string(index) + "] " + problem;
}

template <class T>
Fault check_pool(const char* name, const IdPool& ids, const std::vector<T>& items) {
    auto& pool = const_cast<IdPool&>(ids);
    if (pool.generations().size() != pool.alive_flags().size() || items.size() != ids.size())
        return std::string(name) + ": the numbers of ids and records differ";
    for (std::size_t i = 0; i < pool.alive_flags().size(); i++)
        if (pool.alive_flags()[i] > 1) return at(name, i, "has an alive flag that is not 0 or 1");
    return {};
}

// Returns whether World::step() accepts the step length; 0: no step yet.
bool is_step_length(double dt) {
    return dt == 0 || (dt >= 1e-5 && dt <= 0.25);
}

bool body_alive(const BodyStore& bodies, std::uint32_t body) {
    return body < bodies.cold.size() && bodies.ids.alive(body);
}

// Every existing body is in its set exactly once, and the sets contain nothing else.
Fault check_sets(const BodySets& sets) {
    const auto check_set = [&](const std::vector<BodyWarm>& set, BodySet kind,
                               std::uint32_t island) -> Fault {
        for (std::size_t i = 0; i < set.size(); i++) {
            if (!body_alive(sets.bodies, set[i].body)) return at("set", i, "refers to no body");
            const BodyCold& cold = sets.bodies.cold[set[i].body];
            if (cold.set != kind || cold.at != i)
                return at("set", i, "is inconsistent with its body");
            if (kind == BodySet::sleeping && cold.island != island)
                return at("set", i, "is in the wrong island");
            const double norm = norm_squared(set[i].rotation);
            if (!(norm > 1 - 1e-7 && norm < 1 + 1e-7))
                return at("set", i, "has a rotation that is not a unit quaternion");
        }
        return {};
    };
    std::size_t members = sets.bodies.statics.size() + sets.bodies.awake.size();
    if (Fault f = check_set(sets.bodies.statics, BodySet::static_set, none)) return f;
    if (Fault f = check_set(sets.bodies.awake, BodySet::awake, none)) return f;
    for (std::uint32_t i = 0; i < sets.islands.islands.size(); i++) {
        const Island& island = sets.islands.islands[i];
        members += island.sleepers.size();
        if (Fault f = check_set(island.sleepers, BodySet::sleeping, i)) return f;
    }
    if (members != sets.bodies.ids.alive_count_slow())
        return "bodies: the sets contain " + std::to_string(members) + " of " +
               std::to_string(sets.bodies.ids.alive_count_slow());
    return {};
}

Fault check_bodies(const BodySets& sets) {
    if (sets.bodies.motion.size() != sets.bodies.cold.size())
        return "bodies: the numbers of cold and motion records differ";
    for (std::uint32_t i = 0; i < sets.bodies.cold.size(); i++) {
        if (!sets.bodies.ids.alive(i)) continue;
        const BodyCold& b = sets.bodies.cold[i];
        const bool dynamic = b.type == BodyType::dynamic;
        if ((b.type == BodyType::static_body) != (b.set == BodySet::static_set))
            return at("bodies", i, "is in a set that does not match its type");
        if (b.set == BodySet::sleeping && !dynamic)
            return at("bodies", i, "sleeps but is not dynamic");
        if (b.asleep_in_place && (!dynamic || b.set != BodySet::awake))
            return at("bodies", i, "sleeps in place outside the awake set");
        if (dynamic != (b.island != none))
            return at("bodies", i, "has an island that does not match its type");
        if (dynamic && !sets.islands.ids.alive(b.island))
            return at("bodies", i, "is in an island that does not exist");
        if (b.inverse_mass < 0 || b.radius < 0 || b.linear_damping < 0 || b.angular_damping < 0)
            return at("bodies", i, "has a negative mass, radius or damping");
    }
    return {};
}

// Shape lists: each existing shape is on its body's list exactly once.
Fault check_shapes(const BodyStore& bodies, const ShapeStore& store) {
    const auto& shapes = store.shapes;
    std::size_t listed = 0;
    for (std::uint32_t i = 0; i < bodies.cold.size(); i++) {
        if (!bodies.ids.alive(i)) continue;
        std::uint32_t last = none;
        std::size_t steps = 0;
        for (std::uint32_t s = bodies.cold[i].first_shape; s != none; s = shapes[s].next) {
            if (s >= shapes.size() || !store.ids.alive(s) || shapes[s].body != i ||
                ++steps > shapes.size())
                return at("bodies", i, "has a broken list of shapes");
            last = s;
        }
        if (last != bodies.cold[i].last_shape)
            return at("bodies", i, "has a list of shapes with a wrong end");
        listed += steps;
    }
    if (listed != store.ids.alive_count_slow()) return "shapes: some are not on a body's list";
    std::size_t moved = 0;
    for (std::uint32_t s = 0; s < shapes.size(); s++) {
        if (!store.ids.alive(s)) continue;
        moved += shapes[s].moved ? 1 : 0;
        const ShapeKind kind = kind_of(shapes[s].geometry);
        if ((kind == ShapeKind::mesh || kind == ShapeKind::height_field) &&
            bodies.cold[shapes[s].body].type == BodyType::dynamic)
            return at("shapes", s, "is a surface on a dynamic body");
        if (kind_of(shapes[s].geometry) == ShapeKind::plane &&
            bodies.cold[shapes[s].body].type != BodyType::static_body)
            return at("shapes", s, "is a plane on a body that is not static");
    }
    std::vector<std::uint8_t> visited(shapes.size(), 0);
    for (const std::uint32_t s : store.moved)
        if (s >= shapes.size() || !store.ids.alive(s) || !shapes[s].moved || visited[s]++ != 0)
            return at("shapes.moved", s, "is not a moved shape, or is listed twice");
    if (moved != store.moved.size()) return "shapes.moved: a moved shape is missing";
    return {};
}

// A child is on its parent's list exactly once, and the parent counts the touching children.
Fault check_children(const ContactStore& store, std::uint32_t i) {
    const auto& contacts = store.contacts;
    const Contact& c = contacts[i];
    const auto exists = [&](std::uint32_t k) { return k < contacts.size() && store.ids.alive(k); };
    if (c.parent != none) {
        if (!exists(c.parent) || !contacts[c.parent].composite || c.composite || c.has_bound ||
            c.first_child != none || contacts[c.parent].shape_a != c.shape_a ||
            contacts[c.parent].shape_b != c.shape_b)
            return at("contacts", i, "has an invalid parent");
        std::size_t visited = 0, steps = 0;
        for (std::uint32_t p = contacts[c.parent].first_child; p != none;
             p = contacts[p].next_child) {
            if (!exists(p) || ++steps > contacts.size())
                return at("contacts", c.parent, "has a broken list of children");
            visited += p == i ? 1 : 0;
        }
        if (visited != 1) return at("contacts", i, "is not on its parent's list of children");
    } else if (!c.composite && (c.first_child != none || c.touching_children != 0)) {
        return at("contacts", i, "has children but is not composite");
    }
    if (!c.composite) return {};
    if (c.colour >= 0) return at("contacts", i, "is composite but has a manifold");
    std::uint32_t touching = 0;
    std::size_t steps = 0;
    for (std::uint32_t p = c.first_child; p != none; p = contacts[p].next_child) {
        if (!exists(p) || contacts[p].parent != i || ++steps > contacts.size())
            return at("contacts", i, "has a broken list of children");
        touching += contacts[p].touching ? 1 : 0;
    }
    if (touching != c.touching_children)
        return at("contacts", i, "has a wrong count of touching children");
    return {};
}

// Joint lists: every joint is on the lists of its bodies, one of which is dynamic. The first body
// may be none.
Fault check_joints(const BodyStore& bodies, const JointStore& store) {
    const auto& joints = store.joints;
    std::size_t edges = 0, expected_edges = 0;
    for (std::uint32_t i = 0; i < joints.size(); i++) {
        if (!store.ids.alive(i)) continue;
        const Joint& j = joints[i];
        const bool to_world = j.body_a == none;
        if (!(to_world || body_alive(bodies, j.body_a)) || !body_alive(bodies, j.body_b) ||
            j.body_a == j.body_b)
            return at("joints", i, "refers to bodies that do not exist");
        expected_edges += to_world ? 1 : 2;
        if (to_world && !is_dynamic(bodies, j.body_b))
            return at("joints", i, "has no dynamic body");
        if (to_world) continue;
        const BodyCold &a = bodies.cold[j.body_a], &b = bodies.cold[j.body_b];
        if (a.type != BodyType::dynamic && b.type != BodyType::dynamic)
            return at("joints", i, "has no dynamic body");
        if (a.type == BodyType::dynamic && b.type == BodyType::dynamic && a.island != b.island)
            return at("joints", i, "connects two islands");
        const auto moves = [](const BodyCold& c) {
            return c.type != BodyType::static_body && !c.asleep_in_place;
        };
        if ((a.asleep_in_place && moves(b)) || (b.asleep_in_place && moves(a)))
            return at("joints", i, "connects a body that sleeps in place to one that moves");
    }
    for (std::uint32_t i = 0; i < bodies.cold.size(); i++) {
        if (!bodies.ids.alive(i)) continue;
        std::uint32_t previous = none;
        std::size_t steps = 0;
        for (std::uint32_t e = bodies.cold[i].first_joint; e != none;) {
            if (e / 2 >= joints.size() || !store.ids.alive(e / 2) || ++steps > 2 * joints.size())
                return at("bodies", i, "has a broken list of joints");
            const Joint& j = joints[e / 2];
            if ((e % 2 == 0 ? j.body_a : j.body_b) != i || j.prev[e % 2] != previous)
                return at("bodies", i, "has a broken list of joints");
            previous = e;
            e = j.next[e % 2];
        }
        edges += steps;
    }
    if (edges != expected_edges) return "joints: some are not on a body's list";
    return {};
}

Fault check_triggers(const ShapeStore& shapes, const TriggerStore& triggers) {
    const auto& inside = triggers.inside;
    for (std::size_t k = 0; k < inside.size(); k++) {
        if (!shapes.ids.alive(inside[k].trigger) || !shapes.ids.alive(inside[k].shape) ||
            !shapes.shapes[inside[k].trigger].trigger || (k > 0 && !(inside[k - 1] < inside[k])))
            return at("triggers.inside", k, "is out of order or does not refer to a trigger");
    }
    for (const std::uint32_t s : triggers.fresh)
        if (!shapes.ids.alive(s) || !shapes.shapes[s].trigger)
            return at("triggers.fresh", s, "is not a trigger");
    return {};
}

bool exists(ColourSetKey key) {
    return key == asleep_set || (key.tier != SolverTier::asleep && key.batch < batch_count);
}

Fault check_contact(const ContactGraph& stores, std::uint32_t i) {
    const Contact& c = stores.contacts.contacts[i];
    const auto& shapes = stores.shapes.shapes;
    if (c.shape_a >= shapes.size() || c.shape_b >= shapes.size() ||
        !stores.shapes.ids.alive(c.shape_a) || !stores.shapes.ids.alive(c.shape_b) ||
        shapes[c.shape_a].body != c.body_a || shapes[c.shape_b].body != c.body_b ||
        c.body_a == c.body_b)
        return at("contacts", i, "refers to shapes and bodies that do not match");
    if (stores.bodies.cold[c.body_a].type != BodyType::dynamic)
        return at("contacts", i, "has a first body that is not dynamic");
    if (c.colour >= colour_count) return at("contacts", i, "has a colour that does not exist");
    if (c.colour >= 0) {
        if (!exists(c.colour_set)) return at("contacts", i, "has a batch that does not exist");
        for (const std::uint32_t body : {c.body_a, c.body_b}) {
            const std::uint32_t island = stores.bodies.cold[body].island;
            if (island < stores.islands.islands.size() && c.colour_set != asleep_set &&
                stores.islands.islands[island].colour_set != c.colour_set)
                return at("contacts", i, "has a tier or batch that differs from its island's");
        }
        const BodyCold &own = stores.bodies.cold[c.body_a], &other = stores.bodies.cold[c.body_b];
        if ((c.colour_set == asleep_set) !=
            (own.asleep_in_place && (other.asleep_in_place || other.type != BodyType::dynamic)))
            return at("contacts", i,
                      "is in a set that does not match the sleep state of its bodies");
        const GraphColour& colour =
            stores.graph.sets[index_of(c.colour_set)].colours[static_cast<std::size_t>(c.colour)];
        if (c.slot < 0 || c.slot >= colour.contacts)
            return at("contacts", i, "has a slot out of range");
        const auto block = static_cast<std::size_t>(c.slot / lanes_per_block(c.colour));
        if (colour.metas[block].contact[c.slot % lanes_per_block(c.colour)] != i)
            return at("contacts", i, "is inconsistent with its slot");
        const BodyType b = stores.bodies.cold[c.body_b].type;
        const PairKind kind = b == BodyType::dynamic     ? PairKind::dynamic
                              : b == BodyType::kinematic ? PairKind::kinematic
                                                         : PairKind::static_;
        if (pair_kind_of(c.colour) != kind)
            return at("contacts", i, "has a colour of another kind");
        if (stores.bodies.cold[c.body_a].set != BodySet::awake ||
            stores.bodies.cold[c.body_b].set == BodySet::sleeping)
            return at("contacts", i, "is in the constraint graph with a sleeping body");
    }
    if (Fault f = check_children(stores.contacts, i)) return f;
    if (c.touching && stores.bodies.cold[c.body_b].type == BodyType::dynamic &&
        stores.bodies.cold[c.body_a].island != stores.bodies.cold[c.body_b].island)
        return at("contacts", i, "touches across two islands");
    return {};
}

// Edge lists: every contact is on the lists of both its bodies.
Fault check_contacts(const ContactGraph& stores) {
    const auto& contacts = stores.contacts.contacts;
    std::size_t edges = 0;
    for (std::uint32_t i = 0; i < contacts.size(); i++) {
        if (!stores.contacts.ids.alive(i)) continue;
        if (Fault f = check_contact(stores, i)) return f;
    }
    for (std::uint32_t i = 0; i < stores.bodies.cold.size(); i++) {
        if (!stores.bodies.ids.alive(i)) continue;
        std::uint32_t previous = none;
        std::size_t steps = 0;
        for (std::uint32_t e = stores.bodies.cold[i].first_edge; e != none;) {
            if (e / 2 >= contacts.size() || !stores.contacts.ids.alive(e / 2) ||
                ++steps > 2 * contacts.size())
                return at("bodies", i, "has a broken list of contacts");
            const Contact& c = contacts[e / 2];
            if ((e % 2 == 0 ? c.body_a : c.body_b) != i || c.prev[e % 2] != previous)
                return at("bodies", i, "has a broken list of contacts");
            previous = e;
            e = c.next[e % 2];
        }
        edges += steps;
    }
    if (edges != 2 * stores.contacts.ids.alive_count_slow())
        return "contacts: some are not on a body's list";
    std::vector<std::uint8_t> entries(contacts.size(), 0);
    for (std::size_t k = 0; k < stores.contacts.bounds.size(); k++) {
        const SeparationBound& w = stores.contacts.bounds[k];
        if (w.contact >= contacts.size() || !stores.contacts.ids.alive(w.contact) ||
            entries[w.contact]++ != 0 || !contacts[w.contact].has_bound ||
            contacts[w.contact].colour >= 0 || contacts[w.contact].body_a != w.body_a ||
            contacts[w.contact].body_b != w.body_b)
            return at("contacts.bounds", k, "is inconsistent with its contact");
    }
    for (std::uint32_t i = 0; i < contacts.size(); i++)
        if (stores.contacts.ids.alive(i) && contacts[i].has_bound != (entries[i] != 0))
            return at("contacts", i, "has a bound without an entry");
    return {};
}

// Lanes: each belongs to a contact that refers to it, and the colours and counts of bodies match
// the lanes.
Fault check_graph(const ContactGraph& stores) {
    std::vector<std::uint64_t> colours(stores.bodies.cold.size(), 0);
    std::vector<std::uint32_t> constraints(stores.bodies.cold.size(), 0);
    for (int k = 0; k < colour_set_count * colour_count; k++) {
        const auto set = static_cast<std::size_t>(k / colour_count);
        const int c = k % colour_count;
        const GraphColour& colour = stores.graph.sets[set].colours[static_cast<std::size_t>(c)];
        for (std::int32_t slot = 0; slot < colour.contacts; slot++) {
            const ContactConstraintWideMeta& meta =
                colour.metas[static_cast<std::size_t>(slot / lanes_per_block(c))];
            const std::uint32_t contact = meta.contact[slot % lanes_per_block(c)];
            if (contact >= stores.contacts.contacts.size() || !stores.contacts.ids.alive(contact) ||
                stores.contacts.contacts[contact].colour != c ||
                index_of(stores.contacts.contacts[contact].colour_set) != set ||
                stores.contacts.contacts[contact].slot != slot)
                return "graph: a slot of colour " + std::to_string(c) + " belongs to no contact";
            const Contact& owner = stores.contacts.contacts[contact];
            for (const std::uint32_t body : {owner.body_a, owner.body_b}) {
                if (stores.bodies.cold[body].type != BodyType::dynamic) continue;
                constraints[body]++;
                if (is_overflow(c) || set == index_of(asleep_set)) continue;
                if ((colours[body] >> mask_bit(c) & 1) != 0)
                    return at("bodies", body, "has two contacts of one colour");
                colours[body] |= 1ull << mask_bit(c);
            }
        }
    }
    for (std::uint32_t i = 0; i < stores.bodies.cold.size(); i++)
        if (stores.bodies.ids.alive(i) && (stores.bodies.cold[i].colours != colours[i] ||
                                           stores.bodies.cold[i].constraints != constraints[i]))
            return at("bodies", i, "has colours that do not match its contacts");
    return {};
}

Fault check_islands(const ContactGraph& stores) {
    const auto& islands = stores.islands.islands;
    std::size_t listed = 0, dynamic = 0;
    for (std::uint32_t i = 0; i < islands.size(); i++) {
        const Island& island = islands[i];
        if (!stores.islands.ids.alive(i)) {
            if (!island.sleepers.empty() || !island.manifolds.empty())
                return at("islands", i, "is free but not empty");
            continue;
        }
        std::uint32_t previous = none;
        std::size_t count = 0;
        for (std::uint32_t b = island.first; b != none; b = stores.bodies.cold[b].island_next) {
            if (!body_alive(stores.bodies, b) || stores.bodies.cold[b].island != i ||
                stores.bodies.cold[b].island_prev != previous ||
                ++count > stores.bodies.cold.size())
                return at("islands", i, "has a broken list of bodies");
            previous = b;
        }
        listed += count;
        if (previous != island.last || count != island.bodies || count == 0)
            return at("islands", i, "has a list of bodies with a wrong end or length");
        if (island.colour_set.tier == SolverTier::asleep || !exists(island.colour_set))
            return at("islands", i, "has a tier or a batch that does not exist");
        if (!(is_step_length(island.dt) || is_step_length(0.5 * island.dt)) ||
            !(island.remaining_load >= 0 && island.remaining_load <= 1) ||
            island.calm > tuning::tier_patience || island.split_at > stores.steps)
            return at("islands", i,
                      "has a step length, load, calm count or split step out of range");
        if (island.error.estimate < 0 || island.error.target_level >= batch_count ||
            island.error.easy > tuning::substep_level_patience)
            return at("islands", i, "has an error, sub-step level or easy count out of range");
        if (island.sleepers.size() != (island.asleep ? count : 0))
            return at("islands", i, "is asleep with only some of its bodies");
        for (const SavedContact& m : island.manifolds) {
            if (m.contact >= stores.contacts.contacts.size() ||
                !stores.contacts.ids.alive(m.contact) ||
                stores.contacts.contacts[m.contact].colour >= 0 ||
                stores.contacts.contacts[m.contact].has_bound ||
                !stores.contacts.contacts[m.contact].dormant ||
                stores.bodies.cold[stores.contacts.contacts[m.contact].body_a].island != i)
                return at("islands", i, "stores a manifold of a contact that is not dormant in it");
        }
        if (!island.asleep && !island.manifolds.empty())
            return at("islands", i, "is awake but stores manifolds");
    }
    for (std::uint32_t b = 0; b < stores.bodies.cold.size(); b++)
        dynamic += body_alive(stores.bodies, b) && is_dynamic(stores.bodies, b) ? 1 : 0;
    if (listed != dynamic) return "islands: some bodies are not on an island's list";
    return {};
}

}  // namespace

namespace {

Fault check_fields(const FieldStore& fields, const WorldDef& def) {
    for (std::size_t i = 0; i < fields.fields.size(); i++)
        if (const Status s = check_field(fields.fields[i], def.planar); !s.ok())
            return at("fields", i, s.error().message.c_str());
    return {};
}

Fault check_modifiers(const ContactStore& contacts) {
    const std::vector<ContactModifier>& modifiers = contacts.modifiers;
    for (std::size_t i = 0; i < modifiers.size(); i++) {
        const ContactModifier& a = modifiers[i];
        if (!contacts.ids.alive(a.contact)) return at("answers", i, "refers to no contact");
        if (i > 0 && modifiers[i - 1].contact >= a.contact)
            return at("answers", i, "is out of order");
        if (!(a.friction >= 0 && a.restitution >= 0 && a.restitution <= 1))
            return at("answers", i, "has a coefficient out of range");
    }
    return {};
}

}  // namespace

std::optional<std::string> find_fault(const WorldStores& world) {
    const double tolerance = world.def.tolerance;
    if (tolerance != 0 && (tolerance < 1e-9 || tolerance > 1e3))
        return "world.tolerance is out of range";
    if (world.def.substep_budget < 0 || world.def.substep_budget > 4294967295)
        return "world.substep_budget is out of range";
    if (world.def.step_budget < 0 || world.def.step_budget > 4294967295)
        return "world.step_budget is out of range";
    if (world.def.step_budget > 0 && tolerance != 0)
        return "world.step_budget is set together with a tolerance";
    if (world.def.max_pairs_per_shape < 0 ||
        world.def.max_pairs_per_shape > limits::max_pairs_per_shape)
        return "world.max_pairs_per_shape is out of range";
    if (world.overload_level.level > max_overload_level ||
        world.overload_level.easy >= tuning::overload_patience)
        return "world.overload_level is out of range";
    if (world.def.step_budget == 0 &&
        (world.overload_level.level > 0 || world.overload_level.easy > 0))
        return "world.overload_level is above 0 without a budget";
    if (world.def.substeps < 1 || world.def.substeps > limits::max_substeps)
        return "world.substeps is " + std::to_string(world.def.substeps) + ", out of range";
    if (!is_step_length(world.last_dt)) return "world.last_dt is out of range";
    if (!is_step_length(world.stiffness_dt)) return "world.stiffness_dt is out of range";
    if (Fault f = check_pool("bodies", world.bodies.ids, world.bodies.cold)) return f;
    if (Fault f = check_pool("shapes", world.shapes.ids, world.shapes.shapes)) return f;
    if (Fault f = check_pool("contacts", world.contacts.ids, world.contacts.contacts)) return f;
    if (Fault f = check_pool("joints", world.joints.ids, world.joints.joints)) return f;
    if (Fault f = check_pool("islands", world.islands.ids, world.islands.islands)) return f;
    if (Fault f = check_pool("fields", world.fields.ids, world.fields.fields)) return f;
    if (!(world.time >= 0)) return "world.time is negative";
    if (Fault f = find_number_fault(world)) return f;
    // The order matters: each check relies on the previous ones.
    if (Fault f = check_bodies(world)) return f;
    if (Fault f = check_sets(world)) return f;
    if (Fault f = check_shapes(world.bodies, world.shapes)) return f;
    if (Fault f = check_joints(world.bodies, world.joints)) return f;
    if (Fault f = check_triggers(world.shapes, world.triggers)) return f;
    if (Fault f = check_contacts(world)) return f;
    if (Fault f = check_graph(world)) return f;
    if (Fault f = check_islands(world)) return f;
    if (Fault f = check_fields(world.fields, world.def)) return f;
    return check_modifiers(world.contacts);
}

}  // namespace jostle::physics
