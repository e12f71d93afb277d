// SPDX-License-Identifier: MIT
#include "constraints/joints/kinds.h"

namespace jostle::physics {
namespace {

Softness softness_of(const JointStep& step, const JointSpring& spring) {
    return spring.hertz > 0 ? soft(spring.hertz, spring.damping_ratio, step.h) : step.rigid;
}

// A spring gives in the relaxing pass too; only what is rigid is relaxed.
JointStep pass_of(const JointStep& step, const JointSpring& spring) {
    JointStep pass = step;
    pass.relax = step.relax && spring.hertz == 0;
    return pass;
}

}  // namespace

void warm_start_fixed(JointPair& pair, const FixedJoint&, Joint& joint) {
    pair.push(joint.point);
    pair.turn(joint.turn);
}

void solve_fixed(JointPair& pair, const JointStep& step, const FixedJoint& kind, Joint& joint) {
    // The turn from a's frame to b's; the shorter way round.
    const Quat q = pair.frame_b * conjugate(pair.frame_a);
    const Vec3 error = Vec3{q.x, q.y, q.z} * (q.w < 0 ? -2.0 : 2.0);
    hold_turns(pair, pass_of(step, kind.angular), softness_of(step, kind.angular), error,
               joint.turn);
    hold_points(pair, pass_of(step, kind.linear), softness_of(step, kind.linear), joint.point);
}

JointLoad load_of_fixed(const JointPair&, const FixedJoint&, const Joint& joint) {
    return {joint.point, joint.turn};
}

}  // namespace jostle::physics
