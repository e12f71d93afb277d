// SPDX-License-Identifier: MIT
#include "physics/src/stages/contacts/find_seam_neighbours.h"

#include "jostle/base/check.h"

namespace jostle::physics {
namespace {

bool has_several_shapes(const BodyCold& body) {
    return body.first_shape != body.last_shape;
}

bool gives_way(const BodyCold& body) {
    return body.type == BodyType::dynamic;
}

}  // namespace

SeamShapes find_seam_neighbours(const ContactGraph& stores, const Contact& contact) {
    const BodyCold &a = stores.bodies.cold[contact.body_a], &b = stores.bodies.cold[contact.body_b];
    SeamShapes found;
    ASSERT(contact.parent == none);
    if (gives_way(b) && !has_several_shapes(a) && !has_several_shapes(b)) return found;
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

}  // namespace jostle::physics
