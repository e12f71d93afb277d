// SPDX-License-Identifier: MIT
//
// The energy-momentum step: arms are means over the step and a Cayley map rotates the bodies, so
// that joints do no work at any stiffness. Its unknowns are the mean spins and the impulses.
// Newton's method includes the change of the joint forces as the arms rotate (geometric stiffness:
// M. Tournier et al., "Stable constrained dynamics", 2015), which for point rows is a per-body
// term. At the end velocities are projected: energy that h cannot resolve, as in the crack of a
// whip, is lost, and none is gained.
#include "jostle/base/check.h"
#include "physics/src/constraints/direct/direct_group.h"
#include "physics/src/constraints/direct/free_turn.h"

namespace jostle::physics {
namespace {

constexpr int max_energy_corrections = 16;
// The matrix is rebuilt if a correction leaves more than this fraction of the error.
constexpr double slow_contraction = 0.35;
// The error of the first guess, the force of the previous step, is about the error of the step
// itself. A small part of it may remain, as in W. E. Milne's device ("Numerical solution of
// differential equations", 1953), but at most this many metres. Limits and actuation are decided by
// their impulses, which must be converged.
constexpr double small_part = 0.02, max_left = 5e-6;

double enough_of(double first, double tolerance) {
    return maximum(tolerance, minimum(max_left, small_part * first));
}

// Adds the geometric stiffness of a force at an arm: minus the derivative of its torque.
void stiffen(DirectBody& body, Vec3 force, Vec3 arm) {
    const double along = dot(force, arm);
    const Vec3 f = force * 0.5;
    Mat3& k = body.stiffness;
    k.x +=
        Vec3{along - 2 * arm.x * f.x, -(arm.y * f.x + arm.x * f.y), -(arm.z * f.x + arm.x * f.z)};
    k.y +=
        Vec3{-(arm.x * f.y + arm.y * f.x), along - 2 * arm.y * f.y, -(arm.z * f.y + arm.y * f.z)};
    k.z +=
        Vec3{-(arm.x * f.z + arm.z * f.x), -(arm.y * f.z + arm.z * f.y), along - 2 * arm.z * f.z};
}

// For a sliding end of b, the force acts on a at that end.
Vec3 lever_of(const DirectJoint& joint, Vec3 arm, Vec3 apart) {
    return joint.kind == DirectJoint::Points::across ? arm + apart : arm;
}

SymmetricMat3 upper_triangle(const Mat3& m) {
    return {m.x.x, m.x.y, m.x.z, m.y.y, m.y.z, m.z.z};
}

// The response of a body that rotates about one of its axes, or about none.
Mat3 response_about_one(const DirectBody& body, double h) {
    Vec3 axis;
    for (int k = 0; k < 3; k++)
        if (body.inverse_moments[k] != 0)
            axis = k == 0 ? body.axes.x : (k == 1 ? body.axes.y : body.axes.z);
    const double inertia = dot(axis, body.inertia * axis);
    ASSERT(inertia >= 0);
    const double stiff = 2 * inertia + 0.5 * h * dot(axis, body.stiffness * axis);
    const double spin_correction = inertia > 0 ? 1 / (stiff > 0 ? stiff : 2 * inertia) : 0;
    return {axis * (axis.x * spin_correction), axis * (axis.y * spin_correction),
            axis * (axis.z * spin_correction)};
}

}  // namespace

// Half of the trace or of the norm of I^-1 K bounds the squared oscillation rates of a body. Joints
// can only lower them (Rayleigh).
double DirectGroup::stiffest() {
    ASSERT(!joints.empty());
    for (DirectBody& body : bodies) body.stiffness = diagonal({0, 0, 0});
    double most = 0;
    for (const DirectJoint& joint : joints) {
        if (joint.is_gear()) {
            stiffen_gear(joint, joint.force[0] * 2);
            continue;
        }
        Vec3 pull = pull_of(joint, joint.force) * 2;
        DirectBody &a = bodies[as_index(joint.a)], &b = bodies[as_index(joint.b)];
        if (joint.path != nullptr)  // the force turns as b moves along the curve
            most =
                maximum(most, length(pull) * joint.curvature * (a.inverse_mass + b.inverse_mass));
        for (const FreeAxis& free_axis : joint.free_axes)
            if (free_axis.is_linear())
                pull += free_axis.linear *
                        (free_axis.push() -
                         free_axis.stiffness * stretch_of(free_axis, free_axis.value));
        stiffen(a, -pull, lever_of(joint, a.axes * joint.arm_a, joint.apart));
        stiffen(b, pull, b.axes * joint.arm_b);
    }
    for (const DirectBody& body : bodies) {
        if (!body.pushed) continue;
        const Mat3 m = body.inverse_inertia * body.stiffness;
        const double trace = absolute(m.x.x + m.y.y + m.z.z) * 0.5;
        const double norm =
            square_root((length_squared(m.x) + length_squared(m.y) + length_squared(m.z)) * 0.5);
        most = maximum(most, maximum(trace, norm) + body.spring_square);
    }
    return square_root(most);
}

// The geometric stiffness of a force on the ends of a gear.
void DirectGroup::stiffen_gear(const DirectJoint& joint, double force) {
    for (const DirectGear::End& end : joint.gear[0].ends) {
        if (end.motion == DirectGear::Motion::turn) continue;
        DirectBody& body = bodies[as_index(end.body)];
        stiffen(body, part_of(joint.gear[0], end.body).linear * force, body.axes * end.arm);
    }
}

// Adds the impulse of the step, or a part of it, to the bodies.
void DirectGroup::add_gear_impulse(const DirectJoint& joint, double linear, double angular) {
    const DirectGear& gear = joint.gear[0];
    for (int k = 0; k < gear.part_count; k++) {
        DirectBody& body = bodies[as_index(gear.parts[k].body)];
        body.sum += gear.parts[k].linear * (linear * joint.impulse[0]);
        body.twist += gear.parts[k].angular * (angular * joint.impulse[0]);
    }
}

void DirectGroup::begin_energy_step(double h) {
    for (DirectBody& body : bodies) {
        body.v0 = velocity(body);
        body.w0 = spin(body);
        body.inertia = in_axes(body.axes, body.moments);
        body.twist = {};
    }
    // Initial guess: the current joint forces.
    for (DirectJoint& joint : joints) {
        for (int k = 0; k < joint.rows(); k++)
            joint.impulse[k] = joint.off[as_index(k)] ? 0 : 2 * h * joint.force[k];
        for (std::size_t w = 0; w < joint.free_axes.size(); w++) {
            const FreeAxis& free_axis = joint.free_axes[w];
            if (free_axis.implicit)
                joint.impulse[as_index(joint.first_free_axis()) + w] =
                    -h * free_axis.stiffness * stretch_of(free_axis, free_axis.start);
        }
        if (joint.is_gear()) {
            add_gear_impulse(joint, 0, 1);
            continue;
        }
        DirectBody &a = bodies[as_index(joint.a)], &b = bodies[as_index(joint.b)];
        for (int k = 0; k < joint.rows(); k++) {
            a.twist += joint.angular_a[k] * joint.impulse[k];
            b.twist += joint.angular_b[k] * joint.impulse[k];
        }
    }
    for (DirectBody& body : bodies)
        body.mean_w =
            body.pushed
                ? body.w0 + body.inverse_inertia *
                                (body.twist + (body.torque - cross(body.w0, body.l)) * h) * 0.5
                : body.w0;
}

// Actuation between its steps, and springs of held free axes, along the means of the previous
// iterate.
void DirectGroup::add_known_pushes(double h) {
    for (DirectJoint& joint : joints)
        for (FreeAxis& free_axis : joint.free_axes) {
            free_axis.applied = 0;
            double push = free_axis.push();
            DirectBody &a = bodies[as_index(joint.a)], &b = bodies[as_index(joint.b)];
            if (free_axis.bound && free_axis.rate > 0) {
                const double travelled = free_axis.at_limit == 0 ? free_axis.hold_speed() * h : 0;
                push -=
                    free_axis.stiffness * stretch_of(free_axis, free_axis.start + 0.5 * travelled);
            }
            if (push == 0) continue;
            free_axis.applied = h * push;
            a.sum -= free_axis.linear * free_axis.applied;
            a.twist += free_axis.angular_a * free_axis.applied;
            b.sum += free_axis.linear * free_axis.applied;
            b.twist += free_axis.angular_b * free_axis.applied;
        }
}

// Computes the state that the unknowns lead to and returns its error, m.
double DirectGroup::residual_of(double h, bool stiffness_too) {
    for (DirectBody& body : bodies) {
        const Vec3 t = body.mean_w * (0.5 * h);
        const double s = 1 / square_root(1 + dot(t, t));
        body.q1 = Quat{s * t.x, s * t.y, s * t.z, s} * body.q;
        body.axes1 = to_matrix(body.q1);
        body.sum = body.force * h;
        body.twist = body.torque * h;
        if (stiffness_too) body.stiffness = diagonal({0, 0, 0});
    }
    for (const DirectJoint& joint : joints) {
        if (joint.is_gear()) {
            add_gear_impulse(joint, 1, 0);
            continue;
        }
        const Vec3 pull = pull_of(joint, joint.impulse);
        bodies[as_index(joint.a)].sum -= pull;
        bodies[as_index(joint.b)].sum += pull;
    }
    if (sprung_ || actuated_) add_known_pushes(h);
    for (DirectBody& body : bodies)
        body.x1 = body.x + (body.v0 + scaled(body.sum, body.inverse_masses * 0.5)) * h;
    for (DirectJoint& joint : joints) {
        DirectBody &a = bodies[as_index(joint.a)], &b = bodies[as_index(joint.b)];
        write_mean_vectors(joint, bodies);
        if (joint.is_gear()) {
            add_gear_impulse(joint, 0, 1);
            if (stiffness_too) stiffen_gear(joint, joint.impulse[0]);
            continue;
        }
        for (int k = 0; k < joint.rows(); k++) {
            a.twist += joint.angular_a[k] * joint.impulse[k];
            b.twist += joint.angular_b[k] * joint.impulse[k];
        }
        if (!stiffness_too) continue;
        const Vec3 pull = pull_of(joint, joint.impulse);
        stiffen(a, -pull, lever_of(joint, a.axes1 * joint.arm_a, joint.apart));
        stiffen(b, pull, b.axes1 * joint.arm_b);
    }
    double largest = 0;
    for (DirectBody& body : bodies) {
        if (!body.pushed) {
            body.residual = {};
            continue;
        }
        const Vec3 momentum = body.inertia * body.mean_w;
        body.residual = (momentum - body.inertia * body.w0) * 2 + cross(body.mean_w, momentum) * h -
                        body.twist + cross(body.mean_w, body.twist) * (0.5 * h);
        const double size =
            square_root(absolute(dot(body.residual, body.inverse_inertia * body.residual) *
                                 body.inverse_mass)) *
            h;
        largest = size <= largest ? largest : size;
    }
    const double apart = measure_all(h);
    return apart <= largest ? largest : apart;
}

void DirectGroup::correct(double h, bool again) {
    if (again) {
        for (DirectBody& body : bodies) {
            if (!body.pushed) {
                body.response = diagonal({0, 0, 0});
                continue;
            }
            if (!body.turns_freely) {
                body.response = response_about_one(body, h);
                continue;
            }
            // Under compression the matrix may be indefinite. The stiffness is then omitted.
            SymmetricMat3 response;
            body.response =
                invert(upper_triangle(body.inertia * 2 + body.stiffness * (0.5 * h)), response)
                    ? to_mat3(response)
                    : body.inverse_inertia * 0.5;
        }
        assemble(0.5, &DirectBody::response);
        factored_ = false;
    }
    for (DirectBody& body : bodies) {
        body.spin_correction = -(body.response * body.residual);
        body.residual = -body.residual;
    }
    for (std::size_t k = 0; k < joints.size(); k++) {
        const DirectJoint& joint = joints[k];
        const DirectBody &a = bodies[as_index(joint.a)], &b = bodies[as_index(joint.b)];
        double* const to = right_side_.data() + matrix_.row_of(static_cast<int>(k));
        if (joint.is_gear()) {
            to[0] = -joint.error[0] / h;
            for (int part = 0; part < joint.gear[0].part_count; part++)
                to[0] -= dot(joint.gear[0].parts[part].angular,
                             bodies[as_index(joint.gear[0].parts[part].body)].spin_correction);
            continue;
        }
        for (int r = 0; r < joint.rows(); r++)
            to[r] = -dot(joint.angular_a[r], a.spin_correction) -
                    dot(joint.angular_b[r], b.spin_correction) - joint.error[r] / h;
    }
    solve();
    for (std::size_t k = 0; k < joints.size(); k++) {
        DirectJoint& joint = joints[k];
        DirectBody &a = bodies[as_index(joint.a)], &b = bodies[as_index(joint.b)];
        const double* const more = right_side_.data() + matrix_.row_of(static_cast<int>(k));
        if (joint.is_gear()) {
            const DirectGear& gear = joint.gear[0];
            joint.impulse[0] += more[0];
            for (int part = 0; part < gear.part_count; part++)
                bodies[as_index(gear.parts[part].body)].residual +=
                    gear.parts[part].angular * more[0];
            continue;
        }
        for (int r = 0; r < joint.rows(); r++) {
            joint.impulse[r] += more[r];
            a.residual += joint.angular_a[r] * more[r];
            b.residual += joint.angular_b[r] * more[r];
        }
    }
    for (DirectBody& body : bodies) body.mean_w += body.response * body.residual;
}

bool DirectGroup::solve_energy_positions(double h, double tolerance) {
    ASSERT(tolerance > 0);
    begin_energy_step(h);
    double last_error = 1e300, first = 0, enough = tolerance;
    bool again = true;
    for (int round = 0;; round++) {
        const double error = residual_of(h, true);
        if (round == 0) {
            first = error;
            enough = actuated_ || limited_ || looped_ ? tolerance : enough_of(first, tolerance);
        }
        if (error < enough) return true;
        if (round == max_energy_corrections || !(error < 1e6))
            return error < 30 * tolerance ||
                   (!smooth_ && error <= first && error_of_holding() < 30 * tolerance);
        again = round < 1 || error > slow_contraction * last_error;
        last_error = error;
        correct(h, again);
    }
}

bool DirectGroup::step_energy(double h, double tolerance) {
    count_.energy_steps++;
    ASSERT(h > 0 && !joints.empty());
    energy_ = true;
    set_bounds(h);
    write_all_vectors();
    if (sprung_) set_springs();
    if (damped_springs_) damp_springs();
    if (!smooth_) damp(0.5 * h);
    if (outside != nullptr) outside->push(bodies, time_, h, 0.5 * h);
    set_targets(h);
    for (int round = 0;; round++) {
        if (!solve_energy_positions(h, tolerance)) return false;
        if (smooth_ || round == bound_rounds) break;
        bool changed = reach_limits(h, 0);
        for (DirectJoint& joint : joints)
            if (enforce_bounds(joint, joint.impulse, h, 0)) changed = true;
        if (!changed) break;
    }
    for (DirectBody& body : bodies) {
        if (!body.pushed) continue;
        body.p += body.sum;
        body.l += body.twist;
        body.q1 = nearly_unit(body.q1);
    }
    for (DirectJoint& joint : joints) {
        record(joint, joint.impulse);
        for (int k = 0; k < joint.rows(); k++) joint.force[k] = joint.impulse[k] / (2 * h);
        for (const FreeAxis& free_axis : joint.free_axes) {
            if (free_axis.applied == 0) continue;
            joint.force_sum += free_axis.linear * free_axis.applied;
            if (!free_axis.is_linear()) joint.torque_sum += free_axis.angular_b * free_axis.applied;
        }
    }
    commit();
    energy_ = false;
    if (sprung_)
        for (DirectJoint& joint : joints)
            for (int row = joint.first_free_axis(); row < joint.rows(); row++) set_row(joint, row);
    if (!smooth_) damp(0.5 * h);
    project_velocities(h, 0, false);
    if (looped_) project_velocities(h, 0, false);
    time_ += h;
    return true;
}

}  // namespace jostle::physics
