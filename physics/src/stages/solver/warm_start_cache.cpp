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
            cache.free_axes[k] = {at[AxisImpulses::lower], at[AxisImpulses::upper],
                                  at[AxisImpulses::spring_impulse], at[AxisImpulses::motor],
                                  at[AxisImpulses::friction]};
        }
        return cache;
    }
    cache.angular = rotate(carried, from.angular);
    cache.free_axes[0] = {from.lower, from.upper, from.spring, from.motor, 0};
    cache.free_axes[1].upper = from.swing;
    return cache;
}

void write_warm_start(Joint& to, Quat carried, const WarmStartCache& cache) {
    to.point = inverse_rotate(carried, cache.point);
    if (has_axes(to.kind)) {
        to.angular = cache.turns;
        const std::size_t count = to.memory.size() / AxisImpulses::count;
        for (std::size_t k = 0; k < count; k++) {
            const WarmStartCache::FreeAxisImpulses& free_axis = cache.free_axes[k];
            double* const at = &to.memory[k * AxisImpulses::count];
            at[AxisImpulses::lower] = free_axis.lower;
            at[AxisImpulses::upper] = free_axis.upper;
            at[AxisImpulses::spring_impulse] = free_axis.spring;
            at[AxisImpulses::motor] = free_axis.motor;
            at[AxisImpulses::friction] = free_axis.friction;
        }
        return;
    }
    to.angular = inverse_rotate(carried, cache.angular);
    to.lower = cache.free_axes[0].lower;
    to.upper = cache.free_axes[0].upper;
    to.spring = cache.free_axes[0].spring;
    to.motor = cache.free_axes[0].motor;
    to.swing = cache.free_axes[1].upper;
    to.friction = {};
}

}  // namespace jostle::physics
