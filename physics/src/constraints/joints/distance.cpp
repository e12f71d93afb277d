// SPDX-License-Identifier: MIT
#include "constraints/joints/kinds.h"

namespace jostle::physics {
namespace {

// From a's anchor to b's; up when they coincide and there is no such direction.
Vec3 line_of(const JointPair& pair) {
    return normalized(pair.apart);
}

}  // namespace

void warm_start_distance(JointPair& pair, const DistanceJoint&, Joint& joint) {
    pair.push(line_of(pair) * (joint.spring + joint.lower - joint.upper));
}

void solve_distance(JointPair& pair, const JointStep& step, const DistanceJoint& kind,
                    Joint& joint) {
    const Vec3 line = line_of(pair);
    const Row row = length_row(pair, line);
    const double now = length(pair.apart);
    if (kind.min_length == kind.max_length) {
        // A rod: one row that pulls and pushes.
        spring_row(pair, row, step.relax ? Softness{} : step.rigid, now - kind.min_length,
                   joint.spring);
        return;
    }
    if (kind.spring.hertz > 0)
        spring_row(pair, row, soft(kind.spring.hertz, kind.spring.damping_ratio, step.h),
                   now - kind.rest_length, joint.spring);
    else
        joint.spring = 0;
    limit_row(pair, step, row, now - kind.min_length, joint.lower);
    limit_row(pair, step, {-line, false, row.inverse_mass}, kind.max_length - now, joint.upper);
}

JointLoad load_of_distance(const JointPair& pair, const DistanceJoint&, const Joint& joint) {
    return {line_of(pair) * (joint.spring + joint.lower - joint.upper), {}};
}

}  // namespace jostle::physics
