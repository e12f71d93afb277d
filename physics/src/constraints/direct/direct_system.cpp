// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include "constraints/direct/direct_group.h"
#include "constraints/direct/free_turn.h"
#include "constraints/free_motion.h"
#include "foundation/check.h"
#include "foundation/tuning.h"

namespace jostle::physics {
namespace {

// m: at this distance all its mass would be as hard to turn.
double gyration_of(const DirectBody& body) {
    const Vec3& i = body.moments;
    return square_root(maximum(i.x, maximum(i.y, i.z)) * body.inverse_mass);
}

}  // namespace

// ---- the pattern ----

bool DirectGroup::prepare(std::int64_t most_work) {
    count_ = {};
    factored_ = false;
    smooth_ = true;
    for (const DirectBody& body : bodies)
        if (body.linear_damping != 0 || body.angular_damping != 0) smooth_ = false;
    double arms = 0;
    std::vector<int> pattern;
    pattern.reserve(joints.size() * 3 + bodies.size());
    for (const DirectBody& body : bodies) pattern.push_back(body.pushed ? 1 : 0);
    for (const DirectJoint& joint : joints) {
        if (joint.has_limit || joint.has_motor) smooth_ = false;
        arms += length(joint.arm_a) + length(joint.arm_b) + joint.distance;
        for (const int body : {joint.a, joint.b}) arms += gyration_of(bodies[as_index(body)]);
        pattern.insert(pattern.end(), {joint.a, joint.b, joint.rows()});
    }
    reach_ = arms / static_cast<double>(joints.size());
    if (pattern == pattern_) return true;
    pattern_.clear();

    std::vector<std::vector<int>> of_body(bodies.size());
    std::vector<int> rows;
    for (std::size_t k = 0; k < joints.size(); k++) {
        rows.push_back(joints[k].rows());
        for (const int body : {joints[k].a, joints[k].b})
            if (bodies[as_index(body)].pushed)
                of_body[as_index(body)].push_back(static_cast<int>(k));
    }
    std::vector<BlockLdl::Edge> edges;
    for (const std::vector<int>& list : of_body)
        for (std::size_t i = 0; i < list.size(); i++)
            for (std::size_t k = 0; k < i; k++) edges.push_back({list[i], list[k]});
    if (!matrix_.analyze(rows, edges, most_work)) return false;
    pattern_ = std::move(pattern);
    right_side_.assign(as_index(matrix_.rows()), 0);
    couplings_.clear();
    for (std::size_t body = 0; body < bodies.size(); body++) {
        const std::vector<int>& list = of_body[body];
        for (std::size_t i = 0; i < list.size(); i++)
            for (std::size_t k = 0; k <= i; k++) {
                const bool first_later = matrix_.is_later(list[i], list[k]);
                const int later = first_later ? list[i] : list[k];
                const int sooner = first_later ? list[k] : list[i];
                const int number = static_cast<int>(body);
                couplings_.push_back({matrix_.block_at(later, sooner), later, sooner, number,
                                      joints[as_index(later)].b == number,
                                      joints[as_index(sooner)].b == number});
            }
    }
    // Blocks are then summed up one after the other.
    std::sort(couplings_.begin(), couplings_.end(), [](const Coupling& x, const Coupling& y) {
        return std::pair(x.at, x.body) < std::pair(y.at, y.body);
    });
    return true;
}

// ---- J M^-1 J^T ----

void DirectGroup::write_all_vectors() {
    for (DirectJoint& joint : joints)
        write_vectors(joint, bodies[as_index(joint.a)], bodies[as_index(joint.b)]);
}

// `linear`: by how much an inverse mass counts; `response`: what takes the place of the inverse
// inertia.
void DirectGroup::assemble(double linear, const Mat3 DirectBody::*response) {
    matrix_.clear();
    double* const values = matrix_.values().data();
    for (const Coupling& c : couplings_) {
        const DirectJoint &later = joints[as_index(c.later)], &sooner = joints[as_index(c.sooner)];
        const DirectBody& body = bodies[as_index(c.body)];
        const Vec3* const rows = c.later_b ? later.angular_b : later.angular_a;
        const Vec3* const columns = c.sooner_b ? sooner.angular_b : sooner.angular_a;
        const int n = sooner.rows(), m = later.rows();
        double* const block = values + c.at;
        const Mat3& turned = body.*response;
        for (int i = 0; i < m; i++) {
            const Vec3 y = turned * rows[i];
            for (int k = 0; k < n; k++) block[i * n + k] += dot(y, columns[k]);
        }
        if (later.points == 0 || sooner.points == 0) continue;
        const double mass = (c.later_b == c.sooner_b ? linear : -linear) * body.inverse_mass;
        if (later.points == 3 && sooner.points == 3) {
            for (int i = 0; i < 3; i++) block[i * n + i] += mass;
        } else if (later.points == 1 && sooner.points == 1) {
            block[0] += mass * dot(later.line, sooner.line);
        } else if (later.points == 3) {
            for (int i = 0; i < 3; i++) block[i * n] += mass * sooner.line[i];
        } else {
            for (int k = 0; k < 3; k++) block[k] += mass * later.line[k];
        }
    }
    count_.left_out = matrix_.factor();
    count_.factors++;
}

void DirectGroup::factor_here() {
    if (factored_) return;
    write_all_vectors();
    assemble(1, &DirectBody::inverse_inertia);
    factored_ = true;
}

// ---- what acts ----

void DirectGroup::damp(double time) {
    for (DirectBody& body : bodies) {
        if (body.linear_damping != 0) body.p *= damping_factor(body.linear_damping, time);
        if (body.angular_damping != 0) body.l *= damping_factor(body.angular_damping, time);
    }
}

void DirectGroup::kick(double h) {
    for (DirectBody& body : bodies) {
        body.p += body.force * (0.5 * h);
        body.l += body.torque * (0.5 * h);
    }
    if (smooth_) return;
    damp(0.5 * h);
    for (DirectJoint& joint : joints)
        if (joint.at_most != 0) give_most(joint, 0.5 * h);
}

// On the two bodies.
void DirectGroup::push(const DirectJoint& joint, const double* impulse) {
    DirectBody &a = bodies[as_index(joint.a)], &b = bodies[as_index(joint.b)];
    Vec3 linear;
    if (joint.points == 3)
        linear = {impulse[0], impulse[1], impulse[2]};
    else if (joint.points == 1)
        linear = joint.line * impulse[0];
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

// For good: what joints report is the sum of it.
void DirectGroup::act(DirectJoint& joint, const double* impulse) {
    push(joint, impulse);
    record(joint, impulse);
}

void DirectGroup::record(DirectJoint& joint, const double* impulse) {
    if (joint.points == 3)
        joint.force_sum += Vec3{impulse[0], impulse[1], impulse[2]};
    else if (joint.points == 1)
        joint.force_sum += joint.line * impulse[0];
    for (int k = joint.points; k < joint.rows(); k++)
        joint.torque_sum += joint.angular_b[k] * impulse[k];
}

// ---- errors ----

// The largest, m: turns count with the group's own length. Where ends were far apart it is what is
// left to go in this step.
double DirectGroup::measure_all(double h) {
    double largest = 0;
    for (DirectJoint& joint : joints) {
        measure(joint, bodies[as_index(joint.a)], bodies[as_index(joint.b)], h);
        for (int k = 0; k < joint.rows(); k++) {
            joint.error[k] -= joint.target[k];
            const double size = absolute(joint.error[k]) * (k < joint.points ? 1 : reach_);
            largest = size <= largest ? largest : size;  // keeps a NaN
        }
    }
    return largest;
}

// What is far apart comes together no faster than joints may push.
bool DirectGroup::set_targets(double h) {
    bool left_over = false;
    const double most = tuning::joint_push_speed * absolute(h);
    const double most_turn = tuning::joint_push_spin * absolute(h);
    for (DirectJoint& joint : joints) {
        measure_start(joint, bodies[as_index(joint.a)], bodies[as_index(joint.b)]);
        std::fill(std::begin(joint.target), std::end(joint.target), 0.0);
        double apart = 0, turned = 0;
        for (int k = 0; k < joint.points; k++) apart += joint.start[k] * joint.start[k];
        for (int k = joint.points; k < joint.limit_row(); k++)
            turned += joint.start[k] * joint.start[k];
        left_over |= apart > most * most || turned > most_turn * most_turn;
        if (apart > most * most) {
            const double left = 1 - most / square_root(apart);
            for (int k = 0; k < joint.points; k++) joint.target[k] = joint.start[k] * left;
        }
        if (turned > most_turn * most_turn) {
            const double left = 1 - most_turn / square_root(turned);
            for (int k = joint.points; k < joint.limit_row(); k++)
                joint.target[k] = joint.start[k] * left;
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
    for (int k = 0; k < joint.rows(); k++)
        to[k] = dot(joint.angular_a[k], wa) + dot(joint.angular_b[k], wb);
    if (joint.points == 3)
        to[0] += v.x, to[1] += v.y, to[2] += v.z;
    else if (joint.points == 1)
        to[0] += dot(joint.line, v);
}

}  // namespace

void DirectGroup::project_velocities(double h, double bias, bool keep_forces) {
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
            rate(joint, a.v0, a.w0, b.v0, b.w0, to);
            if (joint.has_motor && joint.at_most == 0) to[joint.motor_row()] -= joint.speed;
            for (int r = 0; r < joint.rows(); r++)
                to[r] = -to[r] - (bias != 0 ? bias * joint.error[r] : 0);
        }
        matrix_.solve(right_side_);
        count_.solves++;
        bool changed = false;
        for (std::size_t k = 0; k < joints.size(); k++) {
            DirectJoint& joint = joints[k];
            const double* const impulse = right_side_.data() + matrix_.row_of(static_cast<int>(k));
            for (int r = 0; r < joint.rows(); r++)
                if (keep_forces && !joint.off[as_index(r)]) joint.force[r] = impulse[r] / h;
            if (!keep_forces || smooth_ || round >= bound_rounds) continue;
            const int at_most = joint.at_most;
            if (keep_bounds(joint, joint.force, 0.5 * joint.most_torque)) changed = true;
            if (joint.at_most != at_most) give_most(joint, 0.5 * h);
        }
        if (!changed) break;
    }
    for (std::size_t k = 0; k < joints.size(); k++)
        act(joints[k], right_side_.data() + matrix_.row_of(static_cast<int>(k)));
}

// ---- limits and motors ----

void DirectGroup::give_most(DirectJoint& joint, double time) {
    const Vec3 axis = bodies[as_index(joint.a)].axes * joint.axis_a;
    const Vec3 impulse = axis * (time * joint.at_most * joint.most_torque);
    bodies[as_index(joint.a)].l -= impulse;
    bodies[as_index(joint.b)].l += impulse;
    joint.torque_sum += impulse;
}

void DirectGroup::switch_off(DirectJoint& joint, int row, bool off) {
    if (joint.off[as_index(row)] == off) return;
    joint.off[as_index(row)] = off;
    factored_ = false;
}

// The two rows of one angle cannot both hold. A motor that drives into a limit presses on it with
// all it has; one that drives away from it, or holds, is as good without the limit.
void DirectGroup::choose_motor_or_limit(DirectJoint& joint) {
    if (!joint.has_motor || joint.at_limit == 0 || joint.at_most != 0) return;
    if (joint.speed * joint.at_limit < 0) {
        joint.at_most = joint.speed > 0 ? 1 : -1;
        joint.force[joint.motor_row()] = joint.at_most * 0.5 * joint.most_torque;
        switch_off(joint, joint.motor_row(), true);
    } else {
        joint.at_limit = 0;
        joint.force[joint.limit_row()] = 0;
        switch_off(joint, joint.limit_row(), true);
    }
}

// As the step begins: what was on its limit or at its most still is, but for a motor that may reach
// its speed within the step.
void DirectGroup::set_bounds(double h) {
    if (smooth_) return;
    for (DirectJoint& joint : joints) {
        if (joint.has_limit) switch_off(joint, joint.limit_row(), joint.at_limit == 0);
        if (!joint.has_motor) continue;
        if (joint.at_most != 0) {
            const DirectBody &a = bodies[as_index(joint.a)], &b = bodies[as_index(joint.b)];
            const Vec3 axis = a.axes * joint.axis_a;
            const double missing = joint.at_most * (joint.speed - dot(axis, spin(b) - spin(a)));
            const double gained =
                dot(axis, (a.inverse_inertia + b.inverse_inertia) * axis) * joint.most_torque * h;
            if (missing <= gained) joint.at_most = 0;
        }
        switch_off(joint, joint.motor_row(), joint.at_most != 0);
        choose_motor_or_limit(joint);
    }
}

// A limit does not pull, and a motor gives no more than its most: what would is switched off.
// `value`: forces or impulses, of which `most` is the motor's most. True if something changed: then
// solve again.
bool DirectGroup::keep_bounds(DirectJoint& joint, double* value, double most) {
    bool changed = false;
    if (joint.has_limit && joint.at_limit != 0 && value[joint.limit_row()] * joint.at_limit < 0) {
        joint.at_limit = 0;
        joint.force[joint.limit_row()] = 0;
        switch_off(joint, joint.limit_row(), true);
        changed = true;
    }
    if (joint.has_motor && joint.at_most == 0 && absolute(value[joint.motor_row()]) > most) {
        joint.at_most = value[joint.motor_row()] > 0 ? 1 : -1;
        joint.force[joint.motor_row()] = joint.at_most * 0.5 * joint.most_torque;
        switch_off(joint, joint.motor_row(), true);
        changed = true;
    }
    return changed;
}

// Limits that the step would leave behind hold.
bool DirectGroup::reach_limits(double motor_time) {
    bool changed = false;
    for (DirectJoint& joint : joints) {
        if (!joint.has_limit || joint.at_limit != 0) continue;
        const double angle =
            trial_angle(joint, bodies[as_index(joint.a)], bodies[as_index(joint.b)]);
        joint.at_limit = angle < joint.lower ? 1 : (angle > joint.upper ? -1 : 0);
        if (joint.at_limit == 0) continue;
        switch_off(joint, joint.limit_row(), false);
        const int at_most = joint.at_most;
        choose_motor_or_limit(joint);
        if (joint.at_most != at_most) give_most(joint, motor_time);
        changed = true;
    }
    return changed;
}

}  // namespace jostle::physics
