// SPDX-License-Identifier: MIT
#include "physics/src/stages/solver/warm_start_cache.h"

#include "physics/src/constraint_graph/joint_memory.h"

namespace jostle::physics {
namespace {

bool has_axes(const JointKind& kind) {
    return std::visit(
        [](const auto& joint) {
            return requires {
                axes_of(joint);
            };
        },
        kind);
}

}  // namespace

WarmStartCache read_warm_start(const Joint& from, Quat carried) {
    WarmStartCache cache{.point = rotate(carried, from.point)};
    if (has_axes(from.kind)) {
        cache.turns = from.angular;
        const std::size_t count = from.memory.size() / AxisImpulses::count;
        for (std::size_t k = 0; k < count; k++) {
            const double* const at = &from.memory[k * AxisImpulses::count];
            cache.ways[k] = {at[AxisImpulses::lower], at[AxisImpulses::upper],
                            at[AxisImpulses::spring_impulse], at[AxisImpulses::motor],
                            at[AxisImpulses::friction]};
        }
        return cache;
    }
    cache.angular = rotate(carried, from.angular);
    cache.ways[0] = {from.lower, from.upper, from.spring, from.motor, 0};
    cache.ways[1].upper = from.swing;
    return cache;
}

void write_warm_start(Joint& to, Quat carried, const WarmStartCache& cache) {
    to.point = inverse_rotate(carried, cache.point);
    if (has_axes(to.kind)) {
        to.angular = cache.turns;
        const std::size_t count = to.memory.size() / AxisImpulses::count;
        for (std::size_t k = 0; k < count; k++) {
            const WarmStartCache::FreeAxisImpulses& way = cache.ways[k];
            double* const at = &to.memory[k * AxisImpulses::count];
            at[AxisImpulses::lower] = way.lower;
            at[AxisImpulses::upper] = way.upper;
            at[AxisImpulses::spring_impulse] = way.spring;
            at[AxisImpulses::motor] = way.motor;
            at[AxisImpulses::friction] = way.friction;
        }
        return;
    }
    to.angular = inverse_rotate(carried, cache.angular);
    to.lower = cache.ways[0].lower;
    to.upper = cache.ways[0].upper;
    to.spring = cache.ways[0].spring;
    to.motor = cache.ways[0].motor;
    to.swing = cache.ways[1].upper;
    to.friction = {};
}

}  // namespace jostle::physics
