// SPDX-License-Identifier: MIT
#include "physics/src/constraints/direct/joint_tree.h"

#include <algorithm>
#include <utility>

#include "jostle/base/check.h"
#include "physics/src/constraints/direct/free_turn.h"
#include "physics/src/constraints/direct/step_tolerances.h"
#include "physics/src/constraints/free_motion.h"
#include "physics/src/foundation/tuning.h"

namespace jostle::physics {
namespace {

constexpr int max_drift_rounds = 8;

double largest_component(Vec3 v) {
    const Vec3 size = abs(v);
    const double xy = size.x <= size.y ? size.y : size.x;  // propagates NaN
    return xy <= size.z ? size.z : xy;
}

}  // namespace

void JointTree::load(std::span<const DirectBody> bodies, std::span<const DirectJoint> joints,
                     const BlockLdl& matrix) {
    bodies_.resize(bodies.size());
    joints_.resize(joints.size());
    hinges_.clear();
    axes_.clear();
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
        ASSERT(from.is_ball_alone() || from.is_plain_hinge());
        joints_[k] = {.a = from.a,
                      .b = from.b,
                      .row = matrix.row_of(static_cast<int>(k)),
                      .hinge = from.is_ball_alone() ? -1 : static_cast<int>(hinges_.size()),
                      .arm_a = from.arm_a,
                      .arm_b = from.arm_b,
                      .force = {from.force[0], from.force[1], from.force[2]},
                      .force_sum = from.force_sum};
        if (!from.is_ball_alone()) load_hinge(from, static_cast<int>(k));
    }
    loaded_ = true;
    measured_ = factored_ = false;
}

void JointTree::load_hinge(const DirectJoint& from, int joint) {
    const bool acts = !from.free_axes.empty();
    hinges_.push_back({.axis = acts ? static_cast<int>(axes_.size()) : -1,
                       .count = acts ? 3 : 2,
                       .axis_a = from.turn_a[0],
                       .across_b = {from.turn_b[0], from.turn_b[1]},
                       .force = {from.force[3], from.force[4], acts ? from.force[5] : 0},
                       .torque_sum = from.torque_sum});
    if (acts) axes_.push_back({from.free_axes[0], joint, from.off[5], 0});
}

void JointTree::store(std::span<DirectBody> bodies, std::span<DirectJoint> joints) {
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
        if (joints_[k].hinge < 0) continue;
        const Hinge& hinge = hinges_[as_index(joints_[k].hinge)];
        for (int row = 0; row < hinge.count; row++) joints[k].force[3 + row] = hinge.force[row];
        joints[k].torque_sum = hinge.torque_sum;
        if (hinge.axis < 0) continue;
        FreeAxis& to = joints[k].free_axes[0];
        to = axes_[as_index(hinge.axis)].free;
        to.angular_a = -hinge.at_axis;
        to.angular_b = hinge.at_axis;
        joints[k].off[5] = axes_[as_index(hinge.axis)].off;
    }
    loaded_ = false;
}

void JointTree::save() {
    saved_.resize(bodies_.size());
    saved_joints_.resize(joints_.size());
    for (std::size_t k = 0; k < bodies_.size(); k++)
        saved_[k] = {bodies_[k].x, bodies_[k].p, bodies_[k].l, bodies_[k].q};
    for (std::size_t k = 0; k < joints_.size(); k++)
        saved_joints_[k] = {joints_[k].force, joints_[k].force_sum};
    saved_hinges_.clear();
    for (const Hinge& hinge : hinges_)
        saved_hinges_.push_back(
            {{hinge.force[0], hinge.force[1], hinge.force[2]}, hinge.torque_sum});
    saved_axes_.clear();
    for (const Axis& axis : axes_) saved_axes_.push_back({axis.free.at_limit, axis.free.actuation});
}

void JointTree::restore() {
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
    for (std::size_t k = 0; k < hinges_.size(); k++) {
        for (int row = 0; row < 3; row++) hinges_[k].force[row] = saved_hinges_[k].force[row];
        hinges_[k].torque_sum = saved_hinges_[k].torque_sum;
    }
    for (std::size_t k = 0; k < axes_.size(); k++) {
        axes_[k].free.at_limit = saved_axes_[k].at_limit;
        axes_[k].free.actuation = saved_axes_[k].actuation;
    }
    measure_state();
}

JointTree::Count JointTree::take_count() {
    return std::exchange(count_, {});
}

// ---- the state ----

// The geometric stiffness of the joint's force (energy_step.cpp) at the current arms.
void JointTree::add_stiffness(const Joint& joint, Vec3 force, Vec3 arm_a, Vec3 arm_b) {
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
void JointTree::measure_bodies() {
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
void JointTree::measure_state() {
    for (Body& body : bodies_) {
        body.axes1 = to_matrix(body.q);
        body.inverse_inertia = symmetric_in_axes(body.axes1, body.inverse_moments);
        body.stiffness = {};
    }
    gap_ = turned_ = 0;
    for (Joint& joint : joints_) {
        const Body &a = bodies_[as_index(joint.a)], &b = bodies_[as_index(joint.b)];
        joint.at_a = a.axes1 * joint.arm_a;
        joint.at_b = b.axes1 * joint.arm_b;
        joint.apart = (b.x + joint.at_b) - (a.x + joint.at_a);
        joint.lever_a = joint.at_a + joint.apart * 0.5;
        joint.lever_b = joint.at_b - joint.apart * 0.5;
        gap_ = maximum(gap_, length(joint.apart));
        add_stiffness(joint, joint.force * 2, joint.at_a, joint.at_b);
        if (joint.hinge < 0) continue;
        Hinge& hinge = hinges_[as_index(joint.hinge)];
        hinge.end_axis = a.axes1 * hinge.axis_a;
        for (int row = 0; row < 2; row++) {
            hinge.end_across[row] = b.axes1 * hinge.across_b[row];
            hinge.error[row] = dot(hinge.end_axis, hinge.end_across[row]);
        }
        commit(hinge);
    }
    gap_ = maximum(gap_, turned_ * reach_);
    measure_bodies();
    measured_ = true;
    factored_ = false;
}

// As DirectGroup::keeps_energy(): weights and tensions do work and bodies are displaced as gaps
// close.
bool JointTree::keeps_energy(const Books& before, double h, double tolerance, double gain,
                             double loss) const {
    if (!(absolute(books_.total) < 1e300)) return false;  // or NaN
    const double twist = (before.power + books_.power) * h;
    const double change = books_.total - before.total - twist;
    const double scale = maximum(before.kinetic, books_.kinetic) + absolute(twist) + h * h * push_;
    if (change <= gain * scale && change > -loss * scale) return true;
    double tension = 0;
    for (const Joint& joint : joints_) tension += 2 * length(joint.force);
    const double slack =
        work_of_gaps({maximum(2 * tolerance, maximum(start_gap_, angle_error() * reach_)),
                      tolerance, weight_, tension, mass_},
                     h);
    return change <= gain * scale + slack + maximum(0, work_of_axes()) &&
           change > -loss * scale - slack;
}

// ---- the matrix ----

JointTree::End JointTree::end_at(const Joint& joint, bool of_b) const {
    End end{.lever = of_b ? joint.lever_b : -joint.lever_a, .rows = 3};
    if (joint.hinge < 0) return end;
    const Hinge& hinge = hinges_[as_index(joint.hinge)];
    for (int row = 0; row < hinge.count; row++)
        end.turns[row] = of_b ? hinge.rows[row] : -hinge.rows[row];
    end.rows = 3 + hinge.count;
    return end;
}

// Adds the block of two joints of a body, or of one, which the body's response couples.
void JointTree::add_body_block(const SymmetricMat3& response, const End& later, const End& sooner,
                               double mass, double* block) {
    const Vec3 x{response.xx, response.xy, response.xz}, y{response.xy, response.yy, response.yz},
        z{response.xz, response.yz, response.zz};
    const Vec3 r = later.lever, s = sooner.lever;
    const int n = sooner.rows;
    const auto write = [&](Vec3 row, double* to) {
        to[0] += row.y * s.z - row.z * s.y;
        to[1] += row.z * s.x - row.x * s.z;
        to[2] += row.x * s.y - row.y * s.x;
        for (int k = 3; k < n; k++) to[k] += dot(row, sooner.turns[k - 3]);
    };
    write(y * r.z - z * r.y, block);
    write(z * r.x - x * r.z, block + n);
    write(x * r.y - y * r.x, block + 2 * n);
    for (int i = 0; i < 3; i++) block[i * (n + 1)] += mass;
    for (int row = 3; row < later.rows; row++)
        write(response * later.turns[row - 3], block + row * n);
}

void JointTree::assemble(System& system, double linear, SymmetricMat3 Body::*response) {
    system.matrix.clear();
    double* const values = system.matrix.values().data();
    for (const JointSystemBlock& c : system.blocks) {
        const Joint &later = joints_[as_index(c.later)], &sooner = joints_[as_index(c.sooner)];
        const Body& body = bodies_[as_index(c.body)];
        const double mass = body.inverse_mass * linear;
        add_body_block(body.*response, end_at(later, c.later_b), end_at(sooner, c.sooner_b),
                       c.later_b == c.sooner_b ? mass : -mass, values + c.at);
    }
    assemble_hubs(system, linear, response);
    system.matrix.factor();
    count_.factors++;
}

// See DirectGroup::assemble_hubs().
void JointTree::assemble_hubs(System& system, double linear, SymmetricMat3 Body::*response) {
    double* const values = system.matrix.values().data();
    for (const JointHub& hub : system.hubs.hubs) {
        const Body& body = bodies_[as_index(hub.body)];
        double* const block = values + hub.at;
        const Mat3 inertia = inverse(to_mat3(body.*response));
        const Vec3 columns[] = {inertia.x, inertia.y, inertia.z};
        for (int i = 0; i < 3; i++) {
            block[i * hub_rows + i] = -body.mass / linear;
            for (int k = 0; k < 3; k++) block[(i + 3) * hub_rows + k + 3] = -columns[k][i];
        }
    }
    for (const JointHubBlock& coupling : system.hubs.blocks) {
        const End end = end_at(joints_[as_index(coupling.joint)], coupling.body_b);
        double* const block = values + coupling.at;
        const Vec3 r = end.lever;
        const Vec3 angular[] = {{0, r.z, -r.y}, {-r.z, 0, r.x}, {r.y, -r.x, 0},
                                end.turns[0],   end.turns[1],   end.turns[2]};
        const int across = coupling.hub_later ? end.rows : 1,
                  along = coupling.hub_later ? 1 : hub_rows;
        for (int row = 0; row < end.rows; row++) {
            double* const at = block + row * along;
            if (row < 3) at[row * across] = coupling.body_b ? 1 : -1;
            for (int k = 0; k < 3; k++) at[(k + 3) * across] = angular[row][k];
        }
    }
}

void JointTree::factor_here(System& system) {
    if (!factored_) assemble(system, 1, &Body::inverse_inertia);
    factored_ = true;
}

void JointTree::solve(System& system) {
    for (const JointHub& hub : system.hubs.hubs) {
        double* const rows = &system.unknowns[as_index(system.matrix.row_of(hub.node))];
        std::fill(rows, rows + hub_rows, 0.0);
    }
    system.matrix.solve(system.unknowns);
    count_.solves++;
}

// ---- RATTLE (rattle_step.cpp) ----

void JointTree::damp(Body& body, double time) {
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

void JointTree::push(const Joint& joint, Vec3 impulse) {
    Body &a = bodies_[as_index(joint.a)], &b = bodies_[as_index(joint.b)];
    a.p -= impulse;
    a.l += cross(impulse, joint.lever_a);
    b.p += impulse;
    b.l += cross(joint.lever_b, impulse);
}

void JointTree::push_turns(const Joint& joint, const double* impulse) {
    const Hinge& hinge = hinges_[as_index(joint.hinge)];
    const Vec3 turn = torque_of(hinge, impulse);
    bodies_[as_index(joint.a)].l -= turn;
    bodies_[as_index(joint.b)].l += turn;
}

// Drifts from the current momenta and returns the largest joint error, m.
double JointTree::drift(double h) {
    for (Body& body : bodies_) {
        if (body.inverse_mass == 0) continue;
        body.x1 = body.x + body.p * (body.inverse_mass * h);
        body.q1 = free_turn(body.q, body.l, body.inverse_moments, h);
        body.axes1 = to_matrix(body.q1);
    }
    double largest = 0;
    for (Joint& joint : joints_) largest = measure(joint, largest, h);
    return largest;
}

// The end of the attempt. Returns the larger one of `largest` and the joint's error, m.
double JointTree::measure(Joint& joint, double largest, double h) {
    const Body &a = bodies_[as_index(joint.a)], &b = bodies_[as_index(joint.b)];
    joint.end_a = a.axes1 * joint.arm_a;
    joint.end_b = b.axes1 * joint.arm_b;
    joint.apart = (b.x1 + joint.end_b) - (a.x1 + joint.end_a);
    const double size = largest_component(joint.apart);
    largest = size <= largest ? largest : size;  // propagates NaN
    return joint.hinge < 0 ? largest : measure_turns(joint, largest, h);
}

double JointTree::measure_turns(const Joint& joint, double largest, double h) {
    Hinge& hinge = hinges_[as_index(joint.hinge)];
    hinge.end_axis = bodies_[as_index(joint.a)].axes1 * hinge.axis_a;
    for (int row = 0; row < 2; row++) {
        hinge.end_across[row] = bodies_[as_index(joint.b)].axes1 * hinge.across_b[row];
        hinge.error[row] = dot(hinge.end_axis, hinge.end_across[row]);
        const double size = absolute(hinge.error[row]) * reach_;
        largest = size <= largest ? largest : size;
    }
    if (hinge.axis >= 0) {
        hinge.error[2] = axis_error(axes_[as_index(hinge.axis)], h);
        const double size = absolute(hinge.error[2]) * reach_;
        largest = size <= largest ? largest : size;
    }
    return largest;
}

bool JointTree::solve_positions(System& system, double h, double tolerance) {
    for (Joint& joint : joints_) {
        joint.impulse = joint.force * h;
        push(joint, joint.impulse);
        if (joint.hinge < 0) continue;
        Hinge& hinge = hinges_[as_index(joint.hinge)];
        for (int row = 0; row < hinge.count; row++) hinge.impulse[row] = hinge.force[row] * h;
        if (hinge.axis >= 0 && axes_[as_index(hinge.axis)].off) hinge.impulse[2] = 0;
        push_turns(joint, hinge.impulse);
    }
    double last_error = 1e300, first = 0;
    for (int round = 0;; round++) {
        const double error = drift(h);
        if (error < tolerance) return true;
        if (round == 0) first = error;
        if (round == max_drift_rounds || !(error < 4 * last_error))
            return error < accepted_errors * tolerance ||
                   (!axes_.empty() && error <= first &&
                    error_of_holding() < accepted_errors * tolerance);
        last_error = error;
        const double rate = -1 / h;
        for (const Joint& joint : joints_) {
            system.set(joint.row, joint.apart * rate);
            if (joint.hinge < 0) continue;
            const Hinge& hinge = hinges_[as_index(joint.hinge)];
            double* const turns = system.turns(joint.row);
            for (int row = 0; row < hinge.count; row++) turns[row] = hinge.error[row] * rate;
        }
        solve(system);
        for (Joint& joint : joints_) {
            const Vec3 more = system.get(joint.row);
            push(joint, more);
            joint.impulse += more;
            if (joint.hinge < 0) continue;
            Hinge& hinge = hinges_[as_index(joint.hinge)];
            const double* const turns = system.turns(joint.row);
            push_turns(joint, turns);
            for (int row = 0; row < hinge.count; row++) hinge.impulse[row] += turns[row];
        }
    }
}

bool JointTree::step_rattle(System& system, double h, double tolerance, bool last) {
    count_.rattle_steps++;
    if (!axes_.empty()) set_bounds(h);
    factor_here(system);
    for (Body& body : bodies_) kick(body, h);
    if (!axes_.empty()) {
        push_axes(0.5 * h);
        set_targets(h);
    }
    for (int round = 0;; round++) {
        if (!solve_positions(system, h, tolerance)) return false;
        if (axes_.empty() || round == bound_rounds || !change_bounds(h)) break;
        factor_here(system);
    }
    for (Body& body : bodies_) {
        commit(body);
        kick(body, h);
        body.v = body.p * body.inverse_mass;
        body.w = body.inverse_inertia * body.l;
    }
    if (!axes_.empty()) {
        begin_commit();
        for (Joint& joint : joints_) commit(joint, h, Forces::of_projection);
        end_commit();
        push_axes(0.5 * h);
        measure_spins();
    }
    project_velocities(system, h, Forces::of_projection, last);
    return true;
}

// Half a kick.
void JointTree::kick(Body& body, double h) {
    body.p += body.force * (0.5 * h);
    body.l += body.torque * (0.5 * h);
    if (damped_) damp(body, 0.5 * h);
}

void JointTree::measure_spins() {
    for (Body& body : bodies_) body.w = body.inverse_inertia * body.l;
}

// The state at the end of the attempt, which axes1 already belongs to.
void JointTree::commit(Body& body) {
    body.x = body.x1;
    body.q = body.q1;
    body.inverse_inertia = symmetric_in_axes(body.axes1, body.inverse_moments);
    body.stiffness = {};
}

void JointTree::commit(Hinge& hinge) {
    hinge.at_axis = hinge.end_axis;
    for (int row = 0; row < 2; row++) {
        hinge.at_across[row] = hinge.end_across[row];
        hinge.rows[row] = cross(hinge.at_across[row], hinge.at_axis);
        turned_ = maximum(turned_, absolute(hinge.error[row]));
    }
    if (hinge.axis < 0) return;
    Axis& axis = axes_[as_index(hinge.axis)];
    axis.free.value = angle_of(axis);
    hinge.rows[2] = axis.off ? Vec3{} : hinge.at_axis;
}

void JointTree::begin_commit() {
    gap_ = turned_ = 0;
    factored_ = false;
}

// Call after the commit of the bodies. Records the impulses of the step.
void JointTree::commit(Joint& joint, double h, Forces forces) {
    joint.force_sum += joint.impulse;
    if (forces == Forces::of_step) joint.force = joint.impulse * (0.5 / h);
    joint.at_a = joint.end_a;
    joint.at_b = joint.end_b;
    joint.lever_a = joint.at_a + joint.apart * 0.5;
    joint.lever_b = joint.at_b - joint.apart * 0.5;
    gap_ = maximum(gap_, length_squared(joint.apart));
    if (joint.hinge < 0) return;
    Hinge& hinge = hinges_[as_index(joint.hinge)];
    hinge.torque_sum += torque_of(hinge, hinge.impulse);
    if (forces == Forces::of_step)
        for (int row = 0; row < hinge.count; row++)
            hinge.force[row] = hinge.impulse[row] * (0.5 / h);
    commit(hinge);
}

void JointTree::end_commit() {
    gap_ = maximum(square_root(gap_), turned_ * reach_);
}

void JointTree::set_rate(const Joint& joint, System& system) {
    const Body &a = bodies_[as_index(joint.a)], &b = bodies_[as_index(joint.b)];
    const Vec3 rate = (a.v - b.v) - (cross(joint.lever_a, a.w) + cross(b.w, joint.lever_b));
    system.set(joint.row, rate);
    if (joint.hinge < 0) return;
    const Hinge& hinge = hinges_[as_index(joint.hinge)];
    double* const turns = system.turns(joint.row);
    for (int row = 0; row < hinge.count; row++) turns[row] = dot(hinge.rows[row], a.w - b.w);
    if (hinge.axis < 0) return;
    const FreeAxis& free = axes_[as_index(hinge.axis)].free;
    if (free.at_limit == 0 && free.is_held()) turns[2] += free.hold_speed();
}

// Call after the commit of the bodies, with their velocities, and after the commit of the joints if
// there are axes. Measures the state if this was the `last` one of its parts.
void JointTree::project_velocities(System& system, double h, Forces forces, bool last) {
    const double per_time = 1 / h;
    if (axes_.empty()) {
        begin_commit();
        for (Joint& joint : joints_) {
            commit(joint, h, forces);
            set_rate(joint, system);
        }
        end_commit();
    }
    for (int round = 0;; round++) {
        factor_here(system);
        for (const Joint& joint : joints_)
            if (!axes_.empty()) set_rate(joint, system);
        solve(system);
        if (axes_.empty()) break;
        set_axis_forces(system, h);
        if (round == bound_rounds || !enforce_at_velocities(h)) break;
    }
    for (Joint& joint : joints_) {
        const Vec3 impulse = system.get(joint.row);
        push(joint, impulse);
        joint.force_sum += impulse;
        if (forces == Forces::of_projection) joint.force = impulse * per_time;
        if (joint.hinge >= 0) {
            Hinge& hinge = hinges_[as_index(joint.hinge)];
            const double* const turns = system.turns(joint.row);
            push_turns(joint, turns);
            hinge.torque_sum += torque_of(hinge, turns);
            if (forces == Forces::of_projection)
                for (int row = 0; row < 2; row++) hinge.force[row] = turns[row] * per_time;
        }
        if (last) add_stiffness(joint, joint.force * 2, joint.at_a, joint.at_b);
    }
    if (last) measure_bodies();
}

// ---- a step ----

bool JointTree::step(double h, const Limits& limits, System system) {
    reach_ = limits.reach;
    if (!measured_) measure_state();
    start_gap_ = gap_;
    // Ends that are too far apart for this step approach in another way.
    if (start_gap_ > tuning::joint_push_speed * h || turned_ > 0.7 * tuning::joint_push_spin * h)
        return false;
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
    if (limits.coarse && axes_.empty() && step_energy(system, h, tolerance(h), limits) &&
        keeps_energy(before, h, tolerance(h), limits.energy_gain, any_loss))
        return true;
    restore();
    return false;
}

}  // namespace jostle::physics
