// SPDX-License-Identifier: MIT
//
// The energy-momentum step (energy_step.cpp) of a tree of ball joints.
#include "jostle/base/check.h"
#include "physics/src/constraints/direct/ball_tree.h"
#include "physics/src/constraints/direct/free_turn.h"

namespace jostle::physics {
namespace {

constexpr int max_energy_rounds = 16;
// The matrix is rebuilt if a correction other than the first leaves more than this fraction of the
// error. The first one leaves an error of second order.
constexpr double slow_correction = 0.35;
// The share of the first error that may remain. That error is about as large as the error of the
// step itself, as in W. E. Milne's device ("Numerical solution of differential equations", 1953),
// but at most `left_most` metres in a group of links of 0.5 m.
constexpr double left_share = 0.1, left_most = 1e-4;

}  // namespace

void BallTree::begin_energy_step(double h) {
    for (Body& body : bodies_) {
        const Mat3 axes = to_matrix(body.q);
        if (damped_) damp(body, 0.5 * h);
        body.v = body.p * body.inverse_mass;
        body.w = body.inverse_inertia * body.l;
        body.inertia = symmetric_in_axes(axes, body.moments);
        body.sum = body.force * h;
        body.twist = body.torque * h;
    }
    for (Joint& joint : joints_) {
        joint.impulse = joint.force * (2 * h);
        Body &a = bodies_[as_index(joint.a)], &b = bodies_[as_index(joint.b)];
        a.sum -= joint.impulse;
        a.twist += cross(joint.impulse, joint.lever_a);
        b.sum += joint.impulse;
        b.twist += cross(joint.lever_b, joint.impulse);
    }
    for (Body& body : bodies_)
        body.mean_w =
            body.w + body.inverse_inertia * (body.twist - cross(body.w, body.l) * h) * 0.5;
}

// Computes the state that the unknowns lead to and returns its error, m.
double BallTree::residual_of(double h, bool stiffness_too) {
    for (Body& body : bodies_) {
        const Vec3 t = body.mean_w * (0.5 * h);
        const double s = 1 / square_root(1 + dot(t, t));
        body.q1 = Quat{s * t.x, s * t.y, s * t.z, s} * body.q;
        body.axes1 = to_matrix(body.q1);
        body.x1 = body.x + (body.v + body.sum * (0.5 * body.inverse_mass)) * h;
        body.twist = body.torque * h;
        if (stiffness_too) body.stiffness = {};
    }
    double apart = 0;
    for (Joint& joint : joints_) {
        apart = measure(joint, apart);
        Body &a = bodies_[as_index(joint.a)], &b = bodies_[as_index(joint.b)];
        // To the middle of the mean gap that closes by the end: the gap of the attempt would change
        // the torque by a product of two unknowns, and Newton's method would need another round.
        const Vec3 half = ((b.x + joint.at_b) - (a.x + joint.at_a)) * 0.25;
        joint.lever_a = (joint.at_a + joint.end_a) * 0.5 + half;
        joint.lever_b = (joint.at_b + joint.end_b) * 0.5 - half;
        a.twist += cross(joint.impulse, joint.lever_a);
        b.twist += cross(joint.lever_b, joint.impulse);
        if (stiffness_too) add_stiffness(joint, joint.impulse, joint.end_a, joint.end_b);
    }
    double largest = 0;
    for (Body& body : bodies_) {
        const Vec3 momentum = body.inertia * body.mean_w;
        body.residual = (momentum - body.inertia * body.w) * 2 + cross(body.mean_w, momentum) * h -
                        body.twist + cross(body.mean_w, body.twist) * (0.5 * h);
        const double size =
            absolute(dot(body.residual, body.inverse_inertia * body.residual)) * body.inverse_mass;
        largest = size <= largest ? largest : size;  // propagates NaN
    }
    largest = square_root(largest) * h;
    return apart <= largest ? largest : apart;
}

void BallTree::correct(System& system, double h, bool again) {
    if (again) {
        for (Body& body : bodies_)
            if (body.inverse_mass == 0) body.response = {};
            // Under compression the matrix may be indefinite. The stiffness is then omitted.
            else if (!invert(body.inertia * 2 + body.stiffness * (0.5 * h), body.response))
                body.response = body.inverse_inertia * 0.5;
        assemble(system, 0.5, &Body::response);
        factored_ = false;
    }
    for (Body& body : bodies_) {
        body.spin_correction = -(body.response * body.residual);
        body.residual = -body.residual;
    }
    const double rate = -1 / h;
    for (const Joint& joint : joints_) {
        const Body &a = bodies_[as_index(joint.a)], &b = bodies_[as_index(joint.b)];
        system.set(joint.row, joint.apart * rate - (cross(joint.lever_a, a.spin_correction) +
                                                    cross(b.spin_correction, joint.lever_b)));
    }
    solve(system);
    for (Joint& joint : joints_) {
        const Vec3 more = system.get(joint.row);
        Body &a = bodies_[as_index(joint.a)], &b = bodies_[as_index(joint.b)];
        joint.impulse += more;
        a.sum -= more;
        a.residual += cross(more, joint.lever_a);
        b.sum += more;
        b.residual += cross(joint.lever_b, more);
    }
    for (Body& body : bodies_) body.mean_w += body.response * body.residual;
}

bool BallTree::step_energy(System& system, double h, double tolerance, double reach) {
    count_.energy_steps++;
    begin_energy_step(h);
    double last_error = 1e300, enough = tolerance;
    bool slow = false;
    for (int round = 0;; round++) {
        const double error = residual_of(h, round == 0 || slow);
        if (round == 0)
            enough =
                maximum(tolerance, minimum(left_share * error, left_most * minimum(1, 2 * reach)));
        if (error < enough) break;
        if (round == max_energy_rounds || !(error < 1e6)) {
            if (!(error < accepted_errors * tolerance)) return false;
            break;
        }
        slow = round > 0 && error > slow_correction * last_error;
        last_error = error;
        correct(system, h, round == 0 || (slow && round > 1));
    }
    // Angular momentum is conserved exactly if both bodies receive the force at one point.
    for (const Joint& joint : joints_) {
        const Vec3 missed = cross(joint.impulse, joint.apart) * 0.25;
        bodies_[as_index(joint.a)].twist += missed;
        bodies_[as_index(joint.b)].twist += missed;
    }
    for (Body& body : bodies_) {
        body.p += body.sum;
        body.l += body.twist;
        body.q1 = nearly_unit(body.q1);
        commit(body);
        if (damped_) damp(body, 0.5 * h);
        body.v = body.p * body.inverse_mass;
        body.w = body.inverse_inertia * body.l;
    }
    project_velocities(system, h, Forces::of_step, true);
    return true;
}

}  // namespace jostle::physics
