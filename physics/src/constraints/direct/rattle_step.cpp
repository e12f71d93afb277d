// SPDX-License-Identifier: MIT
//
// RATTLE: half a kick, a drift at whose end all joints hold, half a kick, projection of the
// velocities onto the joint constraints. The matrix at the start of the step is also used for the
// drift: one factorisation per step.
#include "jostle/base/check.h"
#include "physics/src/constraints/direct/direct_group.h"
#include "physics/src/constraints/direct/free_turn.h"

namespace jostle::physics {
namespace {

constexpr int max_position_corrections = 8;

void drift(DirectBody& body, double h, bool straight) {
    ASSERT(body.pushed || body.inverse_mass == 0);
    if (body.pushed && straight) {
        body.x1 = body.x + scaled(body.p, body.inverse_masses * h);
        body.q1 = nearly_unit(turn_by(body.turned + body.inverse_inertia * body.l * h) *
                              body.turned_from);
    } else if (body.pushed) {
        body.x1 = body.x + scaled(body.p, body.inverse_masses * h);
        body.q1 = free_turn(body.q, body.l, body.inverse_moments, h);
    } else {
        body.x1 = body.x + body.v * h;
        body.q1 = body.w == Vec3{} ? body.q : nearly_unit(turn_by(body.w * h) * body.q);
    }
    body.axes1 = to_matrix(body.q1);
}

}  // namespace

void DirectGroup::drift_all(double h) {
    for (DirectBody& body : bodies) drift(body, h, straight_);
}

// Drifts from the current momenta to a state in which the joints hold. Returns false if it does not
// converge.
bool DirectGroup::solve_positions(double h, double tolerance) {
    ASSERT(tolerance > 0 && factored_);
    for (DirectJoint& joint : joints) {
        for (int k = 0; k < joint.rows(); k++)
            joint.impulse[k] = joint.off[as_index(k)] ? 0 : h * joint.force[k];
        push(joint, joint.impulse);
    }
    double last_error = 1e300, first = 0;
    for (int round = 0;; round++) {
        drift_all(h);
        const double error = measure_all(h);
        if (error < tolerance) return true;
        if (round == 0) first = error;
        if (round == max_position_corrections || !(error < 4 * last_error))
            return error < 30 * tolerance ||
                   (!smooth_ && error <= first && error_of_holding() < 30 * tolerance);
        last_error = error;
        for (std::size_t k = 0; k < joints.size(); k++) {
            double* const to = right_side_.data() + matrix_.row_of(static_cast<int>(k));
            for (int r = 0; r < joints[k].rows(); r++) to[r] = -joints[k].error[r] / h;
        }
        solve();
        for (std::size_t k = 0; k < joints.size(); k++) {
            DirectJoint& joint = joints[k];
            double* const more = right_side_.data() + matrix_.row_of(static_cast<int>(k));
            // Dampers act at velocity level.
            if (damped_springs_)
                for (int r = joint.first_free_axis(); r < joint.rows(); r++)
                    if (!joint.free_axes[as_index(r - joint.first_free_axis())].bound) more[r] = 0;
            push(joint, more);
            for (int r = 0; r < joint.rows(); r++) joint.impulse[r] += more[r];
        }
    }
}

bool DirectGroup::step_rattle(double h, double tolerance) {
    count_.rattle_steps++;
    set_bounds(h);
    factor_here();
    if (damped_springs_) damp_springs();
    kick(h, false);
    set_targets(h);
    if (bounded_) {
        previous_guess_.clear();
        for (const DirectBody& body : bodies)
            previous_guess_.push_back(body.p), previous_guess_.push_back(body.l);
    }
    for (int round = 0;; round++) {
        if (!solve_positions(h, tolerance)) return false;
        if (!bounded_ || round == bound_rounds) break;
        for (std::size_t k = 0; k < bodies.size(); k++)
            bodies[k].p = previous_guess_[2 * k], bodies[k].l = previous_guess_[2 * k + 1];
        bool changed = reach_limits(h, 0.5 * h);
        for (DirectJoint& joint : joints)
            if (enforce_bounds(joint, joint.impulse, 0.5 * h, 0.5 * h)) changed = true;
        for (std::size_t k = 0; k < bodies.size(); k++)
            previous_guess_[2 * k] = bodies[k].p, previous_guess_[2 * k + 1] = bodies[k].l;
        if (!changed) {
            for (DirectJoint& joint : joints) push(joint, joint.impulse);
            break;
        }
        factor_here();
    }
    for (DirectJoint& joint : joints) record(joint, joint.impulse);
    commit();
    if (sprung_ || actuated_) factor_here();  // along the current free axes
    kick(h, true);
    project_velocities(h, 0);
    if (looped_) project_velocities(h, 0, false);  // what the compliance of the loop left over
    time_ += h;
    return true;
}

}  // namespace jostle::physics
