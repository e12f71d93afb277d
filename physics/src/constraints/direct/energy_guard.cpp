// SPDX-License-Identifier: MIT
//
// Compares the energy of a group before and after a step. RATTLE and its compositions keep it to a
// small fraction unless h is too long for the group; then their errors grow without bound. Nearly
// dependent rows can pull with arbitrary force as well: the joints hold at the end of such a step,
// but the bodies may move at any speed.
#include "physics/src/constraints/direct/direct_group.h"
#include "physics/src/constraints/direct/step_tolerances.h"

namespace jostle::physics {
namespace {

constexpr double spring_share = 0.1;  // of the energy of springs

bool is_at_rest(const DirectBody& body) {
    return body.v == Vec3{} && body.w == Vec3{};
}

}  // namespace

DirectGroup::EnergyBooks DirectGroup::open_books() const {
    EnergyBooks books{.exact = smooth_ && !sprung_ && time_ > 0};
    for (const DirectBody& body : bodies) {
        if (!body.pushed && !is_at_rest(body)) books.closed = false;  // it does work
        if (!body.pushed) continue;
        const double kinetic = 0.5 * (dot(body.p, velocity(body)) + dot(body.l, spin(body)));
        books.kinetic += kinetic;
        books.total += kinetic - dot(body.force, body.x);
        books.twist += 0.5 * dot(body.torque, spin(body));
    }
    if (outside != nullptr) books.closed = false;
    return books;
}

// Energy that motors and springs add in a step, J.
double DirectGroup::work_of_axes() const {
    double work = 0;
    for (const DirectJoint& joint : joints)
        for (const FreeAxis& axis : joint.free_axes) {
            if (axis.steps > 0) {
                const double travel = axis.value - axis.start;
                work += axis.push_between(0) *
                        absolute(axis.is_linear() || axis.has_range() ? travel : wrapped(travel));
            }
            if (axis.rate == 0) continue;
            const double before = stretch_of(axis, axis.start),
                         after = stretch_of(axis, axis.value);
            work += 0.5 * axis.stiffness * (before * before - after * after);
        }
    return work;
}

// Energy that may change in the step, J: that of gaps (step_tolerances.h), and the energy of
// springs is that of an oscillation.
double DirectGroup::work_of_errors(double h) const {
    double error = 2 * tolerance(h), weight = 0, tension = 0, mass = 0, springs = 0;
    for (const DirectJoint& joint : joints) {
        tension += 2 * length(pull_of(joint, joint.force));
        for (int k = 0; k < joint.first_free_axis(); k++)
            error = maximum(error, absolute(joint.start[k]) * (k < joint.points ? 1 : reach_));
        for (const FreeAxis& axis : joint.free_axes) {
            const double size = axis.is_linear() ? 1 : reach_;
            if (axis.has_limit())
                error = maximum(error,
                                maximum(axis.lower - axis.start, axis.start - axis.upper) * size);
            const double before = stretch_of(axis, axis.start),
                         after = stretch_of(axis, axis.value);
            springs += axis.stiffness * (before * before + after * after);
        }
    }
    for (const DirectBody& body : bodies)
        if (body.pushed) weight += length(body.force), mass += body.mass;
    return work_of_gaps({error, tolerance(h), weight, tension, mass}, h) + spring_share * springs;
}

bool DirectGroup::keeps_energy(const EnergyBooks& before, double h, EnergyBounds bounds) const {
    const EnergyBooks after = open_books();
    if (!(absolute(after.total) < 1e300)) return false;  // or NaN
    if (!before.closed) return true;
    const double twist = (before.twist + after.twist) * h;
    const double change = after.total - before.total - twist;
    double scale = maximum(before.kinetic, after.kinetic) + absolute(twist);
    for (const DirectBody& body : bodies)
        if (body.pushed) scale += h * h * length_squared(body.force) * body.inverse_mass;
    const double slack = work_of_errors(h);
    if (change > bounds.gain * scale + slack + maximum(0, work_of_axes())) return false;
    return !before.exact || change > -bounds.loss * scale - slack;
}

// All bodies slow down by the same factor, so that the joints still hold.
void DirectGroup::remove_gain(const EnergyBooks& before, double h) {
    const EnergyBooks after = open_books();
    if (!before.closed || actuated_ || sprung_) return;
    const double gain = after.total - before.total - (before.twist + after.twist) * h;
    if (gain <= 0 || after.kinetic <= 0) return;
    const double slower = square_root(maximum(0, 1 - gain / after.kinetic));
    for (DirectBody& body : bodies) body.p *= slower, body.l *= slower;
}

}  // namespace jostle::physics
