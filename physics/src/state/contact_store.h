// SPDX-License-Identifier: MIT
//
// Contacts: one record per pair of shapes whose fat boxes overlap, from that moment until they
// part; and one per manifold of pairs that have several. A contact is in one of three places: in a
// slot of the constraint graph (it has a manifold), on the list of separation bounds (too far apart
// for one), or dormant (no body of it is awake; its manifold, if any, is kept by the sleeping
// island).
#pragma once

#include <cstdint>
#include <vector>

#include "physics/src/collision/narrowphase/collide.h"
#include "physics/src/constraint_graph/solver_tier.h"
#include "physics/src/foundation/check.h"
#include "physics/src/foundation/flat_array.h"
#include "physics/src/foundation/id_pool.h"
#include "physics/src/foundation/key_set.h"
#include "physics/src/state/body_store.h"

namespace jostle::physics {

struct alignas(64) Contact {
    // What every step reads.
    std::uint32_t shape_a = none, shape_b = none;
    std::uint32_t body_a = none, body_b = none;  // a is dynamic, b may be anything
    PairCache cache;
    std::int32_t colour = -1;  // of its slot; -1: none
    std::int32_t slot = 0;     // in that colour
    ColourSetKey colour_set;   // of its slot
    bool touching = false;     // pressed in the last step; binds the two bodies into one island
    bool has_bound = false;    // has an entry on the list of separation bounds
    bool dormant = false;
    bool composite = false;     // has parts, below
    bool has_modifier = false;  // has an entry among ContactStore::answers
    bool queued = false;        // within a step: already among the pairs to look at

    double limit = -1;  // m: to be looked at when the motion bounds of both bodies exceeds it
    // Lists of the contacts of body a [0] and body b [1]: contact * 2 + side.
    std::uint32_t next[2] = {none, none}, prev[2] = {none, none};
    float load[3] = {};  // N, on b, when one of its bodies fell asleep in place

    // A pair with a shape of many parts has no manifold itself: each of its manifolds is a contact
    // of its own, a part, that names it as parent.
    std::uint32_t parent = none;
    std::uint32_t first_child = none;     // of a composite
    std::uint32_t next_child = none;      // of the same parent
    std::uint64_t key = 0;                // which part: ChildManifold::key
    std::uint32_t touching_children = 0;  // of a composite; `touching` is what was last reported
};
static_assert(sizeof(Contact) == 128);  // two cache lines

// A pair that cannot touch yet. It is due when its bodies may have come nearer to each other than
// its slack since the moment it was put here. The sum of both bodies' travels says at once that
// most are not; for the others the motion against each other is measured: along the direction in
// which they were apart if that is known, since what falls past each other comes no nearer, else
// its length.
struct SeparationBound {
    static constexpr double not_measured = -1e300;

    std::uint32_t contact = none, body_a = none, body_b = none;
    // Directed: unit, from a to b. Else m, from a's centre of mass to b's at that moment.
    float apart[3] = {};
    bool directed = false;
    // m, what may be used up: the slack and both bodies' MotionBound::turned at that moment, and
    // when directed less the distance of the centres along the direction.
    double budget = not_measured;
    double limit = -1;  // m, on the sum of both bodies' reach
};

// What a listener said of a contact (jostle/physics/step_listener.h). Kept from the beginning of
// its manifold to its end; composite pairs have one for each part.
struct ContactModifier {
    std::uint32_t contact = none;
    double friction = 0, restitution = 0;
    Vec3 surface_velocity;  // m/s, world: of b against a
    bool enabled = true;
};

inline Vec3 direction_of(const SeparationBound& w) {
    return {double{w.apart[0]}, double{w.apart[1]}, double{w.apart[2]}};
}

struct ContactStore {
    IdPool ids;
    FlatArray<Contact> contacts;
    FlatArray<SeparationBound> bounds;
    std::vector<ContactModifier> modifiers;  // rising by contact
    bool some_dormant = true;                // of those with a bound, perhaps; not saved
    KeySet pairs;                            // pair_key() of each contact that is no part; derived
};

inline std::uint64_t pair_key(std::uint32_t shape_a, std::uint32_t shape_b) {
    const std::uint64_t low = shape_a < shape_b ? shape_a : shape_b;
    const std::uint64_t high = shape_a < shape_b ? shape_b : shape_a;
    return low << 32 | high;
}

// Calls visit(contact index) for every contact of a body. The visit may destroy that contact, no
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

// ... for those of a dynamic body that are in the constraint graph: most lists hold many more. The
// visit may move that contact within the graph.
template <class Visit>
void for_each_manifold(const ContactStore& store, const BodyCold& body, Visit&& visit) {
    ASSERT(body.type == BodyType::dynamic);
    std::uint32_t left = body.constraints;
    for (std::uint32_t edge = body.first_edge; left > 0;) {
        ASSERT(edge != none && edge / 2 < store.contacts.size());
        const std::uint32_t contact = edge / 2;
        edge = store.contacts[contact].next[edge % 2];
        if (store.contacts[contact].colour < 0) continue;
        left--;
        visit(contact);
    }
}

}  // namespace jostle::physics
