// SPDX-License-Identifier: MIT
//
// The constraint graph: which contacts are solved, in which order, and which at the same time. Its
// edges are contacts, its nodes bodies. A colour is a list of contacts no two of which share a body
// that they can push, so its blocks may be solved in any order and on any thread. Colours come in
// sets: one per solver tier and batch (solver_tier.h), and one for what sleeps in place.
//
// Knows contacts and bodies by number only. Who owns a slot is written in the block
// (ContactConstraintWideMeta::contact). Changed serially, in an order that does not depend on
// threads: slots decide the bits of a solve.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "physics/src/constraint_graph/contact_constraint_wide.h"
#include "physics/src/constraint_graph/solver_tier.h"

namespace jostle::physics {

// 64 colours, as one bit mask per body, and three overflow lists whose blocks hold one lane each
// and are solved one after the other, for bodies with more contacts of a kind than there are
// colours.
inline constexpr int dynamic_colours = 48, kinematic_colours = 6, static_colours = 10;
inline constexpr int mask_colours = dynamic_colours + kinematic_colours + static_colours;
static_assert(mask_colours == 64);
// Each of the 64 has two lists of blocks: manifolds of several points, and, from single_colours on,
// those of one point, whose kernels do a quarter of the work.
inline constexpr int single_colours = mask_colours;
inline constexpr int overflow_colours = 2 * mask_colours;
inline constexpr int colour_count = overflow_colours + 3;

inline constexpr bool is_overflow(int colour) {
    return colour >= overflow_colours;
}
inline constexpr bool is_single(int colour) {
    return colour >= single_colours && colour < overflow_colours;
}
// The bit in the bodies' masks.
inline constexpr int mask_bit(int colour) {
    return colour % mask_colours;
}
inline constexpr PairKind pair_kind_of(int colour) {
    if (is_overflow(colour)) return static_cast<PairKind>(colour - overflow_colours);
    const int bit = mask_bit(colour);
    if (bit < dynamic_colours) return PairKind::dynamic;
    return bit < dynamic_colours + kinematic_colours ? PairKind::kinematic : PairKind::static_;
}
inline constexpr int lanes_per_block(int colour) {
    return is_overflow(colour) ? 1 : block_lanes;
}

struct GraphColour {
    std::vector<ContactConstraintWide> blocks;
    std::vector<ContactConstraintWideMeta> metas;
    // As many as blocks; contents mean something where a lane bounces or rolls.
    std::vector<RestitutionWide> restitutions;
    std::vector<RollingWide> rollings;
    std::int32_t contacts = 0;
};

struct ColourSet {
    std::array<GraphColour, colour_count> colours;
    std::int32_t contacts = 0;  // of all colours
};

struct ConstraintGraph {
    std::array<ColourSet, colour_set_count> sets;  // by index_of(ColourSetKey)

    // Those that the solver works on.
    auto solved() { return std::span(sets).first<solved_set_count>(); }
    auto solved() const { return std::span(sets).first<solved_set_count>(); }
};

// Contacts with static bodies come last: what rests on the floor is pushed out of it in the end.
inline constexpr std::array<int, colour_count> make_solve_order() {
    std::array<int, colour_count> order{};
    int n = 0;
    for (const PairKind kind : {PairKind::dynamic, PairKind::kinematic, PairKind::static_}) {
        order[static_cast<unsigned>(n++)] = overflow_colours + static_cast<int>(kind);
        for (int c = 0; c < mask_colours; c++)
            if (pair_kind_of(c) == kind) {
                order[static_cast<unsigned>(n++)] = c;
                order[static_cast<unsigned>(n++)] = single_colours + c;
            }
    }
    return order;
}
inline constexpr std::array<int, colour_count> solve_order = make_solve_order();

// Whether threads share its colours. Those of a smaller one are so short that handing them over
// again and again would cost more than they do.
bool is_shared(const ColourSet& set);

// The lowest colour of a kind whose bit is not taken, else that kind's overflow list.
int free_colour(std::uint64_t taken, PairKind kind);
// Between bodies that sleep nothing is solved, so nothing needs a colour of its own. All colours
// are used in turn: one long list that grows would hold much more memory than it needs.
int asleep_colour(PairKind kind, std::uint32_t contact);

// Adds a contact at the end of a colour and returns its slot. Its lane is empty but for its owner.
std::int32_t add_contact(ConstraintGraph& graph, ColourSetKey key, int colour,
                         std::uint32_t contact);
// Removes a contact. The last one of the colour moves into its slot: returns that one, or
// no_contact when the last one was removed.
std::uint32_t remove_contact(ConstraintGraph& graph, ColourSetKey key, int colour,
                             std::int32_t slot);

ContactLaneRef lane_ref_at(GraphColour& colour, int number, std::int32_t slot);
ContactLaneRef lane_ref_at(ConstraintGraph& graph, ColourSetKey key, int colour, std::int32_t slot);

// A lane's content outside the graph and back again. The flags that follow from the bodies are not
// part of it.
SavedContact save_contact(const ContactLaneRef& lane_ref);
void restore_contact(const ContactLaneRef& lane_ref, const SavedContact& saved);

// Whether most contacts of a colour lie in the order of their bodies; brings them there. Then each
// thread has the same bodies in all colours. Not for overflow lists, which are solved in the order
// in which they came. Slots change: the owners are to be told. Colours may be sorted at the same
// time.
bool is_sorted(const GraphColour& colour);
void sort_contacts(GraphColour& colour, int number);

// Adds an empty block at the end of a colour.
void add_block(GraphColour& colour);

// Calls visit(colour) or visit(colour, its number) for every colour of every set in use.
template <class Sets, class Visit>
void for_each_colour(Sets&& sets, Visit&& visit) {
    for (auto& set : sets) {
        if (set.contacts == 0) continue;
        for (int c = 0; c < colour_count; c++) {
            auto& colour = set.colours[static_cast<std::size_t>(c)];
            if constexpr (std::is_invocable_v<Visit, decltype(colour), int>)
                visit(colour, c);
            else
                visit(colour);
        }
    }
}

}  // namespace jostle::physics
