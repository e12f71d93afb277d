// SPDX-License-Identifier: MIT
#include "physics/src/state/impulse_scale.h"

#include <algorithm>

#include "jostle/base/check.h"

namespace jostle::physics {

namespace {

// Stiffness is proportional to the inverse square of the sub-step length, so the impulse of a
// contact beyond its mean impulse would change abruptly. The mean impulse is adjusted so that the
// load stays constant. `even`: the points of a manifold share it.
void stiffen(const ContactLaneRef& lane_ref, float stiffer, bool even) {
    ContactConstraintWide& block = *lane_ref.block;
    const int lane = lane_ref.lane;
    float lambda_sum = 0, mean_impulse_sum = 0, points = 0;
    ASSERT(stiffer > 0);
    for (int k = 0; k < 4; k++) {
        // The first point always exists.
        if (k > 0 && block.gap[k][lane] > 0.5f * no_point) continue;
        lambda_sum += block.lambda[k][lane];
        mean_impulse_sum += block.mean_impulse[k][lane];
        points++;
    }
    for (int k = 0; k < 4; k++) {
        float& mean_impulse = block.mean_impulse[k][lane];
        const float lambda = even ? lambda_sum / points : block.lambda[k][lane];
        mean_impulse =
            lambda - stiffer * (lambda - (even ? mean_impulse_sum / points : mean_impulse));
    }
}

void scale_impulses(Joint& joint, double scale) {
    for (Vec3* v : {&joint.point, &joint.angular, &joint.friction}) *v = *v * scale;
    for (double* x : {&joint.lower, &joint.upper, &joint.swing, &joint.spring, &joint.motor})
        *x *= scale;
}

}  // namespace

void scale_warm_start(const ContactLaneRef& lane_ref, float scale) {
    const auto row = [&](float* values) { values[lane_ref.lane] *= scale; };
    for (auto& lambda : lane_ref.block->lambda) row(lambda);
    for (auto& friction : lane_ref.block->friction) row(friction);
    row(lane_ref.block->torsion);
    for (auto& mean_impulse : lane_ref.block->mean_impulse) row(mean_impulse);
    for (auto& roll : lane_ref.rolling->roll) row(roll);
}

void scale_impulses(const ContactLaneRef& lane_ref, float scale, bool even) {
    scale_warm_start(lane_ref, scale);
    stiffen(lane_ref, 1 / (scale * scale), even);
}

void clear_negative_mean_impulse(const ContactLaneRef& lane_ref) {
    for (auto& mean_impulse : lane_ref.block->mean_impulse)
        mean_impulse[lane_ref.lane] = std::max(mean_impulse[lane_ref.lane], 0.0f);
}

void scale_joints(const BodyStore& bodies, JointStore& joints, std::uint32_t body, double scale) {
    ASSERT(scale > 0);
    for_each_joint(joints, bodies.cold[body], [&](std::uint32_t index) {
        Joint& j = joints.joints[index];
        // Each joint once: at its first dynamic body.
        const bool first = is_dynamic(bodies, j.body_a);
        if ((first ? j.body_a : j.body_b) == body) scale_impulses(j, scale);
    });
}

StepLengthChange step_length_change(const SteppingState& stepping, double dt) {
    ASSERT(stepping.last_dt > 0 && dt > 0);
    const double scale = dt / stepping.last_dt,
                 longest = stiffness_dt_of(stepping, stepping.last_dt),
                 softer = minimum(1, longest / dt);
    return {as_float(scale), as_float(minimum(scale, 1 / softer)), as_float(softer * softer)};
}

StepLengthChange resting_step_length_change(double from, double to, double stiffness_dt) {
    ASSERT(from > 0 && to > 0 && stiffness_dt > 0);
    const double softer = from / stiffness_dt;
    return {as_float(to / from), as_float(to / from), as_float(softer * softer)};
}

void change_step_length(const ContactLaneRef& lane_ref, const StepLengthChange& change) {
    ContactConstraintWide& block = *lane_ref.block;
    const int lane = lane_ref.lane;
    ASSERT(change.scale > 0 && change.retained <= change.scale);
    for (int k = 0; k < 4; k++) {
        float &lambda = block.lambda[k][lane], &mean_impulse = block.mean_impulse[k][lane];
        const float mean = change.scale * mean_impulse,
                    deviation = change.retained * (lambda - mean_impulse);
        lambda = std::max(mean + deviation, 0.0f);
        mean_impulse = lambda - change.stiffness * deviation;
        // Softer contacts need not carry less than the mean.
        if (change.stiffness <= 1) mean_impulse = std::max(mean_impulse, mean);
    }
    for (auto& friction : block.friction) friction[lane] *= change.retained;
    block.torsion[lane] *= change.retained;
    for (auto& roll : lane_ref.rolling->roll) roll[lane] *= change.retained;
}

void change_step_length(ContactGraph& stores, JointStore& joints, const StepLengthChange& change) {
    for (std::uint32_t i = 0; i < stores.contacts.contacts.size(); i++) {
        const Contact& c = stores.contacts.contacts[i];
        if (stores.contacts.ids.alive(i) && c.colour >= 0)
            change_step_length(lane_ref_of(stores.graph, c), change);
    }
    for (const BodyWarm& warm : stores.bodies.awake) {
        const BodyCold& cold = stores.bodies.cold[warm.body];
        if (cold.type == BodyType::dynamic && cold.first_joint != none)
            scale_joints(stores.bodies, joints, warm.body, double{change.scale});
    }
}

void scale_awake(ContactGraph& stores, JointStore& joints,
                 const std::array<double, solved_set_count>& scale) {
    const auto scale_at = [&](std::uint32_t body) {
        const std::uint32_t island = stores.bodies.cold[body].island;
        ASSERT(stores.islands.ids.alive(island));
        return scale[index_of(stores.islands.islands[island].colour_set)];
    };
    for (std::uint32_t i = 0; i < stores.contacts.contacts.size(); i++) {
        const Contact& c = stores.contacts.contacts[i];
        if (stores.contacts.ids.alive(i) && c.colour >= 0)
            scale_impulses(lane_ref_of(stores.graph, c), static_cast<float>(scale_at(c.body_a)),
                           false);
    }
    for (const BodyWarm& warm : stores.bodies.awake) {
        const BodyCold& cold = stores.bodies.cold[warm.body];
        if (cold.type == BodyType::dynamic && cold.first_joint != none)
            scale_joints(stores.bodies, joints, warm.body, scale_at(warm.body));
    }
}

}  // namespace jostle::physics
