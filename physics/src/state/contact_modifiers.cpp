// SPDX-License-Identifier: MIT
#include "physics/src/state/contact_modifiers.h"

#include <algorithm>

#include "physics/src/foundation/check.h"
#include "physics/src/state/combine.h"

namespace jostle::physics {
namespace {

std::vector<ContactModifier>::const_iterator place_of_answer(const WorldState& world,
                                                           std::uint32_t contact) {
    return std::lower_bound(
        world.contacts.answers.begin(), world.contacts.answers.end(), contact,
        [](const ContactModifier& a, std::uint32_t index) { return a.contact < index; });
}

}  // namespace

ContactModifier answer_of_materials(const WorldState& world, std::uint32_t shape_a,
                                  std::uint32_t shape_b) {
    const ShapeRecord &a = world.shapes.shapes[shape_a], &b = world.shapes.shapes[shape_b];
    ContactModifier answer{.friction = pair_friction(a.material, b.material),
                         .restitution = pair_restitution(a.material, b.material),
                         .surface_velocity = {}};
    if (a.material.surface_velocity != Vec3{} || b.material.surface_velocity != Vec3{})
        answer.surface_velocity = warm_of(world, b.body).axes * b.material.surface_velocity -
                                  warm_of(world, a.body).axes * a.material.surface_velocity;
    return answer;
}

ContactModifier answer_of(const WorldState& world, const Contact& contact) {
    if (!contact.answered) return answer_of_materials(world, contact.shape_a, contact.shape_b);
    const auto index = static_cast<std::uint32_t>(&contact - world.contacts.contacts.data());
    const auto place = place_of_answer(world, index);
    ASSERT(place != world.contacts.answers.end() && place->contact == index);
    return *place;
}

void keep_answer(WorldState& world, const ContactModifier& answer) {
    ASSERT(!world.contacts.contacts[answer.contact].answered);
    world.contacts.answers.insert(place_of_answer(world, answer.contact), answer);
    world.contacts.contacts[answer.contact].answered = true;
}

void forget_answer(WorldState& world, std::uint32_t contact) {
    if (!world.contacts.contacts[contact].answered) return;
    world.contacts.answers.erase(place_of_answer(world, contact));
    world.contacts.contacts[contact].answered = false;
}

bool pass_through(const WorldState& world, const Contact& pair) {
    if (!pair.composite) return pair.answered && !answer_of(world, pair).enabled;
    for (std::uint32_t p = pair.first_part; p != none; p = world.contacts.contacts[p].next_part)
        if (!pass_through(world, world.contacts.contacts[p])) return false;
    return pair.first_part != none;
}

}  // namespace jostle::physics
