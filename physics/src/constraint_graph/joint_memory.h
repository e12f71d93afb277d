// SPDX-License-Identifier: MIT
//
// What joints of some kinds keep beside what all have: numbers in Joint::memory, as many as the
// kind says. Saved and hashed with the joint.
#pragma once

#include <cstddef>

#include "jostle/physics/joint_defs.h"

namespace jostle::physics {

// Impulses of one sub-step along a free axis of a slider, a six-dof or a wheel, N s or N m s.
struct AxisImpulses {
    enum At : std::size_t { lower, upper, spring, motor, friction, count };
};

// By kind: how many axes have such impulses, one after the other.
constexpr std::size_t axes_of(const SliderJoint&) {
    return 1;
}
constexpr std::size_t axes_of(const SixDofJoint&) {
    return 6;
}
constexpr std::size_t axes_of(const WheelJoint&) {
    return 3;
}

inline std::size_t memory_of(const JointKind& kind) {
    return std::visit(
        [](const auto& joint) -> std::size_t {
            if constexpr (requires { axes_of(joint); })
                return axes_of(joint) * AxisImpulses::count;
            else
                return 0;
        },
        kind);
}

}  // namespace jostle::physics
