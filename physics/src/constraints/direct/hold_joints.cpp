// SPDX-License-Identifier: MIT
//
// The drift of RATTLE for bodies that a contact solver moves: it changes their momenta so that they
// end a sub-step where all joints hold and no limit is exceeded. Impulses act along the rows at the
// start, like those of RATTLE, so that they conserve momentum.
#include <algorithm>

#include "jostle/base/check.h"
#include "physics/src/constraints/direct/direct_group.h"

namespace jostle::physics {
namespace {

// Rounds in which limits are reached or left. Those of a limb reach the next limb.
constexpr int hold_rounds = 12;

}  // namespace

bool DirectGroup::exceeds_limits(double tolerance) const {
    for (const DirectJoint& joint : joints)
        for (const FreeAxis& free_axis : joint.free_axes) {
            if (!free_axis.has_limit()) continue;
            const double value = trial_value(joint, free_axis, bodies);
            if (value < free_axis.lower - tolerance || value > free_axis.upper + tolerance)
                return true;
        }
    return false;
}

double DirectGroup::joint_error() {
    double largest = 0;
    for (DirectJoint& joint : joints) {
        write_vectors(joint, bodies);
        measure_start(joint, bodies);
        for (int k = 0; k < joint.first_free_axis(); k++)
            largest = maximum(largest, absolute(joint.start[k]) * (k < joint.points ? 1 : reach_));
        for (const FreeAxis& axis : joint.free_axes) {
            const double beyond = maximum(axis.lower - axis.start, axis.start - axis.upper);
            if (axis.has_limit())
                largest = maximum(largest, beyond * (axis.is_linear() ? 1 : reach_));
        }
    }
    return largest;
}

void DirectGroup::release_all() {
    for (DirectJoint& joint : joints) {
        std::fill(std::begin(joint.force), std::end(joint.force), 0.0);
        std::fill(std::begin(joint.impulse), std::end(joint.impulse), 0.0);
        std::fill(std::begin(joint.target), std::end(joint.target), 0.0);
        for (FreeAxis& free_axis : joint.free_axes) free_axis.at_limit = 0;
        for (int row = joint.first_free_axis(); row < joint.rows(); row++) set_row(joint, row);
    }
}

bool DirectGroup::hold_joints(double h, const HoldTolerance& tolerance) {
    straight_ = true;
    step_ = h;
    factored_ = false;
    release_all();
    drift_all(h);
    if (measure_all(h) < tolerance.gap && !exceeds_limits(tolerance.angle)) return false;
    set_targets(h);
    previous_guess_.clear();
    for (const DirectBody& body : bodies)
        previous_guess_.push_back(body.p), previous_guess_.push_back(body.l);
    const auto start_over = [&] {
        for (std::size_t k = 0; k < bodies.size(); k++)
            bodies[k].p = previous_guess_[2 * k], bodies[k].l = previous_guess_[2 * k + 1];
    };
    bool holds = true;
    reach_limits(h, 0);
    for (int round = 0; holds; round++) {
        factor_here();
        holds = solve_positions(h, tolerance.left);
        if (!holds || round == hold_rounds) break;
        bool changed = reach_limits(h, 0);
        for (DirectJoint& joint : joints)
            if (enforce_bounds(joint, joint.impulse, h, 0)) changed = true;
        if (!changed) break;
        for (DirectJoint& joint : joints)
            std::fill(std::begin(joint.impulse), std::end(joint.impulse), 0.0);
        start_over();
    }
    if (!holds) start_over();
    for (DirectJoint& joint : joints)
        if (holds) record(joint, joint.impulse);
    return holds;
}

}  // namespace jostle::physics
