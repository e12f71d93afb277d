// SPDX-License-Identifier: MIT
//
// The constraint graph defines which contacts are solved, in which order, and which in parallel.
// Its edges are contacts and its nodes are bodies. A colour is a list of contacts of which no two
// share a movable body, so its blocks can be solved in any order and on any thread. Colours are
// grouped in sets: one per solver tier and batch (solver_tier.h), and one for contacts whose bodies
// sleep in place.
//
// The graph refers to contacts and bodies by index only. The block stores the owner of each slot
// (ContactConstraintWideMeta::contact). All changes are serial and in an order that does not depend
// on threads, because slots determine the bits of a solve.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "physics/src/constraint_graph/contact_constraint_wide.h"
#include "physics/src/constraint_graph/solver_tier.h"

namespace jostle::physics {

// 64 colours, as one bit mask per body, plus three overflow lists for bodies with more contacts of
// a kind than there are colours. Blocks of overflow lists hold one lane each and are solved
// serially.
inline constexpr int dynamic_colours = 48, kinematic_colours = 6, static_colours = 10;
inline constexpr int mask_colours = dynamic_colours + kinematic_colours + static_colours;
static_assert(mask_colours == 64);
// Each of the 64 colours has two lists of blocks: manifolds with several points and, from
// single_colours on, manifolds with one point, whose kernels do a quarter of the work.
inline constexpr int single_colours = mask_colours;
inline constexpr int overflow_colours = 2 * mask_colours;
inline constexpr int colour_count = overflow_colours + 3;

inline constexpr bool is_overflow(int colour) {
    return colour >= overflow_colours;
}
inline constexpr bool is_single(int colour) {
    return colour >= single_colours && colour < overflow_colours;
}
// The colour's bit in the masks of the bodies.
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
    // One entry per block. Entries are valid only for lanes that bounce or roll.
    std::vector<RestitutionWide> restitutions;
    std::vector<RollingWide> rollings;
    std::int32_t contacts = 0;
};

struct ColourSet {
    std::array<GraphColour, colour_count> colours;
    std::int32_t contacts = 0;  // sum over all colours
};

struct ConstraintGraph {
    std::array<ColourSet, colour_set_count> sets;  // indexed by index_of(ColourSetKey)

    // The sets that the solver processes.
    auto solved() { return std::span(sets).first<solved_set_count>(); }
    auto solved() const { return std::span(sets).first<solved_set_count>(); }
};

// Contacts with static bodies come last, so that the final pass pushes resting bodies out of the
// floor.
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

// Returns whether threads share the colours of the set. For smaller sets the handover between
// threads would cost more than the work.
bool is_shared(const ColourSet& set);

// Returns the lowest colour of a kind whose bit is not in `used`, or that kind's overflow list.
int free_colour(std::uint64_t used, PairKind kind);
// Contacts between sleeping bodies are not solved, so they need no distinct colours. They are
// distributed over all colours: a single growing list would reserve much more memory than it needs.
int asleep_colour(PairKind kind, std::uint32_t contact);

// Adds a contact at the end of a colour and returns its slot. Only the owner of its lane is set.
std::int32_t add_contact(ConstraintGraph& graph, ColourSetKey key, int colour,
                         std::uint32_t contact);
// Removes a contact. The last contact of the colour moves into its slot. Returns the moved contact,
// or no_contact if the last one was removed.
std::uint32_t remove_contact(ConstraintGraph& graph, ColourSetKey key, int colour,
                             std::int32_t slot);

ContactLaneRef lane_ref_at(GraphColour& colour, int number, std::int32_t slot);
ContactLaneRef lane_ref_at(ConstraintGraph& graph, ColourSetKey key, int colour, std::int32_t slot);

// Copies the content of a lane out of the graph and back. Flags derived from the bodies are not
// included.
SavedContact save_contact(const ContactLaneRef& lane_ref);
void restore_contact(const ContactLaneRef& lane_ref, const SavedContact& saved);

// is_sorted() returns whether most contacts of a colour are in the order of their bodies;
// sort_contacts() establishes that order. Each thread then processes the same bodies in all
// colours. Not for overflow lists, which are solved in insertion order. Sorting changes slots, so
// the caller must update the owners. Different colours may be sorted concurrently.
bool is_sorted(const GraphColour& colour);
void sort_contacts(GraphColour& colour, int number);

// Adds an empty block at the end of a colour.
void add_block(GraphColour& colour);

// Calls visit(colour) or visit(colour, number) for every colour of every non-empty set.
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
