// SPDX-License-Identifier: MIT
#include "physics/src/state/contact_modifiers.h"

#include <algorithm>

#include "jostle/base/check.h"
#include "physics/src/state/combine.h"

namespace jostle::physics {
namespace {

std::vector<ContactModifier>::const_iterator find_modifier(const WorldState& world,
                                                           std::uint32_t contact) {
    return std::lower_bound(
        world.contacts.modifiers.begin(), world.contacts.modifiers.end(), contact,
        [](const ContactModifier& a, std::uint32_t index) { return a.contact < index; });
}

}  // namespace

ContactModifier material_modifier(const WorldState& world, std::uint32_t shape_a,
                                  std::uint32_t shape_b) {
    const ShapeRecord &a = world.shapes.shapes[shape_a], &b = world.shapes.shapes[shape_b];
    ContactModifier modifier{.friction = pair_friction(a.material, b.material),
                             .restitution = pair_restitution(a.material, b.material),
                             .surface_velocity = {}};
    if (a.material.surface_velocity != Vec3{} || b.material.surface_velocity != Vec3{})
        modifier.surface_velocity = warm_of(world, b.body).axes * b.material.surface_velocity -
                                    warm_of(world, a.body).axes * a.material.surface_velocity;
    return modifier;
}

ContactModifier modifier_of(const WorldState& world, const Contact& contact) {
    if (!contact.has_modifier) return material_modifier(world, contact.shape_a, contact.shape_b);
    const auto index = static_cast<std::uint32_t>(&contact - world.contacts.contacts.data());
    const auto lane_ref = find_modifier(world, index);
    ASSERT(lane_ref != world.contacts.modifiers.end() && lane_ref->contact == index);
    return *lane_ref;
}

void set_modifier(WorldState& world, const ContactModifier& modifier) {
    ASSERT(world.contacts.ids.alive(modifier.contact));
    ASSERT(modifier.friction >= 0 && modifier.restitution >= 0);
    ASSERT(!world.contacts.contacts[modifier.contact].has_modifier);
    world.contacts.modifiers.insert(find_modifier(world, modifier.contact), modifier);
    world.contacts.contacts[modifier.contact].has_modifier = true;
}

void clear_modifier(WorldState& world, std::uint32_t contact) {
    if (!world.contacts.contacts[contact].has_modifier) return;
    ASSERT(find_modifier(world, contact)->contact == contact);
    world.contacts.modifiers.erase(find_modifier(world, contact));
    world.contacts.contacts[contact].has_modifier = false;
}

bool pass_through(const WorldState& world, const Contact& pair) {
    ASSERT(pair.composite || pair.first_child == none);
    if (!pair.composite) return pair.has_modifier && !modifier_of(world, pair).enabled;
    for (std::uint32_t p = pair.first_child; p != none; p = world.contacts.contacts[p].next_child)
        if (!pass_through(world, world.contacts.contacts[p])) return false;
    return pair.first_child != none;
}

}  // namespace jostle::physics
