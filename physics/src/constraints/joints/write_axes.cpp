// SPDX-License-Identifier: MIT
#include "physics/src/constraints/joints/write_axes.h"

#include "jostle/base/check.h"
#include "physics/src/constraint_graph/joint_memory.h"
#include "physics/src/constraints/joints/axes_layout.h"

namespace jostle::physics {
namespace {

AxesLayout layout_of(const JointKind& kind) {
    return std::visit(
        [](const auto& joint) -> AxesLayout {
            if constexpr (requires { physics::layout_of(joint); })
                return physics::layout_of(joint);
            else
                return {};
        },
        kind);
}

std::size_t first_impulse(int slot) {
    ASSERT(slot >= 0);
    return static_cast<std::size_t>(slot) * AxisImpulses::count;
}

std::uint32_t write_axis(const JointAxis& axis, const double* impulses, double h, JointAxisWide& to,
                         const JointLane& lane) {
    std::uint32_t uses = 0;
    const bool limited = axis.free && axis.limit.enabled,
               sprung = axis.free && axis.spring.hertz > 0,
               driven = axis.free && axis.motor.enabled,
               friction_limit = axis.free && axis.friction > 0;
    lane.put(to.lower_at, limited ? axis.limit.lower : double{-never});
    lane.put(to.upper_at, limited ? axis.limit.upper : double{never});
    lane.put(to.lower, stored(limited, impulses[AxisImpulses::lower]));
    lane.put(to.upper, stored(limited, impulses[AxisImpulses::upper]));
    lane.put(to.soft, sprung ? spring_or(axis.spring, h, {}) : switched_off);
    lane.put(to.spring_at, axis.spring_target);
    lane.put(to.spring_most, strongest(axis.spring_max_force, h));
    lane.put(to.spring, stored(sprung, impulses[AxisImpulses::spring_impulse]));
    lane.put(to.motor_speed, axis.motor.speed);
    lane.put(to.motor_most, driven ? axis.motor.max_force * h : 0);
    lane.put(to.motor, stored(driven, impulses[AxisImpulses::motor]));
    lane.put(to.friction_most, friction_limit ? axis.friction * h : 0);
    lane.put(to.friction, stored(friction_limit, impulses[AxisImpulses::friction]));
    if (limited) uses |= uses_limit;
    if (sprung) uses |= uses_spring;
    if (driven) uses |= uses_motor;
    if (friction_limit) uses |= uses_friction;
    return uses;
}

}  // namespace

bool turns_with_a(const JointKind& kind) {
    if (const auto* six = std::get_if<SixDofJoint>(&kind))
        return six->axes->x.free || six->axes->y.free || six->axes->z.free;
    if (std::holds_alternative<PathJoint>(kind)) return true;
    return std::holds_alternative<SliderJoint>(kind) || std::holds_alternative<WheelJoint>(kind);
}

std::uint32_t write_axes(const Joint& joint, const JointEnd& a, const JointEnd& b, double h,
                         const PathPoint* path_point, JointAxesWide& to, const JointLane& lane) {
    const AxesLayout layout = path_point == nullptr
                                  ? layout_of(joint.kind)
                                  : layout_at(std::get<PathJoint>(joint.kind), *path_point);
    const Quat frame_a = a.frame * layout.turn_a, frame_b = b.frame * layout.turn_b;
    lane.put(to.frame_a, frame_a);
    lane.put(to.turn, conjugate(frame_a) * frame_b);
    lane.put(to.by_a, turns_with_a(joint.kind) ? 1 : 0);
    const double turns[] = {joint.angular.x, joint.angular.y, joint.angular.z};
    ASSERT(h > 0 && joint.memory.size() == memory_of(joint.kind));
    std::uint32_t uses = 0;
    if (path_point != nullptr) {
        uses = uses_curve;
        lane.put(to.curvature, path_point->curvature);
    }
    for (std::size_t k = 0; k < 6; k++) {
        const bool locked = !layout.axes[k].free;
        lane.put(to.locked[k], locked ? 1 : 0);
        if (k >= 3) lane.put(to.turns[k - 3], stored(locked, turns[k - 3]));
        if (layout.slots[k] >= 0)
            uses |= write_axis(layout.axes[k], &joint.memory[first_impulse(layout.slots[k])], h,
                               to.axes[k], lane)
                    << 4 * k;
    }
    return uses;
}

void read_axes(Joint& joint, const JointAxesWide& from, double dt, const JointLane& lane) {
    joint.torque = lane.get3(from.torque) * (1 / dt);
    joint.angular = lane.get3(from.turns);
    ASSERT(dt > 0 && joint.memory.size() == memory_of(joint.kind));
    const auto* path = std::get_if<PathJoint>(&joint.kind);
    if (path != nullptr) {
        double* memory = joint.memory.data();
        const double at = from.at[lane.at];
        memory[PathMemory::step] =
            memory[PathMemory::found] == 0 ? 0 : parameter_step(*path, memory[PathMemory::at], at);
        memory[PathMemory::found] = 1;
        memory[PathMemory::at] = at;
    }
    const AxesLayout layout = path != nullptr ? layout_at(*path, {}) : layout_of(joint.kind);
    for (std::size_t k = 0; k < 6; k++) {
        if (layout.slots[k] < 0) continue;
        double* impulses = &joint.memory[first_impulse(layout.slots[k])];
        const JointAxisWide& axis = from.axes[k];
        impulses[AxisImpulses::lower] = lane.get(axis.lower);
        impulses[AxisImpulses::upper] = lane.get(axis.upper);
        impulses[AxisImpulses::spring_impulse] = lane.get(axis.spring);
        impulses[AxisImpulses::motor] = lane.get(axis.motor);
        impulses[AxisImpulses::friction] = lane.get(axis.friction);
    }
}

}  // namespace jostle::physics
