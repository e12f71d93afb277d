// SPDX-License-Identifier: MIT
#include "physics/src/stages/continuous/toi_motion.h"

#include "jostle/base/check.h"
#include "physics/src/foundation/tuning.h"

namespace jostle::physics {
namespace {

// Velocity change over the step of a body that is not a TOI body, m/s. Bending is ignored unless
// bodies bounce.
Vec3 gain_of(const ToiState& state, const BodyCold& cold) {
    return state.any_bounces && !is_supported(state.world, cold)
               ? gain_in_free_fall(state.world, cold, state.step.dt)
               : Vec3{};
}

Sweep sweep_of_step(const ToiState& state, std::uint32_t body) {
    const BodyCold& cold = state.world.bodies.cold[body];
    const BodyWarm& warm = warm_of(state.world, body);
    if (cold.set != BodySet::awake || (warm.v == Vec3{} && warm.w == Vec3{}))
        return {0, warm.center, warm.rotation, {}, {}};
    if (state.motions.knows(cold.at)) return state.motions.sweep_of(cold.at);
    const double dt = state.step.dt;
    const Vec3 translation = (warm.v - gain_of(state, cold) * 0.5) * dt, turn = warm.w * dt;
    return {0, warm.center - translation, normalized(from_rotation_vector(-turn) * warm.rotation),
            translation, turn};
}

}  // namespace

Speed speed_of(const ToiState& state, std::uint32_t body, double fraction) {
    ASSERT(fraction >= 0 && fraction <= 1);
    const std::uint32_t known = state.index_of(body);
    if (known != none) return speed_at(state.world, state.bodies[known], fraction, state.step.dt);
    const BodyWarm& warm = warm_of(state.world, body);
    return {warm.v - gain_of(state, state.world.bodies.cold[body]) * (1 - fraction), warm.w};
}

Sweep sweep_of(const ToiState& state, std::uint32_t body) {
    const std::uint32_t known = state.index_of(body);
    return known != none ? state.bodies[known].sweep : sweep_of_step(state, body);
}

BodyDisplacement remaining_motion_of(const ToiState& state, std::uint32_t body) {
    const std::uint32_t known = state.index_of(body);
    if (known == none) return state.motions.of(state.world, body);
    const Sweep& sweep = state.bodies[known].sweep;
    return {sweep.center, sweep.translation, sweep.rotation_vector,
            state.world.bodies.cold[body].radius};
}

Fall fall_of(const ToiState& state, std::uint32_t body) {
    const std::uint32_t known = state.index_of(body);
    if (known == none) return {gain_of(state, state.world.bodies.cold[body]), 0};
    return {state.bodies[known].gain, state.bodies[known].flies_from};
}

SweptShape swept_shape(const WorldState& world, std::uint32_t shape, const Sweep& sweep) {
    const ShapeRecord& s = world.shapes.shapes[shape];
    return {&s.geometry, s.offset, s.axes, world.bodies.cold[s.body].radius, sweep};
}

Aabb swept_aabb_of(const WorldState& world, const ToiBody& t) {
    const BodyCold& cold = world.bodies.cold[t.body];
    if (t.sweep.until < 1) {
        const Vec3 from = t.sweep.center, to = center_at(t.sweep, 1);
        return grow({min(from, to), max(from, to)}, cold.radius + tuning::swept_margin);
    }
    Aabb box{};
    bool first = true;
    for (std::uint32_t s = cold.first_shape; s != none; s = world.shapes.shapes[s].next) {
        if (world.shapes.shapes[s].trigger) continue;
        const Aabb own = swept_bounds(swept_shape(world, s, t.sweep), t.sweep.from, 1);
        box = first ? own : unite(box, own);
        first = false;
    }
    return grow(box, tuning::swept_margin);
}

}  // namespace jostle::physics
