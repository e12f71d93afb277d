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

WarmStartCache read_kept(const Joint& from, Quat carried) {
    WarmStartCache kept{.point = rotate(carried, from.point)};
    if (has_axes(from.kind)) {
        kept.turns = from.angular;
        const std::size_t count = from.memory.size() / AxisImpulses::count;
        for (std::size_t k = 0; k < count; k++) {
            const double* const at = &from.memory[k * AxisImpulses::count];
            kept.ways[k] = {at[AxisImpulses::lower], at[AxisImpulses::upper],
                            at[AxisImpulses::spring_impulse], at[AxisImpulses::motor],
                            at[AxisImpulses::friction]};
        }
        return kept;
    }
    kept.angular = rotate(carried, from.angular);
    kept.ways[0] = {from.lower, from.upper, from.spring, from.motor, 0};
    kept.ways[1].upper = from.swing;
    return kept;
}

void write_kept(Joint& to, Quat carried, const WarmStartCache& kept) {
    to.point = inverse_rotate(carried, kept.point);
    if (has_axes(to.kind)) {
        to.angular = kept.turns;
        const std::size_t count = to.memory.size() / AxisImpulses::count;
        for (std::size_t k = 0; k < count; k++) {
            const WarmStartCache::Way& way = kept.ways[k];
            double* const at = &to.memory[k * AxisImpulses::count];
            at[AxisImpulses::lower] = way.lower;
            at[AxisImpulses::upper] = way.upper;
            at[AxisImpulses::spring_impulse] = way.spring;
            at[AxisImpulses::motor] = way.motor;
            at[AxisImpulses::friction] = way.friction;
        }
        return;
    }
    to.angular = inverse_rotate(carried, kept.angular);
    to.lower = kept.ways[0].lower;
    to.upper = kept.ways[0].upper;
    to.spring = kept.ways[0].spring;
    to.motor = kept.ways[0].motor;
    to.swing = kept.ways[1].upper;
    to.friction = {};
}

}  // namespace jostle::physics
