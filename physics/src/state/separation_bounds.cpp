// SPDX-License-Identifier: MIT
#include "state/separation_bounds.h"

#include "foundation/check.h"
#include "foundation/tuning.h"
#include "state/contact_store.h"

namespace jostle::physics {

void set_separation_bound(SeparationBound& w, Vec3 apart, Vec3 direction, double slack,
                          const MotionBound& a, const MotionBound& b) {
    w.directed = direction != Vec3{};
    const Vec3 kept = w.directed ? direction : apart;
    for (int k = 0; k < 3; k++) w.apart[k] = static_cast<float>(kept[k]);
    w.budget = slack + a.turned + b.turned - (w.directed ? dot(direction_of(w), apart) : 0);
}

void add_separation_bound(WorldState& world, std::uint32_t contact, double slack, Vec3 direction) {
    Contact& c = world.contacts.contacts[contact];
    ASSERT(world.contacts.ids.alive(contact) && c.parent == none && c.colour < 0);
    c.dormant = false;
    if (c.has_bound) return;  // was dormant meanwhile: keeps its place and limit
    c.has_bound = true;
    const MotionBound &a = world.bodies.motion[c.body_a], &b = world.bodies.motion[c.body_b];
    SeparationBound w{.contact = contact, .body_a = c.body_a, .body_b = c.body_b};
    w.limit = a.travel + b.travel + slack;
    const Vec3 apart = warm_of(world, c.body_b).center - warm_of(world, c.body_a).center;
    if (slack >= 0 && length_squared(apart) <= 1e6)
        set_separation_bound(w, apart, direction, slack - tuning::slack_reserve, a, b);
    c.limit = w.limit;
    world.contacts.bounds.push_back(w);
}

void resume_separation_bound(WorldState& world, std::uint32_t contact) {
    Contact& c = world.contacts.contacts[contact];
    c.dormant = false;
    if (c.has_bound) return;
    c.has_bound = true;
    world.contacts.bounds.push_back(
        {.contact = contact, .body_a = c.body_a, .body_b = c.body_b, .limit = c.limit});
}

}  // namespace jostle::physics
