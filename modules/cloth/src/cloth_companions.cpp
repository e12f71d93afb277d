// SPDX-License-Identifier: MIT
#include "modules/cloth/src/cloth_companions.h"

#include <cstdint>
#include <vector>

#include "jostle/modules/companions.h"
#include "jostle/physics/scalar.h"
#include "modules/cloth/src/cloth_contacts.h"
#include "modules/cloth/src/cloth_step.h"

namespace jostle::modules::cloth_detail {

using namespace physics;

void find_companions(std::span<const std::unique_ptr<Cloth>> cloths, double dt, Vec3 gravity) {
    if (cloths.size() < 2) return;
    std::vector<Cloth*> touching;
    std::vector<Reach> reaches;
    std::vector<double> margins;  // m
    for (const auto& cloth : cloths) {
        if (!cloth->def.collide_cloths) continue;
        const double speed = cloth->awake ? greatest_speed(cloth->sheet) : 0;
        const double fall = cloth->awake ? dt * length(gravity) : 0;
        touching.push_back(cloth.get());
        margins.push_back(cloth->def.thickness + dt * (speed + fall));
        reaches.push_back({cloth->awake, bounds_of(cloth->sheet, margins.back())});
    }
    const auto moves_into = [&](std::uint32_t moving, std::uint32_t resting) {
        const Sheet& sheet = touching[moving]->sheet;
        const Vec3 more{margins[moving], margins[moving], margins[moving]};
        const Aabb box{reaches[resting].box.low - more, reaches[resting].box.high + more};
        constexpr double rest_speed = CarriedBodies::rest_speed;
        for (std::size_t k = 0; k < sheet.size(); k++)
            if (contains(box, {sheet.position(k), sheet.position(k)}) &&
                length_squared(sheet.velocity(k)) >= rest_speed * rest_speed)
                return true;
        return false;
    };
    Companions companions;
    companions.find(reaches, moves_into);
    companions.assign(std::span<Cloth* const>(touching), wake);
}

void forget_companion(std::span<const std::unique_ptr<Cloth>> cloths, const Cloth& removed) {
    for (const auto& cloth : cloths) {
        if (cloth->leader == &removed) cloth->leader = nullptr;
        std::erase(cloth->companions, &removed);
        std::erase(cloth->obstacles, &removed);
    }
}

}  // namespace jostle::modules::cloth_detail
