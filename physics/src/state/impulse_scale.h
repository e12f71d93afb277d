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

// Scales all impulses of the awake set for steps that are `scale` times as long. Sleeping islands
// follow when they wake.
void scale_awake(ContactGraph& stores, JointStore& joints, double scale);
// Same with a factor per colour set, indexed by index_of().
void scale_awake(ContactGraph& stores, JointStore& joints,
                 const std::array<double, solved_set_count>& scale);

}  // namespace jostle::physics
