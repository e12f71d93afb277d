// SPDX-License-Identifier: MIT
//
// Contacts: one record per pair of shapes whose fat boxes overlap, and one per manifold of pairs
// with several manifolds. A contact is in one of three states: in a slot of the constraint graph
// (it has a manifold), on the list of separation bounds (too far apart for a manifold), or dormant
// (none of its bodies is awake; its manifold, if any, is stored by the sleeping island).
#pragma once

#include <cstdint>
#include <vector>

#include "jostle/base/check.h"
#include "physics/src/collision/narrowphase/collide.h"
#include "physics/src/constraint_graph/solver_tier.h"
#include "physics/src/foundation/flat_array.h"
#include "physics/src/foundation/id_pool.h"
#include "physics/src/foundation/key_set.h"
#include "physics/src/state/body_store.h"

namespace jostle::physics {

struct alignas(64) Contact {
    // Read in every step.
    std::uint32_t shape_a = none, shape_b = none;
    std::uint32_t body_a = none, body_b = none;  // a is dynamic, b has any type
    PairCache cache;
    std::int32_t colour = -1;  // colour of its slot; -1: none
    std::int32_t slot = 0;     // index in that colour
    ColourSetKey colour_set;   // set of its slot
    bool touching = false;     // touched in the last step; connects the islands of both bodies
    bool has_bound = false;    // has an entry in the list of separation bounds
    bool dormant = false;
    bool composite = false;     // has children, see below
    bool has_modifier = false;  // has an entry in ContactStore::modifiers
    bool queued = false;        // within a step: already among the pairs to test

    double limit = -1;  // m: tested when the sum of both motion bounds exceeds it
    // Lists of the contacts of body a [0] and body b [1]; entries are contact * 2 + side.
    std::uint32_t next[2] = {none, none}, prev[2] = {none, none};
    float load[3] = {};  // force on b when one of the bodies fell asleep in place, N

    // A pair with a mesh, height field or compound has no manifold itself. Each of its manifolds is
    // a child contact that refers to the pair as its parent.
    std::uint32_t parent = none;
    std::uint32_t first_child = none;  // of a composite pair
    std::uint32_t next_child = none;   // next child of the same parent
    std::uint64_t key = 0;             // identifies the child: ChildManifold::key
    // Of a composite pair; `touching` is the last reported state.
    std::uint32_t touching_children = 0;
};
static_assert(sizeof(Contact) == 128);  // two cache lines

// A pair that cannot touch yet. It is due when its bodies may have approached each other by its
// slack since the bound was set. The sum of both bodies' travels shows quickly that most pairs are
// not due. For the others, the relative motion is measured: along the direction of their separation
// if it is known, because bodies that pass each other do not approach; otherwise by its length.
struct SeparationBound {
    static constexpr double not_measured = -1e300;

    std::uint32_t contact = none, body_a = none, body_b = none;
    // Directed: unit vector from a to b. Otherwise the vector from a's centre of mass to b's when
    // the bound was set, m.
    float apart[3] = {};
    bool directed = false;
    // Available budget in m: the slack plus both bodies' MotionBound::turned when the bound was
    // set, and for directed bounds minus the distance of the centres along the direction.
    double budget = not_measured;
    double limit = -1;  // m, for the sum of both bodies' motion bounds
};

// Contact properties set by a listener (jostle/physics/step_listener.h), valid from the beginning
// of the manifold to its end. Composite pairs have one per child.
struct ContactModifier {
    std::uint32_t contact = none;
    double friction = 0, restitution = 0;
    Vec3 surface_velocity;  // of b relative to a, m/s, world
    bool enabled = true;
};

inline Vec3 direction_of(const SeparationBound& w) {
    return {double{w.apart[0]}, double{w.apart[1]}, double{w.apart[2]}};
}

struct ContactStore {
    IdPool ids;
    FlatArray<Contact> contacts;
    FlatArray<SeparationBound> bounds;
    std::vector<ContactModifier> modifiers;  // ascending by contact
    bool some_dormant = true;  // conservative: some contact with a bound may be dormant; not saved
    KeySet pairs;              // pair_key() of each contact that is not a child; derived
};

// Counts a pair that begins (1) or ends (-1).
inline void count_pair(BodyStore& bodies, const Contact& pair, int change) {
    ASSERT(pair.parent == none);
    if (bodies.cold[pair.body_b].type != BodyType::dynamic)
        bodies.cold[pair.body_a].fixed_pairs += static_cast<std::uint32_t>(change);
}

inline std::uint64_t pair_key(std::uint32_t shape_a, std::uint32_t shape_b) {
    ASSERT(shape_a != shape_b);
    const std::uint64_t low = shape_a < shape_b ? shape_a : shape_b;
    const std::uint64_t high = shape_a < shape_b ? shape_b : shape_a;
    return low << 32 | high;
}

// Calls visit(contact index) for every contact of a body. visit() may destroy that contact, but no
// other.
template <class Visit>
void for_each_contact(const ContactStore& store, const BodyCold& body, Visit&& visit) {
    for (std::uint32_t edge = body.first_edge; edge != none;) {
        const std::uint32_t contact = edge / 2;
        ASSERT(contact < store.contacts.size());
        edge = store.contacts[contact].next[edge % 2];
        visit(contact);
    }
}

// Calls visit(contact index) for the contacts of a dynamic body that are in the constraint graph;
// most lists contain many others. visit() may move that contact within the graph.
template <class Visit>
void for_each_manifold(const ContactStore& store, const BodyCold& body, Visit&& visit) {
    ASSERT(body.type == BodyType::dynamic);
    std::uint32_t remaining = body.constraints;
    for (std::uint32_t edge = body.first_edge; remaining > 0;) {
        ASSERT(edge != none && edge / 2 < store.contacts.size());
        const std::uint32_t contact = edge / 2;
        edge = store.contacts[contact].next[edge % 2];
        if (store.contacts[contact].colour < 0) continue;
        remaining--;
        visit(contact);
    }
}

}  // namespace jostle::physics
