// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include "jostle/base/check.h"
#include "physics/src/constraints/direct/direct_group.h"
#include "physics/src/constraints/direct/free_turn.h"
#include "physics/src/constraints/free_motion.h"
#include "physics/src/foundation/tuning.h"

namespace jostle::physics {
// ---- J M^-1 J^T ----

void DirectGroup::write_all_vectors() {
    for (DirectJoint& joint : joints) write_vectors(joint, bodies);
}

void DirectGroup::factor_here() {
    if (factored_) return;
    write_all_vectors();
    if (sprung_) set_springs();
    assemble(1, &DirectBody::inverse_inertia);
    factored_ = true;
}

// ---- forces and damping ----

void DirectGroup::damp(double time) {
    // Most bodies have the same damping.
    double damping = 0, factor = 1;
    const auto factor_of = [&](double of_body) {
        if (of_body != damping) damping = of_body, factor = damping_factor(damping, time);
        return factor;
    };
    for (DirectBody& body : bodies) {
        if (body.linear_damping != 0) body.p *= factor_of(body.linear_damping);
        if (body.angular_damping != 0) body.l *= factor_of(body.angular_damping);
    }
}

void DirectGroup::kick(double h, bool second) {
    if (outside != nullptr) outside->push(bodies, time_ + (second ? 0.5 * h : 0), 0.5 * h, 0);
    for (DirectBody& body : bodies) {
        body.p += body.force * (0.5 * h);
        body.l += body.torque * (0.5 * h);
    }
    if (smooth_ && !sprung_) return;
    damp(0.5 * h);
    if (!sprung_ && !actuated_) return;
    for (DirectJoint& joint : joints)
        for (const FreeAxis& free_axis : joint.free_axes) {
            const double push =
                free_axis.push() - free_axis.stiffness * stretch_of(free_axis, free_axis.value);
            if (push != 0) apply_impulse(joint, free_axis, 0.5 * h * push);
        }
}

void DirectGroup::push_gear(const DirectJoint& joint, double impulse) {
    const DirectGear& gear = joint.gear[0];
    for (int k = 0; k < gear.part_count; k++) {
        DirectBody& body = bodies[as_index(gear.parts[k].body)];
        body.p += gear.parts[k].linear * impulse;
        body.l += gear.parts[k].angular * impulse;
    }
}
// The torque about the end of b.
void DirectGroup::record_gear(DirectJoint& joint, double impulse) {
    const DirectGear::Part& part = part_of(joint.gear[0], joint.b);
    const Vec3 arm = bodies[as_index(joint.b)].axes * joint.arm_b;
    joint.force_sum += part.linear * impulse;
    joint.torque_sum += (part.angular - cross(arm, part.linear)) * impulse;
}

// Applies impulses along the rows to the two bodies.
void DirectGroup::push(const DirectJoint& joint, const double* impulse) {
    if (joint.is_gear()) return push_gear(joint, impulse[0]);
    DirectBody &a = bodies[as_index(joint.a)], &b = bodies[as_index(joint.b)];
    const Vec3 linear = pull_of(joint, impulse);
    if (joint.is_ball_alone()) {
        a.p -= linear;
        a.l += cross(linear, joint.lever_a);
        b.p += linear;
        b.l += cross(joint.lever_b, linear);
        return;
    }
    Vec3 about_a, about_b;
    for (int k = 0; k < joint.rows(); k++) {
        about_a += joint.angular_a[k] * impulse[k];
        about_b += joint.angular_b[k] * impulse[k];
    }
    a.p -= linear;
    a.l += about_a;
    b.p += linear;
    b.l += about_b;
}

// Applies and records impulses. Joints report the recorded sum.
void DirectGroup::act(DirectJoint& joint, const double* impulse) {
    push(joint, impulse);
    record(joint, impulse);
}

void DirectGroup::record(DirectJoint& joint, const double* impulse) {
    if (joint.is_gear()) return record_gear(joint, impulse[0]);
    joint.force_sum += pull_of(joint, impulse);
    ASSERT(joint.points <= joint.first_free_axis() && joint.first_free_axis() <= joint.rows());
    for (int k = joint.points; k < joint.first_free_axis(); k++)
        joint.torque_sum += joint.angular_b[k] * impulse[k];
    for (int k = joint.first_free_axis(); k < joint.rows(); k++)
        if (!joint.is_linear(k)) joint.torque_sum += joint.angular_b[k] * impulse[k];
}

// ---- errors ----

// Returns the largest error in metres. Rotational errors are scaled with the group's length. For
// separated ends it is the remaining error of this step.
double DirectGroup::measure_all(double h) {
    ASSERT(reach_ > 0);
    double largest = 0;
    for (DirectJoint& joint : joints) {
        measure(joint, bodies, h);
        for (int k = 0; k < joint.rows(); k++) {
            joint.error[k] -= joint.target[k];
            if (locked_ && joint.blocked[as_index(k)]) joint.error[k] = 0;
            const double size = absolute(joint.error[k]) * (joint.is_linear(k) ? 1 : reach_);
            largest = size <= largest ? largest : size;  // propagates NaN
        }
    }
    return largest;
}

// Error of the rigid rows alone, without limits and actuation. Two contradicting motors, or a limit
// that other joints keep out of reach, have no solution; the step may still succeed without one.
double DirectGroup::error_of_holding() const {
    double largest = 0;
    for (const DirectJoint& joint : joints)
        for (int k = 0; k < joint.first_free_axis(); k++) {
            const double size = absolute(joint.error[k]) * (k < joint.points ? 1 : reach_);
            largest = size <= largest ? largest : size;
        }
    return largest;
}

// Separated ends approach each other at a bounded speed.
bool DirectGroup::set_targets(double h) {
    bool left_over = false;
    const double most = tuning::joint_push_speed * absolute(h);
    const double max_turn = tuning::joint_push_spin * absolute(h);
    for (DirectJoint& joint : joints) {
        measure_start(joint, bodies);
        std::fill(std::begin(joint.target), std::end(joint.target), 0.0);
        double apart = 0, turned = 0;
        for (int k = 0; k < joint.points; k++) apart += joint.start[k] * joint.start[k];
        for (int k = joint.points; k < joint.first_free_axis(); k++)
            turned += joint.start[k] * joint.start[k];
        left_over |= apart > most * most || turned > max_turn * max_turn;
        if (apart > most * most) {
            const double left = 1 - most / square_root(apart);
            for (int k = 0; k < joint.points; k++) joint.target[k] = joint.start[k] * left;
        }
        if (turned > max_turn * max_turn) {
            const double left = 1 - max_turn / square_root(turned);
            for (int k = joint.points; k < joint.first_free_axis(); k++)
                joint.target[k] = joint.start[k] * left;
        }
        for (std::size_t k = 0; k < joint.free_axes.size(); k++) {
            FreeAxis& free_axis = joint.free_axes[k];
            if (free_axis.at_limit == 0) continue;
            free_axis.overrun = is_overrun(free_axis);
            joint.target[joint.first_free_axis() + static_cast<int>(k)] =
                bounded_excess(free_axis, free_axis.is_linear() ? most : max_turn);
        }
    }
    return left_over;
}

void DirectGroup::commit() {
    for (DirectBody& body : bodies) {
        body.x = body.x1;
        body.q = body.q1;
        body.axes = body.axes1;
        if (body.pushed) body.inverse_inertia = in_axes(body.axes, body.inverse_moments);
    }
    factored_ = false;
}

// ---- velocities ----

namespace {

void rate(const DirectJoint& joint, Vec3 va, Vec3 wa, Vec3 vb, Vec3 wb, double* to) {
    const Vec3 v = vb - va;
    if (joint.is_ball_alone()) {
        const Vec3 all = v + (cross(joint.lever_a, wa) + cross(wb, joint.lever_b));
        to[0] = all.x, to[1] = all.y, to[2] = all.z;
        return;
    }
    for (int k = 0; k < joint.rows(); k++)
        to[k] = dot(joint.angular_a[k], wa) + dot(joint.angular_b[k], wb);
    if (joint.is_ball())
        to[0] += v.x, to[1] += v.y, to[2] += v.z;
    else
        for (int k = 0; k < joint.rows(); k++) to[k] += dot(joint.linear[k], v);
}

}  // namespace

void DirectGroup::project_velocities(double h, double bias, bool save_forces) {
    for (int round = 0;; round++) {
        factor_here();
        for (DirectBody& body : bodies) {
            body.v0 = velocity(body);
            body.w0 = spin(body);
        }
        for (std::size_t k = 0; k < joints.size(); k++) {
            const DirectJoint& joint = joints[k];
            const DirectBody &a = bodies[as_index(joint.a)], &b = bodies[as_index(joint.b)];
            double* const to = right_side_.data() + matrix_.row_of(static_cast<int>(k));
            if (!joint.is_gear())
                rate(joint, a.v0, a.w0, b.v0, b.w0, to);
            else
                to[0] = rate_of(joint.gear[0], bodies);
            for (std::size_t w = 0; w < joint.free_axes.size(); w++)
                if (joint.free_axes[w].at_limit == 0 && joint.free_axes[w].is_held())
                    to[as_index(joint.first_free_axis()) + w] -= joint.free_axes[w].hold_speed();
            for (int r = 0; r < joint.rows(); r++)
                to[r] = -to[r] - (bias != 0 ? bias * joint.error[r] : 0);
        }
        solve();
        bool changed = false;
        for (std::size_t k = 0; k < joints.size(); k++) {
            DirectJoint& joint = joints[k];
            const double* const impulse = right_side_.data() + matrix_.row_of(static_cast<int>(k));
            if (!save_forces) continue;
            for (int r = 0; r < joint.rows(); r++)
                if (!joint.off[as_index(r)]) joint.force[r] = impulse[r] / h;
            for (std::size_t w = 0; w < joint.free_axes.size(); w++)
                if (joint.free_axes[w].at_limit == 0 && !joint.free_axes[w].is_held())
                    joint.force[as_index(joint.first_free_axis()) + w] = 0;
            if (!bounded_ || round >= bound_rounds) continue;
            if (enforce_bounds(joint, joint.force, 0.5, 0.5 * h, true)) changed = true;
        }
        if (!changed) break;
    }
    for (std::size_t k = 0; k < joints.size(); k++)
        act(joints[k], right_side_.data() + matrix_.row_of(static_cast<int>(k)));
}

}  // namespace jostle::physics
