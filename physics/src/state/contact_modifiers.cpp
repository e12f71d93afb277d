// SPDX-License-Identifier: MIT
#include "physics/src/state/contact_modifiers.h"

#include <algorithm>

#include "jostle/base/check.h"
#include "physics/src/state/pair_properties.h"

namespace jostle::physics {
namespace {

std::vector<ContactModifier>::const_iterator find_modifier(const ContactStore& contacts,
                                                           std::uint32_t contact) {
    return std::lower_bound(
        contacts.modifiers.begin(), contacts.modifiers.end(), contact,
        [](const ContactModifier& a, std::uint32_t index) { return a.contact < index; });
}

// Returns the modifier that a listener set.
const ContactModifier& listener_modifier(const ContactStore& contacts, const Contact& contact) {
    const auto index = static_cast<std::uint32_t>(&contact - contacts.contacts.data());
    const auto found = find_modifier(contacts, index);
    ASSERT(found != contacts.modifiers.end() && found->contact == index);
    return *found;
}

}  // namespace

ContactModifier material_modifier(const ShapedBodies& stores, std::uint32_t shape_a,
                                  std::uint32_t shape_b) {
    const ShapeRecord &a = stores.shapes.shapes[shape_a], &b = stores.shapes.shapes[shape_b];
    ContactModifier modifier{.friction = pair_friction(a.material, b.material),
                             .restitution = pair_restitution(a.material, b.material),
                             .surface_velocity = {}};
    if (a.material.surface_velocity != Vec3{} || b.material.surface_velocity != Vec3{})
        modifier.surface_velocity = warm_of(stores, b.body).axes * b.material.surface_velocity -
                                    warm_of(stores, a.body).axes * a.material.surface_velocity;
    return modifier;
}

ContactModifier modifier_of(const ContactGraph& stores, const Contact& contact) {
    if (!contact.has_modifier) return material_modifier(stores, contact.shape_a, contact.shape_b);
    return listener_modifier(stores.contacts, contact);
}

void set_modifier(ContactStore& contacts, const ContactModifier& modifier) {
    ASSERT(contacts.ids.alive(modifier.contact));
    ASSERT(modifier.friction >= 0 && modifier.restitution >= 0);
    ASSERT(!contacts.contacts[modifier.contact].has_modifier);
    contacts.modifiers.insert(find_modifier(contacts, modifier.contact), modifier);
    contacts.contacts[modifier.contact].has_modifier = true;
}

void clear_modifier(ContactStore& contacts, std::uint32_t contact) {
    if (!contacts.contacts[contact].has_modifier) return;
    ASSERT(find_modifier(contacts, contact)->contact == contact);
    contacts.modifiers.erase(find_modifier(contacts, contact));
    contacts.contacts[contact].has_modifier = false;
}

bool pass_through(const ContactStore& contacts, const Contact& pair) {
    ASSERT(pair.composite || pair.first_child == none);
    if (!pair.composite) return pair.has_modifier && !listener_modifier(contacts, pair).enabled;
    for (std::uint32_t p = pair.first_child; p != none; p = contacts.contacts[p].next_child)
        if (!pass_through(contacts, contacts.contacts[p])) return false;
    return pair.first_child != none;
}

}  // namespace jostle::physics
