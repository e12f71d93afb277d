// SPDX-License-Identifier: MIT
#include "physics/src/state/contact_constraints.h"

#include <bit>

#include "jostle/base/check.h"
#include "physics/src/state/pair_properties.h"

namespace jostle::physics {
namespace {

PairKind pair_kind_with(const BodyCold& b) {
    if (b.type == BodyType::dynamic) return PairKind::dynamic;
    return b.type == BodyType::kinematic ? PairKind::kinematic : PairKind::static_;
}

InverseMass inverse_mass_of(const BodySets& sets, std::uint32_t body) {
    const BodyCold& cold = sets.bodies.cold[body];
    if (cold.inverse_mass == 0 || cold.asleep_in_place) return {};
    return {free_directions(cold) * cold.inverse_mass,
            world_inverse_inertia(warm_of(sets, body), cold)};
}

bool reports_stays(const ShapeStore& shapes, const Contact& contact) {
    return shapes.shapes[contact.shape_a].report_stays ||
           shapes.shapes[contact.shape_b].report_stays;
}

}  // namespace

ColourSetKey set_of_contact(const BodySets& sets, const Contact& contact) {
    ASSERT(is_dynamic(sets.bodies, contact.body_a));
    const BodyCold &a = sets.bodies.cold[contact.body_a], &b = sets.bodies.cold[contact.body_b];
    if (a.asleep_in_place && (b.asleep_in_place || b.type != BodyType::dynamic)) return asleep_set;
    ASSERT(sets.islands.ids.alive(a.island));
    return sets.islands.islands[a.island].colour_set;
}

void add_contact(ContactGraph& stores, std::uint32_t index, bool single) {
    Contact& contact = stores.contacts.contacts[index];
    BodyCold& a = stores.bodies.cold[contact.body_a];
    BodyCold& b = stores.bodies.cold[contact.body_b];
    ASSERT(contact.colour < 0 && a.set == BodySet::awake && b.set != BodySet::sleeping);
    const PairKind kind = pair_kind_with(b);
    const bool two = kind == PairKind::dynamic;
    ASSERT(!two || stores.islands.islands[a.island].colour_set ==
                       stores.islands.islands[b.island].colour_set);
    contact.colour_set = set_of_contact(stores, contact);
    const bool solved = contact.colour_set != asleep_set;
    int c =
        solved ? free_colour(a.colours | (two ? b.colours : 0), kind) : asleep_colour(kind, index);
    if (!is_overflow(c)) {
        ASSERT(!solved || ((a.colours | (two ? b.colours : 0)) >> c & 1) == 0);
        if (solved) a.colours |= 1ull << c;
        if (solved && two) b.colours |= 1ull << c;
        if (single) c += single_colours;
    }
    a.constraints++;
    if (two) b.constraints++;
    ASSERT(c < colour_count && pair_kind_of(c) == kind);
    contact.colour = c;
    contact.slot = add_contact(stores.graph, contact.colour_set, c, index);
    derive_flags(stores, contact);
    write_body_indices(stores.bodies, stores.graph, contact);
}

void remove_contact(ContactGraph& stores, std::uint32_t index) {
    Contact& contact = stores.contacts.contacts[index];
    ASSERT(contact.colour >= 0);
    ASSERT(stores.contacts.ids.alive(index));
    const int c = contact.colour;
    BodyCold& a = stores.bodies.cold[contact.body_a];
    BodyCold& b = stores.bodies.cold[contact.body_b];
    const bool two = pair_kind_of(c) == PairKind::dynamic;
    ASSERT(two == (b.type == BodyType::dynamic));
    if (!is_overflow(c) && contact.colour_set != asleep_set) {
        ASSERT((a.colours >> mask_bit(c) & 1) != 0 &&
               (!two || (b.colours >> mask_bit(c) & 1) != 0));
        a.colours &= ~(1ull << mask_bit(c));
        if (two) b.colours &= ~(1ull << mask_bit(c));
    }
    ASSERT(a.constraints > 0 && (!two || b.constraints > 0));
    a.constraints--;
    if (two) b.constraints--;
    const std::uint32_t moved = remove_contact(stores.graph, contact.colour_set, c, contact.slot);
    if (moved != no_contact) stores.contacts.contacts[moved].slot = contact.slot;
    ASSERT(moved != index);
    contact.colour = -1;
    contact.slot = 0;
}

SavedContact save_contact(const ContactGraph& stores, std::uint32_t index) {
    return save_contact(lane_ref_of(stores.graph, stores.contacts.contacts[index]));
}

void restore_contact(ContactGraph& stores, const SavedContact& saved) {
    ASSERT(stores.contacts.ids.alive(saved.contact));
    add_contact(stores, saved.contact, is_single_point(saved));
    const Contact& contact = stores.contacts.contacts[saved.contact];
    const ContactLaneRef lane_ref = lane_ref_of(stores.graph, contact);
    restore_contact(lane_ref, saved);
    lane_ref.meta->set(LaneFlag::touching_now, lane_ref.lane, contact.touching);
}

void move_contact(ContactGraph& stores, std::uint32_t contact) {
    const SavedContact saved = save_contact(stores, contact);
    remove_contact(stores, contact);
    restore_contact(stores, saved);
}

bool is_in_its_list(const ConstraintGraph& graph, const Contact& contact) {
    if (is_overflow(contact.colour)) return true;
    const ContactLaneRef lane_ref = lane_ref_of(graph, contact);
    return is_single_point(lane_ref.block->gap[1][lane_ref.lane]) == is_single(contact.colour);
}

void move_to_its_list(ContactGraph& stores, std::uint32_t contact) {
    if (!is_in_its_list(stores.graph, stores.contacts.contacts[contact]))
        move_contact(stores, contact);
}

ContactLaneRef lane_ref_of(ConstraintGraph& graph, const Contact& contact) {
    ASSERT(contact.colour >= 0);
    return lane_ref_at(graph, contact.colour_set, contact.colour, contact.slot);
}

ContactLaneRef lane_ref_of(const ConstraintGraph& graph, const Contact& contact) {
    return lane_ref_of(const_cast<ConstraintGraph&>(graph), contact);
}

void write_body_indices(const BodyStore& bodies, ConstraintGraph& graph, const Contact& contact) {
    const ContactLaneRef lane_ref = lane_ref_of(graph, contact);
    const auto hot_index = [&](std::uint32_t body) {
        const BodyCold& cold = bodies.cold[body];
        return cold.set == BodySet::awake ? static_cast<std::int32_t>(cold.at) + 1 : 0;
    };
    lane_ref.block->a[lane_ref.lane] = hot_index(contact.body_a);
    lane_ref.block->b[lane_ref.lane] = hot_index(contact.body_b);
}

void derive_flags(ContactGraph& stores, const Contact& contact) {
    const ContactLaneRef lane_ref = lane_ref_of(stores.graph, contact);
    const BodyCold &a = stores.bodies.cold[contact.body_a], &b = stores.bodies.cold[contact.body_b];
    const bool two = b.type == BodyType::dynamic;
    const auto set = [&](LaneFlag flag, bool on) { lane_ref.meta->set(flag, lane_ref.lane, on); };
    const auto moves_unevenly = [](const BodyCold& cold) {
        return (cold.locks & (lock_x | lock_y | lock_z)) != 0;
    };
    set(LaneFlag::anisotropic, needs_inertia_matrix(a) || (two && needs_inertia_matrix(b)));
    set(LaneFlag::locked, !stores.def.planar && (moves_unevenly(a) || (two && moves_unevenly(b))));
    set(LaneFlag::reports, reports_stays(stores.shapes, contact));
    set(LaneFlag::touching, contact.touching);
    const double size = size_of_pair(a, b);
    const bool unusual = is_unusual(size, gravity_ratio_squared(stores.def.gravity));
    set(LaneFlag::unusual, unusual);
    if (unusual && may_need_size_level(size, stores.def.gravity))
        stores.islands.small = SmallContacts::began;
    const auto bits = std::bit_cast<std::uint32_t>(unusual ? as_float(size) : 0.0f);
    lane_ref.meta->size[lane_ref.lane] = static_cast<std::uint16_t>(bits >> 16);
}

void sort_contacts(ContactStore& contacts, GraphColour& colour, int number) {
    sort_contacts(colour, number);
    for (std::int32_t slot = 0; slot < colour.contacts; slot++) {
        const ContactLaneRef lane_ref = lane_ref_at(colour, number, slot);
        contacts.contacts[lane_ref.meta->contact[lane_ref.lane]].slot = slot;
    }
}

void write_effective_mass(const BodySets& sets, ConstraintGraph& graph, const Contact& contact,
                          const ContactFrame& frame) {
    write_effective_mass(lane_ref_of(graph, contact), frame, inverse_mass_of(sets, contact.body_a),
                         inverse_mass_of(sets, contact.body_b));
}

void rewrite_effective_mass(const BodySets& sets, ConstraintGraph& graph, const Contact& contact) {
    rewrite_effective_mass(lane_ref_of(graph, contact), inverse_mass_of(sets, contact.body_a),
                           inverse_mass_of(sets, contact.body_b));
}

}  // namespace jostle::physics
