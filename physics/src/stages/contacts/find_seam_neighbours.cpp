// SPDX-License-Identifier: MIT
#include "physics/src/stages/contacts/find_seam_neighbours.h"

#include "jostle/base/check.h"
#include "physics/src/state/contact_store.h"

namespace jostle::physics {
namespace {

bool has_several_shapes(const BodyCold& body) {
    return body.first_shape != body.last_shape;
}

bool gives_way(const BodyCold& body) {
    return body.type == BodyType::dynamic;
}

// Calls visit(shape) for the other shapes of a body that have a pair with the opposite shape.
template <class Visit>
void for_each_sibling(const ContactGraph& stores, std::uint32_t shape, std::uint32_t opposite,
                      Visit&& visit) {
    const std::vector<ShapeRecord>& shapes = stores.shapes.shapes;
    const Aabb& fat = shapes[opposite].fat;
    for (std::uint32_t s = stores.bodies.cold[shapes[shape].body].first_shape; s != none;
         s = shapes[s].next)
        if (s != shape && overlap(shapes[s].fat, fat) &&
            stores.contacts.pairs.contains(pair_key(s, opposite)))
            visit(s);
}

SeamShapes neighbours_in_contact_list(const ContactGraph& stores, const Contact& contact) {
    const BodyCold &a = stores.bodies.cold[contact.body_a], &b = stores.bodies.cold[contact.body_b];
    SeamShapes found;
    for_each_contact(stores.contacts, a, [&](std::uint32_t index) {
        const Contact& other = stores.contacts.contacts[index];
        if (&other == &contact || other.parent != none || other.has_modifier) return;
        const bool same_side = other.body_a == contact.body_a;
        const std::uint32_t own = same_side ? other.shape_a : other.shape_b;
        const std::uint32_t shape = same_side ? other.shape_b : other.shape_a;
        const std::uint32_t body = same_side ? other.body_b : other.body_a;
        if (own == contact.shape_a) {
            if (body == contact.body_b || (!gives_way(b) && !gives_way(stores.bodies.cold[body])))
                found.of_b.push_back(shape);
        } else if (shape == contact.shape_b) {
            found.of_a.push_back(own);
        }
    });
    return found;
}

}  // namespace

SeamShapes find_seam_neighbours(const ContactGraph& stores, const Contact& contact) {
    const BodyCold &a = stores.bodies.cold[contact.body_a], &b = stores.bodies.cold[contact.body_b];
    SeamShapes found;
    ASSERT(contact.parent == none);
    if (!gives_way(b)) {
        if (a.fixed_pairs > 1) return neighbours_in_contact_list(stores, contact);
        return found;
    }
    if (!has_several_shapes(a) && !has_several_shapes(b)) return found;
    // Pairs with modifiers do not count, and only the contact list shows them.
    if (!stores.contacts.modifiers.empty()) return neighbours_in_contact_list(stores, contact);
    for_each_sibling(stores, contact.shape_b, contact.shape_a,
                     [&](std::uint32_t shape) { found.of_b.push_back(shape); });
    for_each_sibling(stores, contact.shape_a, contact.shape_b,
                     [&](std::uint32_t shape) { found.of_a.push_back(shape); });
    return found;
}

}  // namespace jostle::physics
