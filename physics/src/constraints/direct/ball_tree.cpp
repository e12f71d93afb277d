// SPDX-License-Identifier: MIT
#include "physics/src/constraints/direct/ball_tree.h"

#include <utility>

#include "jostle/base/check.h"
#include "physics/src/constraints/direct/free_turn.h"
#include "physics/src/constraints/direct/step_tolerances.h"
#include "physics/src/constraints/free_motion.h"
#include "physics/src/foundation/tuning.h"

namespace jostle::physics {
namespace {

constexpr int max_drift_rounds = 8;

// Adds the block of two joints of a body, or of one, which the body's response couples:
// [r]x^T response [s]x, and its mass.
void add_body_block(const SymmetricMat3& response, Vec3 r, Vec3 s, double mass, double* block) {
    const Vec3 x{response.xx, response.xy, response.xz}, y{response.xy, response.yy, response.yz},
        z{response.xz, response.yz, response.zz};
    const Vec3 rows[] = {y * r.z - z * r.y, z * r.x - x * r.z, x * r.y - y * r.x};
    for (int i = 0; i < 3; i++) {
        const Vec3 row = rows[i];
        block[3 * i] += row.y * s.z - row.z * s.y;
        block[3 * i + 1] += row.z * s.x - row.x * s.z;
        block[3 * i + 2] += row.x * s.y - row.y * s.x;
        block[4 * i] += mass;
    }
}

double largest_component(Vec3 v) {
    const Vec3 size = abs(v);
    const double xy = size.x <= size.y ? size.y : size.x;  // propagates NaN
    return xy <= size.z ? size.z : xy;
}

}  // namespace

void BallTree::load(std::span<const DirectBody> bodies, std::span<const DirectJoint> joints,
                    const BlockLdl& matrix) {
    bodies_.resize(bodies.size());
    joints_.resize(joints.size());
    push_ = weight_ = mass_ = 0;
    damped_ = false;
    for (std::size_t k = 0; k < bodies.size(); k++) {
        const DirectBody& from = bodies[k];
        Body& to = bodies_[k];
        to = {.mass = from.mass,
              .inverse_mass = from.inverse_mass,
              .moments = from.moments,
              .inverse_moments = from.inverse_moments,
              .force = from.force,
              .torque = from.torque,
              .linear_damping = from.linear_damping,
              .angular_damping = from.angular_damping,
              .x = from.x,
              .p = from.p,
              .l = from.l,
              .q = from.q};
        to.x1 = to.x;
        to.q1 = to.q;
        if (!from.pushed) continue;
        damped_ |= from.linear_damping != 0 || from.angular_damping != 0;
        push_ += length_squared(to.force) * to.inverse_mass;
        weight_ += length(to.force);
        mass_ += to.mass;
    }
    for (std::size_t k = 0; k < joints.size(); k++) {
        const DirectJoint& from = joints[k];
        ASSERT(from.is_ball_alone());
        joints_[k] = {.a = from.a,
                      .b = from.b,
                      .row = matrix.row_of(static_cast<int>(k)),
                      .arm_a = from.arm_a,
                      .arm_b = from.arm_b,
                      .force = {from.force[0], from.force[1], from.force[2]},
                      .force_sum = from.force_sum};
    }
    loaded_ = true;
    measured_ = factored_ = false;
}

void BallTree::store(std::span<DirectBody> bodies, std::span<DirectJoint> joints) {
    ASSERT(loaded_ && bodies.size() == bodies_.size() && joints.size() == joints_.size());
    for (std::size_t k = 0; k < bodies.size(); k++) {
        if (!bodies[k].pushed) continue;
        bodies[k].x = bodies_[k].x;
        bodies[k].p = bodies_[k].p;
        bodies[k].l = bodies_[k].l;
        bodies[k].q = bodies_[k].q;
        refresh(bodies[k]);
    }
    for (std::size_t k = 0; k < joints.size(); k++) {
        for (int row = 0; row < 3; row++) joints[k].force[row] = joints_[k].force[row];
        joints[k].force_sum = joints_[k].force_sum;
    }
    loaded_ = false;
}

void BallTree::save() {
    saved_.resize(bodies_.size());
    saved_joints_.resize(joints_.size());
    for (std::size_t k = 0; k < bodies_.size(); k++)
        saved_[k] = {bodies_[k].x, bodies_[k].p, bodies_[k].l, bodies_[k].q};
    for (std::size_t k = 0; k < joints_.size(); k++)
        saved_joints_[k] = {joints_[k].force, joints_[k].force_sum};
}

void BallTree::restore() {
    for (std::size_t k = 0; k < bodies_.size(); k++) {
        Body& body = bodies_[k];
        body.x = saved_[k].x;
        body.p = saved_[k].p;
        body.l = saved_[k].l;
        body.q = saved_[k].q;
    }
    for (std::size_t k = 0; k < joints_.size(); k++) {
        joints_[k].force = saved_joints_[k].force;
        joints_[k].force_sum = saved_joints_[k].force_sum;
    }
    measure_state();
}

BallTree::Count BallTree::take_count() {
    return std::exchange(count_, {});
}

// ---- the state ----

// The geometric stiffness of the joint's force (energy_step.cpp) at the current arms.
void BallTree::add_stiffness(const Joint& joint, Vec3 force, Vec3 arm_a, Vec3 arm_b) {
    const auto add = [](SymmetricMat3& k, Vec3 f, Vec3 arm) {
        const double along = dot(f, arm);
        const Vec3 half = f * 0.5;
        k.xx += along - arm.x * f.x;
        k.xy -= arm.y * half.x + arm.x * half.y;
        k.xz -= arm.z * half.x + arm.x * half.z;
        k.yy += along - arm.y * f.y;
        k.yz -= arm.z * half.y + arm.y * half.z;
        k.zz += along - arm.z * f.z;
    };
    add(bodies_[as_index(joint.a)].stiffness, -force, arm_a);
    add(bodies_[as_index(joint.b)].stiffness, force, arm_b);
}

// Energy, and half of the trace or of the norm of I^-1 K, as in DirectGroup::stiffest().
void BallTree::measure_bodies() {
    books_ = {};
    double trace = 0, norm = 0;
    for (const Body& body : bodies_) {
        if (body.inverse_mass == 0) continue;
        const Vec3 w = body.inverse_inertia * body.l;
        const double kinetic = 0.5 * (length_squared(body.p) * body.inverse_mass + dot(body.l, w));
        books_.kinetic += kinetic;
        books_.total += kinetic - dot(body.force, body.x);
        books_.power += 0.5 * dot(body.torque, w);
        const SymmetricMat3 &i = body.inverse_inertia, &k = body.stiffness;
        const Vec3 x = i * Vec3{k.xx, k.xy, k.xz}, y = i * Vec3{k.xy, k.yy, k.yz},
                   z = i * Vec3{k.xz, k.yz, k.zz};
        trace = maximum(trace, absolute(x.x + y.y + z.z));
        norm = maximum(norm, length_squared(x) + length_squared(y) + length_squared(z));
    }
    stiffest_ = square_root(maximum(trace * 0.5, square_root(norm * 0.5)));
}

// All that follows from positions, momenta and forces.
void BallTree::measure_state() {
    for (Body& body : bodies_) {
        body.axes1 = to_matrix(body.q);
        body.inverse_inertia = symmetric_in_axes(body.axes1, body.inverse_moments);
        body.stiffness = {};
    }
    gap_ = 0;
    for (Joint& joint : joints_) {
        const Body &a = bodies_[as_index(joint.a)], &b = bodies_[as_index(joint.b)];
        joint.at_a = a.axes1 * joint.arm_a;
        joint.at_b = b.axes1 * joint.arm_b;
        joint.apart = (b.x + joint.at_b) - (a.x + joint.at_a);
        joint.lever_a = joint.at_a + joint.apart * 0.5;
        joint.lever_b = joint.at_b - joint.apart * 0.5;
        gap_ = maximum(gap_, length(joint.apart));
        add_stiffness(joint, joint.force * 2, joint.at_a, joint.at_b);
    }
    measure_bodies();
    measured_ = true;
    factored_ = false;
}

// As DirectGroup::keeps_energy(): weights and tensions do work and bodies are displaced as gaps
// close.
bool BallTree::keeps_energy(const Books& before, double h, double tolerance, double gain,
                            double loss) const {
    if (!(absolute(books_.total) < 1e300)) return false;  // or NaN
    const double twist = (before.power + books_.power) * h;
    const double change = books_.total - before.total - twist;
    const double scale = maximum(before.kinetic, books_.kinetic) + absolute(twist) + h * h * push_;
    if (change <= gain * scale && change > -loss * scale) return true;
    double tension = 0;
    for (const Joint& joint : joints_) tension += 2 * length(joint.force);
    const double slack =
        work_of_gaps({maximum(2 * tolerance, start_gap_), tolerance, weight_, tension, mass_}, h);
    return change <= gain * scale + slack && change > -loss * scale - slack;
}

// ---- the matrix ----

void BallTree::assemble(System& system, double linear, SymmetricMat3 Body::*response) {
    system.matrix.clear();
    double* const values = system.matrix.values().data();
    for (const JointSystemBlock& c : system.blocks) {
        const Joint &later = joints_[as_index(c.later)], &sooner = joints_[as_index(c.sooner)];
        const Body& body = bodies_[as_index(c.body)];
        const double mass = body.inverse_mass * linear;
        add_body_block(body.*response, c.later_b ? later.lever_b : -later.lever_a,
                       c.sooner_b ? sooner.lever_b : -sooner.lever_a,
                       c.later_b == c.sooner_b ? mass : -mass, values + c.at);
    }
    system.matrix.factor();
    count_.factors++;
}

void BallTree::factor_here(System& system) {
    if (!factored_) assemble(system, 1, &Body::inverse_inertia);
    factored_ = true;
}

void BallTree::solve(System& system) {
    system.matrix.solve(system.unknowns);
    count_.solves++;
}

// ---- RATTLE (rattle_step.cpp) ----

void BallTree::damp(Body& body, double time) {
    const auto factor = [&](double damping) {
        if (damping != damping_ || time != damping_time_) {
            damping_ = damping;
            damping_time_ = time;
            damping_factor_ = damping_factor(damping, time);
        }
        return damping_factor_;
    };
    if (body.linear_damping != 0) body.p *= factor(body.linear_damping);
    if (body.angular_damping != 0) body.l *= factor(body.angular_damping);
}

void BallTree::push(const Joint& joint, Vec3 impulse) {
    Body &a = bodies_[as_index(joint.a)], &b = bodies_[as_index(joint.b)];
    a.p -= impulse;
    a.l += cross(impulse, joint.lever_a);
    b.p += impulse;
    b.l += cross(joint.lever_b, impulse);
}

// Drifts from the current momenta and returns the largest joint error, m.
double BallTree::drift(double h) {
    for (Body& body : bodies_) {
        if (body.inverse_mass == 0) continue;
        body.x1 = body.x + body.p * (body.inverse_mass * h);
        body.q1 = free_turn(body.q, body.l, body.inverse_moments, h);
        body.axes1 = to_matrix(body.q1);
    }
    double largest = 0;
    for (Joint& joint : joints_) largest = measure(joint, largest);
    return largest;
}

// The end of the attempt. Returns the larger one of `largest` and the joint's error, m.
double BallTree::measure(Joint& joint, double largest) {
    const Body &a = bodies_[as_index(joint.a)], &b = bodies_[as_index(joint.b)];
    joint.end_a = a.axes1 * joint.arm_a;
    joint.end_b = b.axes1 * joint.arm_b;
    joint.apart = (b.x1 + joint.end_b) - (a.x1 + joint.end_a);
    const double size = largest_component(joint.apart);
    return size <= largest ? largest : size;  // propagates NaN
}

bool BallTree::solve_positions(System& system, double h, double tolerance) {
    double last_error = 1e300;
    for (int round = 0;; round++) {
        const double error = drift(h);
        if (error < tolerance) return true;
        if (round == max_drift_rounds || !(error < 4 * last_error))
            return error < accepted_errors * tolerance;
        last_error = error;
        const double rate = -1 / h;
        for (const Joint& joint : joints_) system.set(joint.row, joint.apart * rate);
        solve(system);
        for (Joint& joint : joints_) {
            const Vec3 more = system.get(joint.row);
            push(joint, more);
            joint.impulse += more;
        }
    }
}

bool BallTree::step_rattle(System& system, double h, double tolerance, bool last) {
    count_.rattle_steps++;
    factor_here(system);
    for (Body& body : bodies_) {
        body.p += body.force * (0.5 * h);
        body.l += body.torque * (0.5 * h);
        if (damped_) damp(body, 0.5 * h);
    }
    for (Joint& joint : joints_) {
        joint.impulse = joint.force * h;
        push(joint, joint.impulse);
    }
    if (!solve_positions(system, h, tolerance)) return false;
    for (Body& body : bodies_) {
        commit(body);
        body.p += body.force * (0.5 * h);
        body.l += body.torque * (0.5 * h);
        if (damped_) damp(body, 0.5 * h);
        body.v = body.p * body.inverse_mass;
        body.w = body.inverse_inertia * body.l;
    }
    project_velocities(system, h, Forces::of_projection, last);
    return true;
}

// The state at the end of the attempt, which axes1 already belongs to.
void BallTree::commit(Body& body) {
    body.x = body.x1;
    body.q = body.q1;
    body.inverse_inertia = symmetric_in_axes(body.axes1, body.inverse_moments);
    body.stiffness = {};
}

// Call after the commit, with the velocities of the bodies. Records the impulses of the step, and
// measures the state if this was the `last` one of its parts.
void BallTree::project_velocities(System& system, double h, Forces forces, bool last) {
    const double per_time = 1 / h;
    gap_ = 0;
    for (Joint& joint : joints_) {
        const Body &a = bodies_[as_index(joint.a)], &b = bodies_[as_index(joint.b)];
        joint.force_sum += joint.impulse;
        if (forces == Forces::of_step) joint.force = joint.impulse * (0.5 * per_time);
        joint.at_a = joint.end_a;
        joint.at_b = joint.end_b;
        joint.lever_a = joint.at_a + joint.apart * 0.5;
        joint.lever_b = joint.at_b - joint.apart * 0.5;
        gap_ = maximum(gap_, length_squared(joint.apart));
        const Vec3 rate = (a.v - b.v) - (cross(joint.lever_a, a.w) + cross(b.w, joint.lever_b));
        system.set(joint.row, rate);
    }
    gap_ = square_root(gap_);
    factored_ = false;
    factor_here(system);
    solve(system);
    for (Joint& joint : joints_) {
        const Vec3 impulse = system.get(joint.row);
        push(joint, impulse);
        joint.force_sum += impulse;
        if (forces == Forces::of_projection) joint.force = impulse * per_time;
        if (last) add_stiffness(joint, joint.force * 2, joint.at_a, joint.at_b);
    }
    if (last) measure_bodies();
}

// ---- a step ----

bool BallTree::step(double h, const Limits& limits, System system) {
    if (!measured_) measure_state();
    start_gap_ = gap_;
    if (start_gap_ > tuning::joint_push_speed * h) return false;
    save();
    const Books before = books_;
    const auto tolerance = [&](double time) { return joint_tolerance(time, false, limits.reach); };
    constexpr double any_loss = 1e300;
    const double swing = stiffest_ * h;
    int parts = 1;
    while (parts < limits.parts && swing >= limits.swing * parts) parts *= 2;
    if (swing < limits.swing * parts) {
        int done = 0;
        while (done < parts &&
               step_rattle(system, h / parts, tolerance(h / parts), done + 1 == parts))
            done++;
        if (done == parts && keeps_energy(before, h, tolerance(h), limits.energy,
                                          limits.keeps_energy ? limits.energy : any_loss))
            return true;
        restore();
    }
    if (step_energy(system, h, tolerance(h), limits.reach) &&
        keeps_energy(before, h, tolerance(h), limits.energy_gain, any_loss))
        return true;
    restore();
    return false;
}

}  // namespace jostle::physics
