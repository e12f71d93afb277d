// SPDX-License-Identifier: MIT
#include "constraints/joints/kinds.h"

namespace jostle::physics {

void warm_start_ball(JointPair& pair, const BallJoint&, Joint& joint) {
    pair.push(joint.point);
}

void solve_ball(JointPair& pair, const JointStep& step, const BallJoint&, Joint& joint) {
    hold_points(pair, step, step.rigid, joint.point);
}

JointLoad load_of_ball(const JointPair&, const BallJoint&, const Joint& joint) {
    return {joint.point, {}};
}

}  // namespace jostle::physics
