// SPDX-License-Identifier: MIT
#include "state/lanes.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <utility>
#include <vector>

#include "foundation/check.h"
#include "state/tiers.h"

namespace jostle::physics {
namespace {

constexpr int first_saved_row = 2;  // after a and b

void clear_lane(ContactConstraintWide& block, ContactConstraintWideMeta& meta, RollingWide& rolling,
                int lane) {
    for (int row = 0; row < rolling_rows; row++) *lane_float(rolling, row, lane) = 0;
    block.a[lane] = block.b[lane] = 0;
    for (int row = first_saved_row; row < wide_rows; row++) *lane_float(block, row, lane) = 0;
    for (auto& gap : block.gap) gap[lane] = no_point;
    block.g[0][lane] = 1;  // is divided by
    meta.moved[lane] = 0;
    meta.restitution[lane] = 0;
    meta.contact[lane] = none;
    const auto keep = static_cast<std::uint8_t>(~(1u << lane));
    meta.needs_rebuild &= keep;
    meta.touching &= keep;
    meta.touching_now &= keep;
    meta.anisotropic &= keep;
    meta.locked &= keep;
    meta.bounces &= keep;
    meta.rolls &= keep;
    meta.reporting &= keep;
}

std::uint8_t with_bit(std::uint8_t bits, int lane, bool on) {
    const auto bit = static_cast<std::uint8_t>(1u << lane);
    return static_cast<std::uint8_t>(on ? bits | bit : bits & ~bit);
}

void copy_lane(const LanePlace& to, const LanePlace& from) {
    constexpr std::size_t row_bytes = sizeof(ContactConstraintWide) / wide_rows;
    auto* target = reinterpret_cast<char*>(to.block);
    const auto* source = reinterpret_cast<const char*>(from.block);
    for (std::size_t row = 0; row < wide_rows; row++)
        std::memcpy(target + row * row_bytes + 4 * static_cast<std::size_t>(to.lane),
                    source + row * row_bytes + 4 * static_cast<std::size_t>(from.lane), 4);
    for (int row = 0; row < rolling_rows; row++)
        *lane_float(*to.rolling, row, to.lane) = *lane_float(*from.rolling, row, from.lane);
    to.meta->moved[to.lane] = from.meta->moved[from.lane];
    to.meta->restitution[to.lane] = from.meta->restitution[from.lane];
    to.meta->contact[to.lane] = from.meta->contact[from.lane];
    const auto copy = [&](std::uint8_t ContactConstraintWideMeta::*bits) {
        to.meta->*bits =
            with_bit(to.meta->*bits, to.lane, (from.meta->*bits >> from.lane & 1) != 0);
    };
    copy(&ContactConstraintWideMeta::needs_rebuild);
    copy(&ContactConstraintWideMeta::touching);
    copy(&ContactConstraintWideMeta::touching_now);
    copy(&ContactConstraintWideMeta::anisotropic);
    copy(&ContactConstraintWideMeta::locked);
    copy(&ContactConstraintWideMeta::bounces);
    copy(&ContactConstraintWideMeta::rolls);
    copy(&ContactConstraintWideMeta::reporting);
}

LanePlace place_at(Colour& colour, int colour_index, std::int32_t slot) {
    const auto block = static_cast<std::size_t>(slot / lanes_per_block(colour_index));
    return {&colour, &colour.blocks[block], &colour.metas[block], &colour.rollings[block],
            slot % lanes_per_block(colour_index)};
}

PairKind pair_kind_with(const BodyCold& b) {
    if (b.type == BodyType::dynamic) return PairKind::dynamic;
    return b.type == BodyType::kinematic ? PairKind::kinematic : PairKind::static_;
}

int free_colour(std::uint64_t taken, PairKind kind) {
    int first = 0, last = dynamic_colours;
    if (kind == PairKind::kinematic)
        first = dynamic_colours, last = dynamic_colours + kinematic_colours;
    if (kind == PairKind::static_) first = dynamic_colours + kinematic_colours, last = mask_colours;
    for (int c = first; c < last; c++)
        if ((taken >> c & 1) == 0) return c;
    return overflow_colours + static_cast<int>(kind);
}

// Of a colour most of whose lanes went, perhaps to the same one of another store: a heap would keep
// its memory in each store that it was ever in.
void forget_room(Colour& colour) {
    constexpr std::size_t much = 8;  // blocks
    const std::size_t room = colour.blocks.capacity();
    if (room <= much || 4 * colour.blocks.size() > room) return;
    colour.blocks.shrink_to_fit();
    colour.metas.shrink_to_fit();
    colour.restitutions.shrink_to_fit();
    colour.rollings.shrink_to_fit();
}

// Between frozen bodies nothing is solved, so nothing needs a colour of its own; all of them,
// because a long list that grows holds much more than it needs.
int frozen_colour(PairKind kind, std::uint32_t contact) {
    const auto any_of = [&](int first, int count) {
        return first + static_cast<int>(contact % static_cast<std::uint32_t>(count));
    };
    if (kind == PairKind::dynamic) return any_of(0, dynamic_colours);
    return kind == PairKind::kinematic
               ? any_of(dynamic_colours, kinematic_colours)
               : any_of(dynamic_colours + kinematic_colours, static_colours);
}

}  // namespace

void add_block(Colour& colour) {
    colour.blocks.emplace_back();
    colour.metas.emplace_back();
    colour.restitutions.emplace_back();
    colour.rollings.emplace_back();
    std::memset(static_cast<void*>(&colour.blocks.back()), 0, sizeof(ContactConstraintWide));
    std::memset(static_cast<void*>(&colour.restitutions.back()), 0, sizeof(RestitutionWide));
    for (int lane = 0; lane < 8; lane++)
        clear_lane(colour.blocks.back(), colour.metas.back(), colour.rollings.back(), lane);
}

namespace {

ColourSet& colour_set_of(WorldState& world, const Contact& contact) {
    return world.graph.sets[index_of(contact.colour_set)];
}
Colour& colour_of(WorldState& world, const Contact& contact) {
    return colour_set_of(world, contact).colours[static_cast<std::size_t>(contact.colour)];
}

}  // namespace

ColourSetKey set_of_contact(const WorldState& world, const Contact& contact) {
    const BodyCold &a = world.bodies.cold[contact.body_a], &b = world.bodies.cold[contact.body_b];
    if (a.frozen && (b.frozen || b.type != BodyType::dynamic)) return asleep_set;
    return world.islands.islands[a.island].colour_set;
}

LanePlace place_of(WorldState& world, const Contact& contact) {
    ASSERT(contact.colour >= 0);
    return place_at(colour_of(world, contact), contact.colour, contact.slot);
}

void write_body_indices(WorldState& world, const Contact& contact) {
    const LanePlace place = place_of(world, contact);
    const auto hot_index = [&](std::uint32_t body) {
        const BodyCold& cold = world.bodies.cold[body];
        return cold.set == BodySet::awake ? static_cast<std::int32_t>(cold.at) + 1 : 0;
    };
    place.block->a[place.lane] = hot_index(contact.body_a);
    place.block->b[place.lane] = hot_index(contact.body_b);
}

void take_lane(WorldState& world, std::uint32_t contact_index, bool single) {
    Contact& contact = world.contacts.contacts[contact_index];
    BodyCold& a = world.bodies.cold[contact.body_a];
    BodyCold& b = world.bodies.cold[contact.body_b];
    ASSERT(contact.colour < 0 && a.set == BodySet::awake && b.set != BodySet::sleeping);
    const PairKind kind = pair_kind_with(b);
    if (kind == PairKind::dynamic) match_sets(world, a.island, b.island);
    contact.colour_set = set_of_contact(world, contact);
    const bool solved = contact.colour_set != asleep_set;
    int c = solved ? free_colour(a.colours | (kind == PairKind::dynamic ? b.colours : 0), kind)
                   : frozen_colour(kind, contact_index);
    if (!is_overflow(c)) {
        if (solved) a.colours |= 1ull << c;
        if (solved && kind == PairKind::dynamic) b.colours |= 1ull << c;
        if (single) c += single_colours;
    }
    a.lanes++;
    if (kind == PairKind::dynamic) b.lanes++;

    contact.colour = c;
    Colour& colour = colour_of(world, contact);
    if (colour.lanes % lanes_per_block(c) == 0) add_block(colour);
    contact.slot = colour.lanes++;
    colour_set_of(world, contact).lanes++;
    const LanePlace place = place_of(world, contact);
    place.meta->contact[place.lane] = contact_index;
    const bool turning = !a.isotropic || (kind == PairKind::dynamic && !b.isotropic);
    place.meta->anisotropic = with_bit(place.meta->anisotropic, place.lane, turning);
    const bool locked =
        !world.def.planar && (a.locks != 0 || (kind == PairKind::dynamic && b.locks != 0));
    place.meta->locked = with_bit(place.meta->locked, place.lane, locked);
    place.meta->reporting =
        with_bit(place.meta->reporting, place.lane, reports_stays(world, contact));
    write_body_indices(world, contact);
}

void release_lane(WorldState& world, std::uint32_t contact_index) {
    Contact& contact = world.contacts.contacts[contact_index];
    const int c = contact.colour;
    BodyCold& a = world.bodies.cold[contact.body_a];
    BodyCold& b = world.bodies.cold[contact.body_b];
    const bool two = pair_kind_of(c) == PairKind::dynamic;
    if (!is_overflow(c) && contact.colour_set != asleep_set) {
        a.colours &= ~(1ull << mask_bit(c));
        if (two) b.colours &= ~(1ull << mask_bit(c));
    }
    a.lanes--;
    if (two) b.lanes--;

    Colour& colour = colour_of(world, contact);
    const LanePlace hole = place_of(world, contact);
    const LanePlace last = place_at(colour, c, colour.lanes - 1);
    if (contact.slot != colour.lanes - 1) {
        copy_lane(hole, last);
        world.contacts.contacts[hole.meta->contact[hole.lane]].slot = contact.slot;
    }
    clear_lane(*last.block, *last.meta, *last.rolling, last.lane);
    colour.lanes--;
    colour_set_of(world, contact).lanes--;
    if (last.lane == 0) {
        colour.blocks.pop_back();
        colour.metas.pop_back();
        colour.restitutions.pop_back();
        colour.rollings.pop_back();
        forget_room(colour);
    }
    contact.colour = -1;
    contact.slot = 0;
}

namespace {

// Twice the mean of its moving bodies' indices.
std::int32_t place_in_bodies(const Colour& colour, int slot) {
    const ContactConstraintWide& block = colour.blocks[static_cast<std::size_t>(slot / 8)];
    const std::int32_t a = block.a[slot % 8], b = block.b[slot % 8];
    return b > 0 ? a + b : 2 * a;
}

}  // namespace

bool in_order(const Colour& colour) {
    int out = 0;
    for (int slot = 1; slot < colour.lanes; slot++)
        out += place_in_bodies(colour, slot) < place_in_bodies(colour, slot - 1) ? 1 : 0;
    return out <= colour.lanes / 256;
}

void sort_lanes(WorldState& world, Colour& colour, int number) {
    ASSERT(!is_overflow(number));  // those are solved in the order in which they came
    std::vector<std::pair<std::int32_t, std::int32_t>> order;
    for (std::int32_t slot = 0; slot < colour.lanes; slot++)
        order.push_back({place_in_bodies(colour, slot), slot});
    std::sort(order.begin(), order.end());
    Colour sorted;
    sorted.blocks.reserve(colour.blocks.size());
    sorted.metas.reserve(colour.blocks.size());
    sorted.restitutions.reserve(colour.blocks.size());
    sorted.rollings.reserve(colour.blocks.size());
    for (const auto& [key, from] : order) {
        const std::int32_t slot = sorted.lanes++;
        if (slot % 8 == 0) add_block(sorted);
        const LanePlace place = place_at(sorted, number, slot);
        copy_lane(place, place_at(colour, number, from));
        world.contacts.contacts[place.meta->contact[place.lane]].slot = slot;
    }
    colour = std::move(sorted);
}

bool is_settled(const WorldState& world, const Contact& contact) {
    if (is_overflow(contact.colour)) return true;
    const LanePlace place = place_of(const_cast<WorldState&>(world), contact);
    return is_single_point(place.block->gap[1][place.lane]) == is_single(contact.colour);
}

void settle_lane(WorldState& world, std::uint32_t contact_index) {
    if (is_settled(world, world.contacts.contacts[contact_index])) return;
    const SavedManifold saved = save_lane(world, contact_index);
    release_lane(world, contact_index);
    restore_lane(world, saved);
}

SavedManifold save_lane(const WorldState& world, std::uint32_t contact_index) {
    const LanePlace place =
        place_of(const_cast<WorldState&>(world), world.contacts.contacts[contact_index]);
    SavedManifold saved{.contact = contact_index,
                        .moved = place.meta->moved[place.lane],
                        .restitution = place.meta->restitution[place.lane],
                        .needs_rebuild = (place.meta->needs_rebuild >> place.lane & 1) != 0,
                        .rolls = (place.meta->rolls >> place.lane & 1) != 0};
    for (int row = 0; row < rolling_rows; row++)
        saved.rolling_values[static_cast<std::size_t>(row)] =
            *lane_float(*place.rolling, row, place.lane);
    for (int row = first_saved_row; row < wide_rows; row++)
        saved.rows[static_cast<std::size_t>(row - first_saved_row)] =
            *lane_float(*place.block, row, place.lane);
    return saved;
}

void restore_lane(WorldState& world, const SavedManifold& saved) {
    constexpr std::size_t second_gap =
        offsetof(ContactConstraintWide, gap) / 32 + 1 - first_saved_row;
    take_lane(world, saved.contact, is_single_point(saved.rows[second_gap]));
    const Contact& contact = world.contacts.contacts[saved.contact];
    const LanePlace place = place_of(world, contact);
    for (int row = first_saved_row; row < wide_rows; row++)
        *lane_float(*place.block, row, place.lane) =
            saved.rows[static_cast<std::size_t>(row - first_saved_row)];
    for (int row = 0; row < rolling_rows; row++)
        *lane_float(*place.rolling, row, place.lane) =
            saved.rolling_values[static_cast<std::size_t>(row)];
    place.meta->rolls = with_bit(place.meta->rolls, place.lane, saved.rolls);
    place.meta->moved[place.lane] = saved.moved;
    place.meta->restitution[place.lane] = saved.restitution;
    place.meta->needs_rebuild =
        with_bit(place.meta->needs_rebuild, place.lane, saved.needs_rebuild);
    place.meta->touching = with_bit(place.meta->touching, place.lane, contact.touching);
    place.meta->touching_now = with_bit(place.meta->touching_now, place.lane, contact.touching);
    place.meta->bounces = with_bit(place.meta->bounces, place.lane, saved.restitution > 0);
}

}  // namespace jostle::physics
