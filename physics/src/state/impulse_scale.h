// SPDX-License-Identifier: MIT
//
// Scaling of warm-start impulses. They apply to a sub-step of the same length; when an island
// changes its tier or the caller changes the step length, they are scaled accordingly.
#pragma once

#include <array>

#include "physics/src/state/contact_constraints.h"

namespace jostle::physics {

// Scales all warm-start impulses of a manifold.
void scale_warm_start(const ContactLaneRef& lane_ref, float scale);
// Scales the impulses of a manifold for sub-steps that are `scale` times as long. `even`: the
// points of the manifold share its load.
void scale_impulses(const ContactLaneRef& lane_ref, float scale, bool even);
// Removes negative mean impulses. A contact that became stiffer before its mean impulse converged
// compensates with a negative one, and would have the friction of a larger load until then.
void clear_negative_mean_impulse(const ContactLaneRef& lane_ref);
// Scales the impulses of the joints of a body, each joint at its first dynamic body.
void scale_joints(const BodyStore& bodies, JointStore& joints, std::uint32_t body, double scale);

// A change of the step length by the factor `scale`. Only the mean impulse is certainly a force
// times the length of a sub-step. The deviation from it and friction also contain impulses that
// stopped a motion in the last sub-step, and if scaled up, they would start such a motion in a
// longer one.
struct StepLengthChange {
    float scale = 1;
    float retained = 1;   // factor of deviations and friction, at most `scale`
    float stiffness = 1;  // factor of the contact stiffness: the load stays as it is
};
// The next step takes dt and follows others of stepping.last_dt. Deviations are scaled up only
// beyond the longest of the recent steps (SteppingState::stiffness_dt).
StepLengthChange step_length_change(const SteppingState& stepping, double dt);
// A resting island that last took steps of `from` goes on with steps of `to` at the stiffness of
// steps of `stiffness_dt`.
StepLengthChange resting_step_length_change(double from, double to, double stiffness_dt);

void change_step_length(const ContactLaneRef& lane_ref, const StepLengthChange& change);
// Same for the awake set. Sleeping islands follow when they wake.
void change_step_length(ContactGraph& stores, JointStore& joints, const StepLengthChange& change);

// Scales all impulses of the awake set for sub-steps that are `scale` times as long, by colour set,
// indexed by index_of().
void scale_awake(ContactGraph& stores, JointStore& joints,
                 const std::array<double, solved_set_count>& scale);

}  // namespace jostle::physics
