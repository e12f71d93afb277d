// SPDX-License-Identifier: MIT
#include "physics/src/state/body_sets.h"

#include "jostle/base/check.h"
#include "physics/src/state/contact_constraints.h"

namespace jostle::physics {

void enter_static(WorldState& world, const BodyWarm& warm) {
    BodyCold& cold = world.bodies.cold[warm.body];
    ASSERT(cold.type == BodyType::static_body);
    ASSERT(cold.island == none && cold.constraints == 0);
    cold.set = BodySet::static_set;
    cold.at = static_cast<std::uint32_t>(world.bodies.statics.size());
    world.bodies.statics.push_back(warm);
}

void enter_awake(WorldState& world, const BodyWarm& warm) {
    BodyCold& cold = world.bodies.cold[warm.body];
    ASSERT(cold.type != BodyType::static_body);
    cold.set = BodySet::awake;
    cold.at = static_cast<std::uint32_t>(world.bodies.awake.size());
    world.bodies.awake.push_back(warm);
}

void leave_set(WorldState& world, std::uint32_t body) {
    const BodyCold& cold = world.bodies.cold[body];
    ASSERT(cold.set != BodySet::sleeping);
    auto& set = cold.set == BodySet::static_set ? world.bodies.statics : world.bodies.awake;
    const std::uint32_t hole = cold.at;
    ASSERT(hole < set.size() && set[hole].body == body);
    if (hole + 1 < set.size()) {
        set[hole] = set.back();
        BodyCold& moved = world.bodies.cold[set[hole].body];
        moved.at = hole;
        if (moved.set == BodySet::awake)
            for_each_contact(world.contacts, moved, [&](std::uint32_t contact) {
                const Contact& c = world.contacts.contacts[contact];
                if (c.colour >= 0) write_body_indices(world, c);
            });
    }
    set.pop_back();
    ASSERT(hole >= set.size() || world.bodies.cold[set[hole].body].at == hole);
}

}  // namespace jostle::physics
