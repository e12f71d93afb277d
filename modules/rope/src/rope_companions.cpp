// SPDX-License-Identifier: MIT
#include "modules/rope/src/rope_companions.h"

#include <cstdint>
#include <vector>

#include "jostle/modules/companions.h"
#include "jostle/physics/scalar.h"
#include "modules/rope/src/rope_contacts.h"
#include "modules/rope/src/rope_step.h"

namespace jostle::modules::rope_detail {

using namespace physics;

void find_companions(std::span<const std::unique_ptr<Rope>> ropes, double dt, Vec3 gravity) {
    if (ropes.size() < 2) return;
    std::vector<Rope*> touching;
    std::vector<Reach> reaches;
    for (const auto& rope : ropes) {
        if (!rope->def.collide_ropes) continue;
        const double reach = reach_of(*rope, dt, rope->awake ? gravity : Vec3{});
        touching.push_back(rope.get());
        reaches.push_back({rope->awake, bounds_of(*rope, reach)});
    }
    const auto moves_into = [&](std::uint32_t moving, std::uint32_t resting) {
        const Strand& strand = touching[moving]->strand;
        constexpr double rest_speed = CarriedBodies::rest_speed;
        const Vec3 more{touching[moving]->def.radius, touching[moving]->def.radius,
                        touching[moving]->def.radius};
        for (std::size_t k = 0; k < strand.links(); k++) {
            const Vec3 a = strand.positions[k], b = strand.positions[k + 1];
            if (length_squared(strand.velocities[k]) < rest_speed * rest_speed &&
                length_squared(strand.velocities[k + 1]) < rest_speed * rest_speed)
                continue;
            if (overlap({min(a, b) - more, max(a, b) + more}, reaches[resting].box)) return true;
        }
        return false;
    };
    Companions companions;
    companions.find(reaches, moves_into);
    companions.assign(std::span<Rope* const>(touching), wake);
}

void forget_companion(std::span<const std::unique_ptr<Rope>> ropes, const Rope& removed) {
    for (const auto& rope : ropes) {
        if (rope->leader == &removed) rope->leader = nullptr;
        std::erase(rope->companions, &removed);
        std::erase(rope->obstacles, &removed);
        std::erase_if(rope->link_contacts, [&](const LinkContact& contact) {
            return contact.other == removed.key.number;
        });
        if (rope->rope_contacts != nullptr) rope->rope_contacts->forget();
    }
}

}  // namespace jostle::modules::rope_detail
