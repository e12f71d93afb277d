// SPDX-License-Identifier: MIT
#include "jostle/modules/deformables.h"
#include "jostle/physics/module.h"

namespace jostle::modules {

using namespace physics;

Vec3 PressurePulse::change_of(Vec3 point, double area, double mass) const {
    const Vec3 change = impulse_per_area(point) * (area / mass);
    const double speed = length(change);
    return speed > max_speed ? change * (max_speed / speed) : change;
}

Deformables* deformables_of(World& world, std::string_view tag) {
    return dynamic_cast<Deformables*>(world.module(tag));
}

const Deformables* deformables_of(const World& world, std::string_view tag) {
    return dynamic_cast<const Deformables*>(world.module(tag));
}

std::optional<ModuleHit> cast_ray_at_deformables(const World& world, const Ray& ray) {
    std::optional<ModuleHit> first;
    for (const std::string& tag : world.modules()) {
        const Deformables* deformables = deformables_of(world, tag);
        if (deformables == nullptr) continue;
        const std::optional<DeformableHit> hit = deformables->cast_ray(ray);
        if (hit && (!first || hit->fraction < first->fraction))
            first = ModuleHit{tag, hit->at, hit->fraction, hit->position};
    }
    return first;
}

void apply_pulse(World& world, const PressurePulse& pulse) {
    for (const std::string& tag : world.modules())
        if (auto* receiver = dynamic_cast<PulseReceiver*>(world.module(tag)))
            receiver->apply_pulse(world, pulse);
}

}  // namespace jostle::modules
