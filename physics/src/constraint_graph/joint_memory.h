// SPDX-License-Identifier: MIT
//
// Persistent numbers that some joint kinds store in Joint::memory in addition to the common state.
// The kind determines their count. They are saved and hashed with the joint.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <variant>

#include "jostle/physics/joint_defs.h"

namespace jostle::physics {

// Impulses of one sub-step along a free axis of a slider, six-dof or wheel, N s or N m s.
struct AxisImpulses {
    enum At : std::size_t { lower, upper, spring_impulse, motor, friction, count };
};

// Number of axes with such impulses, by kind.
constexpr std::size_t axes_of(const SliderJoint&) {
    return 1;
}
constexpr std::size_t axes_of(const SixDofJoint&) {
    return 6;
}
constexpr std::size_t axes_of(const WheelJoint&) {
    return 3;
}

// State of gears and racks: the reference that their ends were measured against, and their
// accumulated rotation or travel.
struct GearMemory {
    enum At : std::size_t { measured, carrier_a, carrier_b, travel_a, travel_b, sum, count };
};

// Whether a joint kind is one row that couples the displacements of two ends, each relative to a
// carrier.
template <class Kind>
inline constexpr bool is_geared =
    std::is_same_v<Kind, GearJoint> || std::is_same_v<Kind, RackJoint> ||
    std::is_same_v<Kind, PulleyJoint>;
template <class Kind>
inline constexpr bool has_gear_memory = is_geared<Kind> && !std::is_same_v<Kind, PulleyJoint>;

// Ball joints with a drive or friction use their own kernel, so that other ball joints pay nothing
// for them.
// Hinges with limits, and cones, are held after contacts (stages/solver/hold_limits.h).
inline constexpr std::uint32_t driven_ball = joint_kinds, limited_hinge = joint_kinds + 1,
                               kernel_kinds = joint_kinds + 2;
inline std::uint32_t kernel_of(const JointKind& kind) {
    const auto* ball = std::get_if<BallJoint>(&kind);
    const bool driven =
        ball != nullptr && (ball->drive.spring.hertz > 0 || ball->friction_torque > 0);
    const auto* hinge = std::get_if<HingeJoint>(&kind);
    if (hinge != nullptr && hinge->limit.enabled) return limited_hinge;
    return driven ? driven_ball : static_cast<std::uint32_t>(kind.index());
}
inline bool is_limited_kernel(std::uint32_t kernel) {
    return kernel == limited_hinge ||
           kernel == JointKind(std::in_place_type<ConeTwistJoint>).index();
}

inline bool joint_is_geared(const JointKind& kind) {
    return std::visit([]<class Kind>(const Kind&) { return is_geared<Kind>; }, kind);
}

// State of a path joint after its axis impulses: the position of b on the curve once it was found,
// and its distance from the position in the previous step.
struct PathMemory {
    enum At : std::size_t { found = AxisImpulses::count, at, step, count };
};
constexpr std::size_t axes_of(const PathJoint&) {
    return 1;
}

inline std::size_t memory_of(const JointKind& kind) {
    return std::visit(
        []<class Kind>(const Kind& joint) -> std::size_t {
            if constexpr (std::is_same_v<Kind, PathJoint>)
                return PathMemory::count;
            else if constexpr (requires { axes_of(joint); })
                return axes_of(joint) * AxisImpulses::count;
            else if constexpr (has_gear_memory<Kind>)
                return GearMemory::count;
            else
                return 0;
        },
        kind);
}

}  // namespace jostle::physics
