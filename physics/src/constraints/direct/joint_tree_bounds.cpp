// SPDX-License-Identifier: MIT
//
// Limits, motors and friction along the axes of the hinges of a tree, by the active set of
// direct_bounds.cpp.
#include <utility>

#include "physics/src/constraints/direct/joint_tree.h"
#include "physics/src/foundation/tuning.h"

namespace jostle::physics {

// ---- the angle ----

double JointTree::angle_of(const Axis& axis) const {
    const Joint& joint = joints_[as_index(axis.joint)];
    const Hinge& hinge = hinges_[as_index(joint.hinge)];
    const Mat3& a = bodies_[as_index(joint.a)].axes1;
    const Vec3 x = hinge.end_across[0];
    return nearest_angle(arc_tangent(dot(x, a * axis.free.y_a), dot(x, a * axis.free.x_a)),
                         axis.free.reference);
}

// The error of the row, at the end of the attempt, h after the start of the step.
double JointTree::axis_error(const Axis& axis, double h) const {
    const FreeAxis& free = axis.free;
    if (free.at_limit != 0)
        return angle_of(axis) - (free.at_limit > 0 ? free.lower : free.upper) - axis.target;
    if (!free.is_held()) return 0;
    return wrapped(wrapped(angle_of(axis) - free.start) - free.hold_speed() * h);
}

double JointTree::error_of_holding() const {
    double largest = 0;
    const auto add = [&](double size) { largest = size <= largest ? largest : size; };
    for (const Joint& joint : joints_) {
        for (const double size : {joint.apart.x, joint.apart.y, joint.apart.z}) add(absolute(size));
        if (joint.hinge < 0) continue;
        const Hinge& hinge = hinges_[as_index(joint.hinge)];
        for (int row = 0; row < 2; row++) add(absolute(hinge.error[row]) * reach_);
    }
    return largest;
}

double JointTree::angle_error() const {
    double most = 0;
    for (const Axis& axis : axes_)
        if (axis.free.has_limit())
            most = maximum(most, maximum(axis.free.lower - axis.free.start,
                                         axis.free.start - axis.free.upper));
    return most;
}

// Energy that motors add in a step, J.
double JointTree::work_of_axes() const {
    double work = 0;
    for (const Axis& axis : axes_) {
        if (axis.free.steps == 0) continue;
        const double travel = axis.free.value - axis.free.start;
        work +=
            axis.free.push_between(0) * absolute(axis.free.has_range() ? travel : wrapped(travel));
    }
    return work;
}

// ---- impulses ----

// Applies an impulse about the axis `row`, whether or not its row is active.
void JointTree::turn(Axis& axis, Vec3 row, double impulse) {
    const Joint& joint = joints_[as_index(axis.joint)];
    const Vec3 angular = row * impulse;
    bodies_[as_index(joint.a)].l -= angular;
    bodies_[as_index(joint.b)].l += angular;
    hinges_[as_index(joint.hinge)].torque_sum += angular;
}

// Actuation between its steps, for `time`, about the current axes.
void JointTree::push_axes(double time) {
    for (Axis& axis : axes_) {
        const double push = axis.free.push();
        if (push != 0)
            turn(axis, hinges_[as_index(joints_[as_index(axis.joint)].hinge)].at_axis, time * push);
    }
}

// ---- the active set ----

// Activates or deactivates the row according to the free axis.
void JointTree::set_row(Axis& axis) {
    Hinge& hinge = hinges_[as_index(joints_[as_index(axis.joint)].hinge)];
    const bool bound = axis.free.at_limit != 0 || axis.free.is_held();
    if (!bound) hinge.force[2] = 0;
    axis.free.bound = bound;
    if (axis.off != bound) return;
    axis.off = !bound;
    hinge.rows[2] = bound ? hinge.at_axis : Vec3{};
    factored_ = false;
}

// Called at the start of the step. A free axis between two actuation steps that may reach the next
// one is held at that step's speed.
void JointTree::set_bounds(double h) {
    for (Axis& axis : axes_) {
        FreeAxis& free = axis.free;
        const Joint& joint = joints_[as_index(axis.joint)];
        Hinge& hinge = hinges_[as_index(joint.hinge)];
        if (free.at_limit == 0 && free.actuation >= 0 && !free.is_held()) {
            const Body &a = bodies_[as_index(joint.a)], &b = bodies_[as_index(joint.b)];
            const double speed =
                dot(hinge.at_axis, b.inverse_inertia * b.l - a.inverse_inertia * a.l);
            const double response = dot(hinge.at_axis, a.inverse_inertia * hinge.at_axis) +
                                    dot(hinge.at_axis, b.inverse_inertia * hinge.at_axis);
            const double push = free.push(), gained = response * free.push_between(0) * h;
            const int p = free.actuation / 2;
            if (p < free.steps && free.speeds[p] - speed <= gained)
                free.actuation = 2 * p + 1;
            else if (p > 0 && speed - free.speeds[p - 1] <= gained)
                free.actuation = 2 * p - 1;
            if (free.is_held()) hinge.force[2] = 0.5 * push;
        }
        if (free.at_limit != 0 && free.is_held()) actuation_on_limit(free);
        set_row(axis);
    }
}

// Call before the attempt, at the state. Saves the momenta of the bodies.
void JointTree::set_targets(double h) {
    for (Axis& axis : axes_) {
        axis.free.start = axis.free.value;
        if (axis.free.has_range()) axis.free.reference = axis.free.start;
        axis.target = 0;
        if (axis.free.at_limit == 0) continue;
        axis.free.overrun = is_overrun(axis.free);
        axis.target = bounded_excess(axis.free, tuning::joint_push_spin * h);
    }
    guess_.clear();
    for (const Body& body : bodies_) guess_.push_back(body.l), guess_.push_back(body.p);
}

bool JointTree::enforce_bounds(Axis& axis, double value, double scale, double time, Level level) {
    FreeAxis& free = axis.free;
    Hinge& hinge = hinges_[as_index(joints_[as_index(axis.joint)].hinge)];
    if (free.at_limit != 0) {
        if (value * free.at_limit * (scale < 0 ? -1 : 1) >= 0) return false;
        if (level == Level::velocities && free.overrun) {
            hinge.force[2] = 0;
            return false;
        }
        free.at_limit = 0;
        axis.target = 0;
        if (free.steps > 0 && free.actuation == FreeAxis::at_rest) load_actuation(free, 0);
    } else if (free.is_held()) {
        const int p = free.actuation / 2;
        if (value > scale * free.push_between(p))
            free.actuation = 2 * p;
        else if (value < scale * free.push_between(p + 1))
            free.actuation = 2 * p + 2;
        else
            return false;
        turn(axis, hinge.at_axis, time * free.push());
    } else {
        return false;
    }
    set_row(axis);
    return true;
}

// Activates the limits that the step would exceed.
bool JointTree::reach_limits(double h, double time) {
    bool changed = false;
    for (Axis& axis : axes_) {
        FreeAxis& free = axis.free;
        if (!free.has_limit() || free.at_limit != 0) continue;
        const double value = angle_of(axis);
        free.at_limit = value < free.lower ? 1 : (value > free.upper ? -1 : 0);
        if (free.at_limit == 0) continue;
        const double excess = bounded_excess(free, tuning::joint_push_spin * h);
        const double beyond = value - (free.at_limit > 0 ? free.lower : free.upper) - excess;
        if (beyond * free.at_limit >= 0) {  // it recovers faster without the limit
            free.at_limit = 0;
            continue;
        }
        const int old_actuation = free.actuation;
        actuation_on_limit(free);
        if (free.at_limit == 0) continue;
        axis.target = excess;
        free.overrun = is_overrun(free);
        const Hinge& hinge = hinges_[as_index(joints_[as_index(axis.joint)].hinge)];
        if (free.actuation != old_actuation) turn(axis, hinge.at_axis, time * free.push());
        set_row(axis);
        changed = true;
    }
    return changed;
}

bool JointTree::change_bounds(double h) {
    // Pushes of released motors go to the momenta before the attempt.
    for (std::size_t k = 0; k < bodies_.size(); k++) {
        std::swap(bodies_[k].l, guess_[2 * k]);
        std::swap(bodies_[k].p, guess_[2 * k + 1]);
    }
    bool changed = reach_limits(h, 0.5 * h);
    for (Axis& axis : axes_) {
        const Hinge& hinge = hinges_[as_index(joints_[as_index(axis.joint)].hinge)];
        if (enforce_bounds(axis, hinge.impulse[2], 0.5 * h, 0.5 * h, Level::positions))
            changed = true;
    }
    if (changed)
        for (std::size_t k = 0; k < bodies_.size(); k++)
            guess_[2 * k] = bodies_[k].l, guess_[2 * k + 1] = bodies_[k].p;
    else
        for (std::size_t k = 0; k < bodies_.size(); k++)
            bodies_[k].l = guess_[2 * k], bodies_[k].p = guess_[2 * k + 1];
    return changed;
}

// From the solved velocities.
void JointTree::set_axis_forces(const System& system, double h) {
    for (const Axis& axis : axes_) {
        const Joint& joint = joints_[as_index(axis.joint)];
        hinges_[as_index(joint.hinge)].force[2] =
            axis.free.bound ? system.unknowns[as_index(joint.row) + 5] / h : 0;
    }
}

// Returns true if a bound changed; the velocities are then solved again.
bool JointTree::enforce_at_velocities(double h) {
    bool changed = false;
    for (Axis& axis : axes_) {
        const Hinge& hinge = hinges_[as_index(joints_[as_index(axis.joint)].hinge)];
        if (enforce_bounds(axis, hinge.force[2], 0.5, 0.5 * h, Level::velocities)) changed = true;
    }
    if (changed) measure_spins();
    return changed;
}

}  // namespace jostle::physics
