// SPDX-License-Identifier: MIT
//
// Forces along the free axes of joints: limits, motors and friction by an active set, and damped
// springs.
#include "jostle/base/check.h"
#include "physics/src/constraints/direct/direct_group.h"
#include "physics/src/constraints/softness.h"
#include "physics/src/foundation/tuning.h"

namespace jostle::physics {
// Applies an impulse along a free axis, whether or not its row is active.
void DirectGroup::apply_impulse(DirectJoint& joint, const FreeAxis& free_axis, double impulse) {
    DirectBody &a = bodies[as_index(joint.a)], &b = bodies[as_index(joint.b)];
    ASSERT(joint.a != joint.b);
    const Vec3 linear = free_axis.linear * impulse, about_b = free_axis.angular_b * impulse;
    a.p -= linear;
    a.l += free_axis.angular_a * impulse;
    b.p += linear;
    b.l += about_b;
    joint.force_sum += linear;
    if (!free_axis.is_linear()) joint.torque_sum += about_b;
}

// ---- springs ----

// Uses the masses of the two bodies in the current state. Half of the damping acts at the velocity
// before the step, half at the velocity after it (trapezoidal rule), with the rate at which an
// isolated pair of bodies loses exactly the right energy.
void DirectGroup::set_springs() {
    for (DirectJoint& joint : joints)
        for (FreeAxis& free_axis : joint.free_axes) {
            if (free_axis.rate == 0) continue;
            const double response =
                response_of(free_axis, bodies[as_index(joint.a)], bodies[as_index(joint.b)]);
            // A spring along a locked axis has no effect.
            const double mass = response > FreeAxis::min_response ? 1 / response : 0;
            free_axis.stiffness = free_axis.rate * free_axis.rate * mass;
            if (free_axis.damping_ratio == 0) continue;
            const double left = decay(2 * free_axis.damping_ratio * free_axis.rate * step_);
            free_axis.damper = (1 - left) / (1 + left) * mass;
        }
}

// The damping half before the step.
void DirectGroup::damp_springs() {
    const auto each = [&](const auto& call) {
        for (DirectJoint& joint : joints)
            for (std::size_t k = 0; k < joint.free_axes.size(); k++) {
                FreeAxis& free_axis = joint.free_axes[k];
                if (!free_axis.is_damped() || free_axis.at_limit != 0 || free_axis.is_held())
                    continue;
                call(joint, free_axis, joint.impulse[as_index(joint.first_free_axis()) + k]);
            }
    };
    each([&](DirectJoint& joint, FreeAxis& free_axis, double& speed) {
        speed = rate_of(free_axis, bodies[as_index(joint.a)], bodies[as_index(joint.b)]);
    });
    each([&](DirectJoint& joint, FreeAxis& free_axis, double& speed) {
        apply_impulse(joint, free_axis, -free_axis.damper * speed);
        speed = 0;
    });
}

// Limits the stiffness to what a kick of duration h resolves.
void DirectGroup::soften_springs(double h) {
    for (DirectJoint& joint : joints)
        for (FreeAxis& free_axis : joint.free_axes) {
            const double turn = free_axis.rate * h;
            if (turn > 0.5) free_axis.stiffness *= 0.25 / (turn * turn);
        }
}

// ---- limits, motors and friction ----

// Activates or deactivates the row according to the free axis.
void DirectGroup::set_row(DirectJoint& joint, int row) {
    ASSERT(row >= joint.first_free_axis() && row < joint.rows());
    FreeAxis& free_axis = joint.free_axes[as_index(row - joint.first_free_axis())];
    const bool bound = free_axis.at_limit != 0 || free_axis.is_held();
    free_axis.implicit = energy_ && free_axis.rate > 0 && !bound;
    const bool off = !bound && !free_axis.implicit && !free_axis.is_damped();
    if (!bound) joint.force[row] = 0;
    if (joint.off[as_index(row)] == off && free_axis.bound == bound) return;
    joint.off[as_index(row)] = off;
    joint.blocked[as_index(row)] = false;
    free_axis.bound = bound;
    factored_ = false;
}

// Called at the start of the step. A free axis at its limit stays there. A free axis between two
// actuation steps that may reach the next one is held at that step's speed.
void DirectGroup::set_bounds(double h) {
    if (damped_springs_ && step_ != h) factored_ = false;
    step_ = h;
    if (smooth_ && !sprung_) return;
    for (DirectJoint& joint : joints) {
        for (int row = joint.first_free_axis(); row < joint.rows(); row++) {
            FreeAxis& free_axis = joint.free_axes[as_index(row - joint.first_free_axis())];
            if (free_axis.at_limit == 0 && free_axis.actuation >= 0 && !free_axis.is_held()) {
                const DirectBody &a = bodies[as_index(joint.a)], &b = bodies[as_index(joint.b)];
                const double speed = rate_of(free_axis, a, b), push = free_axis.push();
                const double gained = response_of(free_axis, a, b) * free_axis.push_between(0) * h;
                const int p = free_axis.actuation / 2;
                if (p < free_axis.steps && free_axis.speeds[p] - speed <= gained)
                    free_axis.actuation = 2 * p + 1;
                else if (p > 0 && speed - free_axis.speeds[p - 1] <= gained)
                    free_axis.actuation = 2 * p - 1;
                if (free_axis.is_held()) joint.force[row] = 0.5 * push;
            }
            if (free_axis.at_limit != 0 && free_axis.is_held()) actuation_on_limit(free_axis);
            set_row(joint, row);
        }
    }
}

// Enforces that a limit only pushes and that an actuation hold stays within its maximum force.
// `value`: forces or impulses; a unit force yields `scale`. A released free axis is pushed for
// `time`. Returns true if a bound changed; the caller then solves again.
bool DirectGroup::enforce_bounds(DirectJoint& joint, const double* value, double scale, double time,
                                 bool at_velocities) {
    bool changed = false;
    for (int row = joint.first_free_axis(); row < joint.rows(); row++) {
        FreeAxis& free_axis = joint.free_axes[as_index(row - joint.first_free_axis())];
        if (free_axis.at_limit != 0) {
            if (value[row] * free_axis.at_limit * (scale < 0 ? -1 : 1) >= 0) continue;
            if (at_velocities && free_axis.overrun) {
                joint.force[row] = 0;
                continue;
            }
            free_axis.at_limit = 0;
            joint.target[row] = 0;
            if (free_axis.steps > 0 && free_axis.actuation == FreeAxis::at_rest)
                load_actuation(free_axis, 0);
        } else if (free_axis.is_held()) {
            const int p = free_axis.actuation / 2;
            if (value[row] > scale * free_axis.push_between(p))
                free_axis.actuation = 2 * p;
            else if (value[row] < scale * free_axis.push_between(p + 1))
                free_axis.actuation = 2 * p + 2;
            else
                continue;
            if (time != 0) apply_impulse(joint, free_axis, time * free_axis.push());
        } else {
            continue;
        }
        set_row(joint, row);
        changed = true;
    }
    return changed;
}

// Activates the limits that the step would exceed.
bool DirectGroup::reach_limits(double h, double time) {
    bool changed = false;
    const double most = tuning::joint_push_speed * absolute(h);
    const double max_turn = tuning::joint_push_spin * absolute(h);
    for (DirectJoint& joint : joints) {
        for (int row = joint.first_free_axis(); row < joint.rows(); row++) {
            FreeAxis& free_axis = joint.free_axes[as_index(row - joint.first_free_axis())];
            if (!free_axis.has_limit() || free_axis.at_limit != 0) continue;
            const double value = trial_value(joint, free_axis, bodies);
            free_axis.at_limit = value < free_axis.lower ? 1 : (value > free_axis.upper ? -1 : 0);
            ASSERT(free_axis.lower <= free_axis.upper);
            if (free_axis.at_limit == 0) continue;
            const double excess =
                bounded_excess(free_axis, free_axis.is_linear() ? most : max_turn);
            const double beyond =
                value - (free_axis.at_limit > 0 ? free_axis.lower : free_axis.upper) - excess;
            if (beyond * free_axis.at_limit >= 0) {  // it recovers faster without the limit
                free_axis.at_limit = 0;
                continue;
            }
            const int old_actuation = free_axis.actuation;
            actuation_on_limit(free_axis);
            if (free_axis.at_limit == 0) continue;
            joint.target[row] = excess;
            free_axis.overrun = is_overrun(free_axis);
            if (time != 0 && free_axis.actuation != old_actuation)
                apply_impulse(joint, free_axis, time * free_axis.push());
            set_row(joint, row);
            changed = true;
        }
    }
    return changed;
}

// Identifies the set of active limits. The active limits of a set only press, and each of them may
// do so while the group moves smoothly.
std::uint64_t DirectGroup::active_limits() const {
    std::uint64_t set = 0;
    for (const DirectJoint& joint : joints)
        for (const FreeAxis& free_axis : joint.free_axes)
            set = set * 3 + static_cast<std::uint64_t>(free_axis.at_limit + 1);
    return set;
}

// Whether another set of limits is active, or an active one is overrun: the motion has jumps.
bool DirectGroup::is_overrun_or_hit(std::uint64_t limits, double tolerance) const {
    if (active_limits() != limits) return true;
    for (const DirectJoint& joint : joints)
        for (const FreeAxis& free_axis : joint.free_axes)
            if (free_axis.at_limit != 0 &&
                absolute(bounded_excess(free_axis, 0)) * (free_axis.is_linear() ? 1 : reach_) >
                    tolerance)
                return true;
    return false;
}

}  // namespace jostle::physics
