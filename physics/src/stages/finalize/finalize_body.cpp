// SPDX-License-Identifier: MIT
#include "physics/src/stages/finalize/finalize_body.h"

#include "jostle/base/check.h"
#include "physics/src/foundation/size_scale.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/step_scratch.h"
#include "physics/src/state/force_fields.h"
#include "physics/src/state/shape_proxy.h"

namespace jostle::physics {
namespace {

bool is_sound(const FreeMotion& motion, Vec3 center) {
    const double fastest = maximum(length_squared(motion.v), length_squared(motion.w));
    const Vec3 reach = abs(center);
    // Written so that NaN fails.
    return fastest < tuning::quarantine_speed * tuning::quarantine_speed &&
           maximum(reach.x, maximum(reach.y, reach.z)) < tuning::quarantine_coordinate &&
           is_finite(center) && is_finite(motion.rotation);
}

bool left_fat_aabb(const ShapeStore& store, MotionBound& motion, const BodyWarm& warm,
                   const BodyCold& cold, double dt) {
    if (motion.travel + length(warm.v) * dt <= motion.fits_until) return false;
    AabbMargin margin{1e300, 1e300};
    for (std::uint32_t s = cold.first_shape; s != none; s = store.shapes[s].next) {
        const AabbMargin own = margin_in_fat_aabb(store.shapes[s], warm, cold.radius, dt);
        margin = {minimum(margin.now, own.now), minimum(margin.next, own.next)};
    }
    motion.fits_until = motion.travel + margin.now;
    return margin.next < 0;
}

// Returns whether a shape of a moved body is no longer within its fat box.
bool left_predicted_aabb(const ShapeStore& store, const BodyWarm& warm, const BodyCold& cold) {
    for (std::uint32_t s = cold.first_shape; s != none; s = store.shapes[s].next)
        if (!fits_fat_aabb(store.shapes[s], warm, cold.radius, 0)) return true;
    return false;
}

// The distance by which a rotation moves the surface around the centre, m: that of a ball with the
// same energy. The furthest point of a rolling capsule is far from its rotation axis.
double swing(const BodyWarm& warm, const BodyCold& cold, Vec3 turn) {
    constexpr double inertia_of_ball = 0.4;  // m r^2
    if (cold.mass == 0) return 0;            // no shape has mass
    const Vec3 own = transposed_times(warm.axes, turn);
    return square_root(maximum(dot(own, cold.inertia * own), 0) / (inertia_of_ball * cold.mass));
}

// Updates the rest time of a body.
void note_rest(const WorldState& world, BodyWarm& warm, const BodyCold& cold,
               const FreeMotion& motion, Quat turn, double dt) {
    if (warm.sleep_time == 0) warm.drift = warm.drift_turn = {};
    const Vec3 turned = Vec3{turn.x, turn.y, turn.z} * (turn.w < 0 ? -2.0 : 2.0);
    warm.drift += motion.displacement;
    warm.drift_turn += turned;
    const double slow = speed_scale(cold.radius, gravity_ratio_squared(world.def.gravity));
    const double moved = length(motion.displacement);
    if (moved >= maximum(tuning::sleep_speed, tuning::drift_speed) * slow * dt) {
        warm.sleep_time = 0;
        return;
    }
    const double now = swing(warm, cold, turned), next = swing(warm, cold, motion.w * dt);
    const double displacement = maximum(moved, maximum(now, next));
    const double length_scale = size_scale(cold.radius);
    const bool still = displacement < tuning::sleep_speed * slow * dt;
    const bool sways =
        displacement < tuning::drift_speed * slow * dt &&
        length(warm.drift) + swing(warm, cold, warm.drift_turn) < tuning::drift * length_scale;
    const bool rests =
        cold.sleep_allowed && (still || sways) &&
        (world.fields.empty() || !is_affected_by_gusts(world.fields, world.shapes, warm, cold));
    // Large bodies fall slowly and must rest for longer.
    warm.sleep_time = rests ? warm.sleep_time + dt * minimum(1, slow / length_scale) : 0;
}

// Returns whether a body's velocity does not lead back to its previous pose, by more than half of
// the displacement that needs no sweep.
bool was_deflected(const FreeMotion& motion, Quat turn, const BodyCold& cold, double dt) {
    const Vec3 turned = Vec3{turn.x, turn.y, turn.z} * (turn.w < 0 ? -2 : 2);
    const double missed =
        length(motion.v * dt - motion.displacement) + length(motion.w * dt - turned) * cold.radius;
    return missed > 0.5 * tuning::sweep_fraction * cold.inner_radius;
}

// Bodies that move less within the step cannot pass through a trigger: passes_through() may miss
// smaller overlaps.
constexpr double least_path = 2e-5;  // m

}  // namespace

void begin_finalize(const BodyStore& bodies, const std::vector<std::uint32_t>& bouncing,
                    bool records_paths, FinalizeScratch& scratch) {
    scratch.path_starts.resize(records_paths ? bodies.cold.size() : 0);
    scratch.on_path.assign(records_paths ? bodies.awake.size() : 0, 0);
    scratch.left_fat_aabb.assign(bodies.awake.size(), 0);
    scratch.not_finite.assign(bodies.awake.size(), 0);
    scratch.fast.assign(bodies.awake.size(), 0);
    scratch.deflected.assign(bodies.awake.size(), 0);
    scratch.left_predicted_aabb.assign(bodies.awake.size(), 0);
    scratch.bouncing.assign(bodies.awake.size(), 0);
    for (const std::uint32_t body : bouncing) {
        const BodyCold& cold = bodies.cold[body];
        ASSERT(cold.set == BodySet::awake && cold.at < bodies.awake.size());
        scratch.bouncing[cold.at] = 1;
    }
    scratch.any_fast = 0;
    if (scratch.previous.size() < bodies.awake.size()) scratch.previous.resize(bodies.awake.size());
}

void finalize_body(StepContext& step, std::uint32_t awake_index, const FreeMotion& motion) {
    WorldState& world = step.world;
    FinalizeScratch& scratch = step.scratch.finalize;
    ASSERT(awake_index < scratch.fast.size() && awake_index < world.bodies.awake.size());
    BodyWarm& warm = world.bodies.awake[awake_index];
    const BodyCold& cold = world.bodies.cold[warm.body];
    ASSERT(cold.set == BodySet::awake && cold.at == awake_index && !cold.asleep_in_place);
    // Each body is finalized once per step.
    ASSERT(scratch.fast[awake_index] == 0 && scratch.deflected[awake_index] == 0);
    ASSERT(scratch.left_fat_aabb[awake_index] == 0 && scratch.not_finite[awake_index] == 0);
    warm.force = warm.torque = {};
    const Vec3 center = warm.center + motion.displacement;
    if (!is_sound(motion, center)) {
        warm.v = warm.w = {};
        warm.sleep_time = 0;
        scratch.not_finite[awake_index] = 1;
        return;
    }
    if (cold.type == BodyType::kinematic && motion.v == Vec3{} && motion.w == Vec3{}) return;

    // The rotation of this step from the two orientations. |vec(q1 q0*)| is the sine of half the
    // angle; 2.2 times it bounds angles up to 85 degrees.
    const Quat turn = motion.rotation * conjugate(warm.rotation);
    const double angle = 2.2 * square_root(turn.x * turn.x + turn.y * turn.y + turn.z * turn.z);
    const double turned = maximum(angle, length(motion.w) * step.dt) * cold.radius;
    const double displacement = length(motion.displacement) + turned;
    const bool bounces = scratch.bouncing[awake_index] != 0;
    const bool far = displacement > tuning::sweep_fraction * cold.inner_radius;
    if (!scratch.on_path.empty() && displacement > least_path) {
        scratch.on_path[awake_index] = 1;
        scratch.path_starts[warm.body] = {warm.center, warm.rotation, true, far};
    }
    if (cold.continuous && (bounces || far)) {
        scratch.previous[awake_index] = warm;
        scratch.fast[awake_index] = 1;
        scratch.any_fast = 1;
    } else if (bounces || was_deflected(motion, turn, cold, step.dt)) {
        scratch.previous[awake_index] = warm;
        scratch.deflected[awake_index] = 1;
    }
    warm.center = center;
    warm.rotation = motion.rotation;
    warm.axes = to_matrix(warm.rotation);
    warm.v = motion.v;
    warm.w = motion.w;
    if (scratch.fast[awake_index] != 0)
        scratch.left_predicted_aabb[awake_index] =
            left_predicted_aabb(world.shapes, warm, cold) ? 1 : 0;
    MotionBound& bound = world.bodies.motion[warm.body];
    bound.travel += displacement;
    bound.turned += turned;
    update_motion_bound(world, warm.body, step.dt);
    if (world.def.sleeping && cold.type == BodyType::dynamic)
        note_rest(world, warm, cold, motion, turn, step.dt);
    if (!left_fat_aabb(world.shapes, bound, warm, cold, step.dt)) return;
    scratch.left_fat_aabb[awake_index] = 1;
    if (!scratch.on_path.empty() && scratch.on_path[awake_index] != 0)
        scratch.path_starts[warm.body].far = true;
    for (std::uint32_t s = cold.first_shape; s != none; s = world.shapes.shapes[s].next)
        enlarge_aabb(world.bodies, world.shapes, s, warm, step.dt);
}

}  // namespace jostle::physics
