// SPDX-License-Identifier: MIT
//
// What acts along the ways that joints leave free: limits, motors and friction by an active set,
// and springs with their damping.
#include "physics/src/constraints/direct/direct_group.h"
#include "physics/src/constraints/softness.h"
#include "physics/src/foundation/tuning.h"

namespace jostle::physics {
// Along a way, whether its row is on or not.
void DirectGroup::give(DirectJoint& joint, const FreeAxis& way, double impulse) {
    DirectBody &a = bodies[as_index(joint.a)], &b = bodies[as_index(joint.b)];
    const Vec3 linear = way.linear * impulse, about_b = way.angular_b * impulse;
    a.p -= linear;
    a.l += way.angular_a * impulse;
    b.p += linear;
    b.l += about_b;
    joint.force_sum += linear;
    if (!way.is_linear()) joint.torque_sum += about_b;
}

// ---- springs ----

// By the two bodies' own masses at the state. Half of the damping acts at the step's velocity
// before it, half at that after it: the trapezoidal rule, with the rate at which two bodies alone
// lose exactly what they should.
void DirectGroup::set_springs() {
    for (DirectJoint& joint : joints)
        for (FreeAxis& way : joint.ways) {
            if (way.rate == 0) continue;
            const double response =
                response_of(way, bodies[as_index(joint.a)], bodies[as_index(joint.b)]);
            // Along what is locked it pushes nobody.
            const double mass = response > FreeAxis::least_response ? 1 / response : 0;
            way.stiffness = way.rate * way.rate * mass;
            if (way.damping_ratio == 0) continue;
            const double left = decay(2 * way.damping_ratio * way.rate * step_);
            way.damper = (1 - left) / (1 + left) * mass;
        }
}

// The half before the step.
void DirectGroup::damp_springs() {
    const auto each = [&](const auto& call) {
        for (DirectJoint& joint : joints)
            for (std::size_t k = 0; k < joint.ways.size(); k++) {
                FreeAxis& way = joint.ways[k];
                if (!way.is_damped() || way.at_limit != 0 || way.is_held()) continue;
                call(joint, way, joint.impulse[as_index(joint.first_way()) + k]);
            }
    };
    each([&](DirectJoint& joint, FreeAxis& way, double& speed) {
        speed = rate_of(way, bodies[as_index(joint.a)], bodies[as_index(joint.b)]);
    });
    each([&](DirectJoint& joint, FreeAxis& way, double& speed) {
        give(joint, way, -way.damper * speed);
        speed = 0;
    });
}

// To what a kick of h follows.
void DirectGroup::soften_springs(double h) {
    for (DirectJoint& joint : joints)
        for (FreeAxis& way : joint.ways) {
            const double turn = way.rate * h;
            if (turn > 0.5) way.stiffness *= 0.25 / (turn * turn);
        }
}

// ---- limits, motors and friction ----

// On or off, as the way says.
void DirectGroup::set_row(DirectJoint& joint, int row) {
    FreeAxis& way = joint.ways[as_index(row - joint.first_way())];
    const bool bound = way.at_limit != 0 || way.is_held();
    way.implicit = energy_ && way.rate > 0 && !bound;
    const bool off = !bound && !way.implicit && !way.is_damped();
    if (!bound) joint.force[row] = 0;
    if (joint.off[as_index(row)] == off && way.bound == bound) return;
    joint.off[as_index(row)] = off;
    joint.blocked[as_index(row)] = false;
    way.bound = bound;
    factored_ = false;
}

// As the step begins: what was on its limit still is; what is pushed between two steps of its grip
// and may reach the next one is held there.
void DirectGroup::set_bounds(double h) {
    if (damped_springs_ && step_ != h) factored_ = false;
    step_ = h;
    if (smooth_ && !sprung_) return;
    for (DirectJoint& joint : joints) {
        for (int row = joint.first_way(); row < joint.rows(); row++) {
            FreeAxis& way = joint.ways[as_index(row - joint.first_way())];
            if (way.at_limit == 0 && way.grip >= 0 && !way.is_held()) {
                const DirectBody &a = bodies[as_index(joint.a)], &b = bodies[as_index(joint.b)];
                const double speed = rate_of(way, a, b), push = way.push();
                const double gained = response_of(way, a, b) * way.push_between(0) * h;
                const int p = way.grip / 2;
                if (p < way.steps && way.speeds[p] - speed <= gained)
                    way.grip = 2 * p + 1;
                else if (p > 0 && speed - way.speeds[p - 1] <= gained)
                    way.grip = 2 * p - 1;
                if (way.is_held()) joint.force[row] = 0.5 * push;
            }
            if (way.at_limit != 0 && way.is_held()) grip_on_limit(way);
            set_row(joint, row);
        }
    }
}

// A limit does not pull, and what holds at a speed gives no more than its most. `value`: forces or
// impulses, of which a unit force makes `scale`. What is no longer held pushes for `time`. True if
// something changed: then solve again.
bool DirectGroup::enforce_bounds(DirectJoint& joint, const double* value, double scale, double time,
                              bool at_velocities) {
    bool changed = false;
    for (int row = joint.first_way(); row < joint.rows(); row++) {
        FreeAxis& way = joint.ways[as_index(row - joint.first_way())];
        if (way.at_limit != 0) {
            if (value[row] * way.at_limit >= 0) continue;
            if (at_velocities && way.overrun) {
                joint.force[row] = 0;
                continue;
            }
            way.at_limit = 0;
            joint.target[row] = 0;
            if (way.steps > 0 && way.grip == FreeAxis::at_rest) load_grip(way, 0);
        } else if (way.is_held()) {
            const int p = way.grip / 2;
            if (value[row] > scale * way.push_between(p))
                way.grip = 2 * p;
            else if (value[row] < scale * way.push_between(p + 1))
                way.grip = 2 * p + 2;
            else
                continue;
            if (time != 0) give(joint, way, time * way.push());
        } else {
            continue;
        }
        set_row(joint, row);
        changed = true;
    }
    return changed;
}

// Limits that the step would leave behind hold.
bool DirectGroup::reach_limits(double h, double time) {
    bool changed = false;
    const double most = tuning::joint_push_speed * absolute(h);
    const double most_turn = tuning::joint_push_spin * absolute(h);
    for (DirectJoint& joint : joints) {
        for (int row = joint.first_way(); row < joint.rows(); row++) {
            FreeAxis& way = joint.ways[as_index(row - joint.first_way())];
            if (!way.has_limit() || way.at_limit != 0) continue;
            const double value =
                trial_value(joint, way, bodies[as_index(joint.a)], bodies[as_index(joint.b)]);
            way.at_limit = value < way.lower ? 1 : (value > way.upper ? -1 : 0);
            if (way.at_limit == 0) continue;
            const double excess = bounded_excess(way, way.is_linear() ? most : most_turn);
            const double beyond = value - (way.at_limit > 0 ? way.lower : way.upper) - excess;
            if (beyond * way.at_limit >= 0) {  // comes back faster by itself
                way.at_limit = 0;
                continue;
            }
            const int before = way.grip;
            grip_on_limit(way);
            if (way.at_limit == 0) continue;
            joint.target[row] = excess;
            way.overrun = is_overrun(way);
            if (time != 0 && way.grip != before) give(joint, way, time * way.push());
            set_row(joint, row);
            changed = true;
        }
    }
    return changed;
}

bool DirectGroup::is_on_limit() const {
    for (const DirectJoint& joint : joints)
        for (const FreeAxis& way : joint.ways)
            if (way.at_limit != 0) return true;
    return false;
}

}  // namespace jostle::physics
