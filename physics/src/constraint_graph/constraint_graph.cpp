// SPDX-License-Identifier: MIT
#include "physics/src/constraint_graph/constraint_graph.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "jostle/base/check.h"
#include "physics/src/foundation/tuning.h"

namespace jostle::physics {
namespace {

void clear_lane(const ContactLaneRef& lane_ref) {
    ASSERT(lane_ref.lane >= 0 && lane_ref.lane < block_lanes);
    ContactConstraintWide& block = *lane_ref.block;
    const int lane = lane_ref.lane;
    for (int row = 0; row < rolling_rows; row++) float_at(*lane_ref.rolling, row, lane) = 0;
    block.a[lane] = block.b[lane] = 0;
    for (int row = first_saved_row; row < wide_rows; row++) float_at(block, row, lane) = 0;
    for (auto& gap : block.gap) gap[lane] = no_point;
    block.g[0][lane] = 1;  // used as a divisor
    lane_ref.meta->moved[lane] = 0;
    lane_ref.meta->restitution[lane] = 0;
    lane_ref.meta->contact[lane] = no_contact;
    lane_ref.meta->size[lane] = 0;
    for (std::uint8_t& bits : lane_ref.meta->flags)
        bits &= static_cast<std::uint8_t>(~(1u << lane));
}

void copy_lane(const ContactLaneRef& to, const ContactLaneRef& from) {
    ASSERT(from.meta->contact[from.lane] != no_contact);
    constexpr std::size_t row_bytes = sizeof(ContactConstraintWide) / wide_rows;
    auto* target = reinterpret_cast<char*>(to.block);
    const auto* source = reinterpret_cast<const char*>(from.block);
    for (std::size_t row = 0; row < wide_rows; row++)
        std::memcpy(target + row * row_bytes + 4 * static_cast<std::size_t>(to.lane),
                    source + row * row_bytes + 4 * static_cast<std::size_t>(from.lane), 4);
    for (int row = 0; row < rolling_rows; row++)
        float_at(*to.rolling, row, to.lane) = float_at(*from.rolling, row, from.lane);
    to.meta->moved[to.lane] = from.meta->moved[from.lane];
    to.meta->restitution[to.lane] = from.meta->restitution[from.lane];
    to.meta->contact[to.lane] = from.meta->contact[from.lane];
    to.meta->size[to.lane] = from.meta->size[from.lane];
    for (std::size_t k = 0; k < lane_flag_count; k++) {
        const auto flag = static_cast<LaneFlag>(k);
        to.meta->set(flag, to.lane, from.meta->has(flag, from.lane));
    }
}

GraphColour& colour_at(ConstraintGraph& graph, ColourSetKey key, int colour) {
    ASSERT(colour >= 0 && colour < colour_count);
    return graph.sets[index_of(key)].colours[static_cast<std::size_t>(colour)];
}

// Releases memory after most contacts of a colour were removed or moved to another set. Otherwise a
// pile would retain memory in every set that it was ever in.
void shrink(GraphColour& colour) {
    constexpr std::size_t small = 8;  // blocks
    const std::size_t capacity = colour.blocks.capacity();
    if (capacity <= small || 4 * colour.blocks.size() > capacity) return;
    colour.blocks.shrink_to_fit();
    colour.metas.shrink_to_fit();
    colour.restitutions.shrink_to_fit();
    colour.rollings.shrink_to_fit();
}

void remove_block(GraphColour& colour) {
    ASSERT(!colour.blocks.empty() && colour.metas.size() == colour.blocks.size());
    ASSERT(colour.restitutions.size() == colour.blocks.size() &&
           colour.rollings.size() == colour.blocks.size());
    colour.blocks.pop_back();
    colour.metas.pop_back();
    colour.restitutions.pop_back();
    colour.rollings.pop_back();
}

// Returns the first colour of a kind and the number of its colours.
std::pair<int, int> colours_of(PairKind kind) {
    if (kind == PairKind::dynamic) return {0, dynamic_colours};
    if (kind == PairKind::kinematic) return {dynamic_colours, kinematic_colours};
    return {dynamic_colours + kinematic_colours, static_colours};
}

// Sort key: twice the mean index of the dynamic bodies.
std::int32_t body_order(const GraphColour& colour, int slot) {
    ASSERT(slot >= 0 && slot < colour.contacts);
    const ContactConstraintWide& block = colour.blocks[static_cast<std::size_t>(slot / 8)];
    const std::int32_t a = block.a[slot % 8], b = block.b[slot % 8];
    return b > 0 ? a + b : 2 * a;
}

}  // namespace

bool is_shared(const ColourSet& set) {
    return set.contacts >= tuning::shared_contacts;
}

int free_colour(std::uint64_t used, PairKind kind) {
    const auto [first, count] = colours_of(kind);
    for (int c = first; c < first + count; c++)
        if ((used >> c & 1) == 0) return c;
    return overflow_colours + static_cast<int>(kind);
}

int asleep_colour(PairKind kind, std::uint32_t contact) {
    const auto [first, count] = colours_of(kind);
    return first + static_cast<int>(contact % static_cast<std::uint32_t>(count));
}

std::int32_t add_contact(ConstraintGraph& graph, ColourSetKey key, int number,
                         std::uint32_t contact) {
    ASSERT(contact != no_contact);
    GraphColour& colour = colour_at(graph, key, number);
    if (colour.contacts % lanes_per_block(number) == 0) add_block(colour);
    const std::int32_t slot = colour.contacts++;
    graph.sets[index_of(key)].contacts++;
    const ContactLaneRef lane_ref = lane_ref_at(colour, number, slot);
    ASSERT(lane_ref.meta->contact[lane_ref.lane] == no_contact);
    lane_ref.meta->contact[lane_ref.lane] = contact;
    return slot;
}

std::uint32_t remove_contact(ConstraintGraph& graph, ColourSetKey key, int number,
                             std::int32_t slot) {
    GraphColour& colour = colour_at(graph, key, number);
    ASSERT(slot >= 0 && slot < colour.contacts);
    const ContactLaneRef hole = lane_ref_at(colour, number, slot);
    ASSERT(hole.meta->contact[hole.lane] != no_contact);
    const ContactLaneRef last = lane_ref_at(colour, number, colour.contacts - 1);
    std::uint32_t moved = no_contact;
    if (slot != colour.contacts - 1) {
        copy_lane(hole, last);
        moved = hole.meta->contact[hole.lane];
    }
    clear_lane(last);
    colour.contacts--;
    ASSERT(colour.contacts >= 0);
    graph.sets[index_of(key)].contacts--;
    ASSERT(graph.sets[index_of(key)].contacts >= 0);
    if (last.lane == 0) {
        remove_block(colour);
        shrink(colour);
    }
    // Invariant: no block is empty.
    ASSERT(static_cast<int>(colour.blocks.size()) ==
           (colour.contacts + lanes_per_block(number) - 1) / lanes_per_block(number));
    return moved;
}

ContactLaneRef lane_ref_at(GraphColour& colour, int number, std::int32_t slot) {
    ASSERT(slot >= 0 && slot < colour.contacts);
    const auto block = static_cast<std::size_t>(slot / lanes_per_block(number));
    ASSERT(block < colour.blocks.size() && colour.metas.size() == colour.blocks.size());
    return {&colour.blocks[block], &colour.metas[block], &colour.rollings[block],
            slot % lanes_per_block(number)};
}

ContactLaneRef lane_ref_at(ConstraintGraph& graph, ColourSetKey key, int colour,
                           std::int32_t slot) {
    return lane_ref_at(colour_at(graph, key, colour), colour, slot);
}

SavedContact save_contact(const ContactLaneRef& lane_ref) {
    const ContactConstraintWideMeta& meta = *lane_ref.meta;
    const int lane = lane_ref.lane;
    SavedContact saved{.contact = meta.contact[lane],
                       .moved = meta.moved[lane],
                       .restitution = meta.restitution[lane],
                       .needs_rebuild = meta.has(LaneFlag::needs_rebuild, lane),
                       .rolls = meta.has(LaneFlag::rolls, lane)};
    for (int row = 0; row < rolling_rows; row++)
        saved.rolling_values[static_cast<std::size_t>(row)] =
            float_at(*lane_ref.rolling, row, lane);
    for (int row = first_saved_row; row < wide_rows; row++)
        saved.rows[static_cast<std::size_t>(row - first_saved_row)] =
            float_at(*lane_ref.block, row, lane);
    return saved;
}

void restore_contact(const ContactLaneRef& lane_ref, const SavedContact& saved) {
    ASSERT(saved.restitution >= 0 && saved.moved >= 0);
    ContactConstraintWideMeta& meta = *lane_ref.meta;
    const int lane = lane_ref.lane;
    ASSERT(meta.contact[lane] == saved.contact);
    for (int row = first_saved_row; row < wide_rows; row++)
        float_at(*lane_ref.block, row, lane) =
            saved.rows[static_cast<std::size_t>(row - first_saved_row)];
    for (int row = 0; row < rolling_rows; row++)
        float_at(*lane_ref.rolling, row, lane) =
            saved.rolling_values[static_cast<std::size_t>(row)];
    meta.moved[lane] = saved.moved;
    meta.restitution[lane] = saved.restitution;
    meta.set(LaneFlag::rolls, lane, saved.rolls);
    meta.set(LaneFlag::needs_rebuild, lane, saved.needs_rebuild);
    meta.set(LaneFlag::bounces, lane, saved.restitution > 0);
}

bool is_sorted(const GraphColour& colour) {
    int out = 0;
    for (int slot = 1; slot < colour.contacts; slot++)
        out += body_order(colour, slot) < body_order(colour, slot - 1) ? 1 : 0;
    return out <= colour.contacts / tuning::sorted_share;
}

void sort_contacts(GraphColour& colour, int number) {
    ASSERT(!is_overflow(number));
    std::vector<std::pair<std::int32_t, std::int32_t>> order;
    for (std::int32_t slot = 0; slot < colour.contacts; slot++)
        order.push_back({body_order(colour, slot), slot});
    std::sort(order.begin(), order.end());
    GraphColour sorted;
    sorted.blocks.reserve(colour.blocks.size());
    sorted.metas.reserve(colour.blocks.size());
    sorted.restitutions.reserve(colour.blocks.size());
    sorted.rollings.reserve(colour.blocks.size());
    for (const auto& [key, from] : order) {
        const std::int32_t slot = sorted.contacts++;
        if (slot % block_lanes == 0) add_block(sorted);
        copy_lane(lane_ref_at(sorted, number, slot), lane_ref_at(colour, number, from));
    }
    ASSERT(sorted.blocks.size() == colour.blocks.size());
    colour = std::move(sorted);
}

void add_block(GraphColour& colour) {
    ASSERT(colour.metas.size() == colour.blocks.size());
    colour.blocks.emplace_back();
    colour.metas.emplace_back();
    colour.restitutions.emplace_back();
    colour.rollings.emplace_back();
    std::memset(static_cast<void*>(&colour.blocks.back()), 0, sizeof(ContactConstraintWide));
    std::memset(static_cast<void*>(&colour.restitutions.back()), 0, sizeof(RestitutionWide));
    for (int lane = 0; lane < block_lanes; lane++)
        clear_lane({&colour.blocks.back(), &colour.metas.back(), &colour.rollings.back(), lane});
}

}  // namespace jostle::physics
