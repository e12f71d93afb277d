// SPDX-License-Identifier: MIT
#include "physics/src/constraints/direct/direct_group.h"

#include <algorithm>

#include "jostle/base/check.h"
#include "physics/src/constraints/direct/free_turn.h"
#include "physics/src/constraints/direct/step_tolerances.h"
#include "physics/src/constraints/joints/path_curve.h"

namespace jostle::physics {
namespace {

// RATTLE's corrections stop converging at about one radian.
constexpr double followed_swing = 0.7;  // rad
// Above this rotation per step an impulse no longer displaces a body along a straight line.
constexpr double followed_turn = 1;  // rad
// Per part of a composition. A thousand oscillations then stay within 0.04 rad of the exact
// solution.
constexpr double followed_spring = 0.35;  // rad
constexpr int max_spring_parts = 64, springs_followed = 8;
constexpr int max_halvings = 6, max_steps = 1024;
// Larger groups are not composed of halves and quarters, which take up to 20 steps.
constexpr std::size_t max_quartered_joints = 32;
// See may_take_fewer_steps.
constexpr std::size_t min_large_joints = 24;
constexpr double slow_turn = 0.05;  // rad in a sub-step
// After this many sub-steps, a longer one is tried again.
constexpr int steps_at_halvings = 4;
// Suzuki's coefficients a, a, 1 - 4 a, a, a with a = 1 / (4 - 4^(1/3)).
constexpr double suzuki = 0.41449077179437573714;
constexpr double suzuki_stages[] = {suzuki, suzuki, 1 - 4 * suzuki, suzuki, suzuki};
constexpr double longest_stage = 4 * suzuki - 1;

// See may_take_fewer_steps. `turn`: of the fastest body over all sub-steps, rad.
int fewer_steps(int substeps, double turn) {
    const int half = std::max(4, (substeps + 1) / 2), quarter = std::max(2, (substeps + 3) / 4);
    return std::min(substeps, turn <= slow_turn * quarter ? quarter : half);
}

}  // namespace

double DirectGroup::tolerance(double h) const {
    return joint_tolerance(h, looped_, reach_);
}

void DirectGroup::save(int depth) {
    if (saved_.size() <= static_cast<std::size_t>(depth))
        saved_.resize(static_cast<std::size_t>(depth) + 1);
    Saved& to = saved_[static_cast<std::size_t>(depth)];
    ASSERT(depth >= 0 && depth <= max_halvings);
    to.bodies.clear();
    to.joints.clear();
    to.free_axes.clear();
    for (const DirectBody& body : bodies) to.bodies.push_back({body.x, body.p, body.l, body.q});
    for (const DirectJoint& joint : joints) {
        to.joints.push_back({joint.force_sum, joint.torque_sum, {}});
        SavedJoint& saved = to.joints.back();
        saved.travels[0] = joint.path_at;
        if (joint.is_gear())
            for (int k = 0; k < 2; k++) saved.travels[k] = joint.gear[0].ends[k].travel;
        for (const FreeAxis& free_axis : joint.free_axes)
            to.free_axes.push_back({free_axis.at_limit, free_axis.actuation});
    }
    for (std::size_t k = 0; k < joints.size(); k++)
        std::copy(std::begin(joints[k].force), std::end(joints[k].force), to.joints[k].force);
}

void DirectGroup::restore(int depth) {
    const Saved& from = saved_[static_cast<std::size_t>(depth)];
    ASSERT(from.bodies.size() == bodies.size() && from.joints.size() == joints.size());
    for (std::size_t k = 0; k < bodies.size(); k++) {
        DirectBody& body = bodies[k];
        body.x = from.bodies[k].x;
        body.p = from.bodies[k].p;
        body.l = from.bodies[k].l;
        body.q = from.bodies[k].q;
        refresh(body);
    }
    std::size_t next = 0;
    for (std::size_t k = 0; k < joints.size(); k++) {
        DirectJoint& joint = joints[k];
        joint.force_sum = from.joints[k].force_sum;
        joint.torque_sum = from.joints[k].torque_sum;
        joint.path_at = from.joints[k].travels[0];
        if (joint.is_gear())
            for (int end = 0; end < 2; end++)
                joint.gear[0].ends[end].travel = from.joints[k].travels[end];
        for (FreeAxis& free_axis : joint.free_axes) {
            free_axis.at_limit = from.free_axes[next].at_limit;
            free_axis.actuation = from.free_axes[next++].actuation;
        }
        std::copy(std::begin(from.joints[k].force), std::end(from.joints[k].force), joint.force);
    }
    factored_ = false;
    ASSERT(next == from.free_axes.size());
    energy_ = false;
}

// Returns false, and leaves any state, if the step has to be taken in another way.
bool DirectGroup::compose(double h) {
    count_.compositions++;
    // The errors of the stages are of third order in h and cancel. What the tolerance leaves over
    // must be smaller and of no lower order.
    const double fine =
        minimum(minimum(1e-7, 0.07 * h * h * h), tolerance(h)) * minimum(1, 2 * reach_);
    const EnergyBooks books = open_books();
    const std::uint64_t limits = active_limits();
    if (curved_ && meets_bend(h)) return false;
    for (const double stage : suzuki_stages)
        if (!step_rattle(h * stage, fine) || is_overrun_or_hit(limits, tolerance(h))) return false;
    return sprung_ ||
           keeps_energy(books, h, composed_bounds);  // books do not follow springs over stages
}

// Whether a body may pass points of its curve at which the curvature jumps: the stages of a
// composition lose their order there. Its direction of motion may be off by the turn below.
bool DirectGroup::meets_bend(double h) const {
    constexpr double most = 1e-5;  // rad
    for (const DirectJoint& joint : joints) {
        if (joint.path == nullptr) continue;
        const double travel = speed_along_path(joint, bodies) * h;
        const double step = travel / path_speed_at(*joint.path, joint.path_at);
        if (curvature_jumps(*joint.path, joint.path_at, joint.path_at + 1.25 * step) *
                absolute(travel) >
            most)
            return true;
    }
    return false;
}

// A composition of the whole step, or of its halves or quarters. Returns false, and leaves the
// state unchanged, if the joint forces oscillate too fast even for those.
bool DirectGroup::compose_parts(double h) {
    const int most = joints.size() <= max_quartered_joints && !is_trial ? 4 : 1;
    for (int parts = 1; parts <= most; parts *= 2) {
        if (stiffest() * h * longest_stage >= followed_swing * parts) continue;
        int done = 0;
        while (done < parts && compose(h / parts)) done++;
        if (done == parts) return true;
        restore(0);
    }
    return false;
}

int DirectGroup::most_parts() const {
    return is_trial ? 1 : (joints.size() <= max_quartered_joints ? 8 : 2);
}

// Returns false, and leaves the state in the bodies and joints, if the group is none or its step
// has to be taken in another way.
bool DirectGroup::step_ball_tree(double h) {
    if (!ball_tree_ || outside != nullptr) return false;
    if (!balls_.is_loaded()) balls_.load(bodies, joints, matrix_);
    factored_ = false;
    const bool done = balls_.step(h,
                                  {.reach = reach_,
                                   .swing = followed_swing,
                                   .parts = most_parts(),
                                   .keeps_energy = smooth_ && time_ > 0,
                                   .energy = rattle_bounds.gain,
                                   .energy_gain = energy_step_bounds.gain},
                                  {matrix_, system_blocks_, right_side_});
    const BallTree::Count count = balls_.take_count();
    count_.rattle_steps += count.rattle_steps;
    count_.energy_steps += count.energy_steps;
    count_.factors += count.factors;
    count_.solves += count.solves;
    if (done)
        time_ += h;
    else
        store_ball_tree();
    return done;
}

void DirectGroup::store_ball_tree() {
    if (balls_.is_loaded()) balls_.store(bodies, joints);
}

// After a halving, the rest of the advance starts with halved steps. After a failure at the
// smallest step, it uses the velocity fallback. A net uses it earlier: shorter steps do not help.
void DirectGroup::step(double h, int depth) {
    if (resorting_) return resort_to_velocities(h);
    if (depth <= halvings_) {
        step(0.5 * h, depth + 1);
        step(0.5 * h, depth + 1);
        return;
    }
    if (step_ball_tree(h)) return;
    save(depth);
    ASSERT(depth <= max_halvings);
    const EnergyBooks books = open_books();
    // Two RATTLE steps cost as much as an energy-momentum step and are more accurate. Small groups
    // take up to eight.
    const double swing = stiffest() * h;
    const int most = most_parts();
    int parts = 1;
    while (parts < most && swing >= followed_swing * parts) parts *= 2;
    if (swing < followed_swing * parts) {
        int done = 0;
        while (done < parts && step_rattle(h / parts, tolerance(h / parts))) done++;
        if (done == parts && keeps_energy(books, h, rattle_bounds)) return;
        restore(depth);
    }
    if (step_energy(h, tolerance(h)) && keeps_energy(books, h, energy_step_bounds)) return;
    restore(depth);
    if (depth == max_halvings || (net_ && depth > 1)) {
        resorting_ = true;
        return resort_to_velocities(h);
    }
    count_.halvings++;
    halvings_ = depth;
    step(0.5 * h, depth + 1);
    step(0.5 * h, depth + 1);
}

// Fastest free rotation of a body, about its axes and including their precession (free_turn.h).
double DirectGroup::fastest_turn() const {
    double most = 0;
    for (const DirectBody& body : bodies)
        most = maximum(
            most, body.pushed ? maximum(length(spin(body)), turn_rate(body.l, body.inverse_moments))
                              : length(body.w));
    return most;
}

void DirectGroup::advance(double dt, int substeps) {
    time_ = 0;
    ASSERT(dt > 0 && substeps >= 1);
    halvings_ = 0;
    resorting_ = false;
    const double turn = fastest_turn() * dt;
    if (turn > followed_turn * substeps)
        substeps = static_cast<int>(minimum(turn / followed_turn, max_steps - 1)) + 1;
    int parts = parts_of(dt, substeps);
    if (turn * longest_stage > followed_turn * parts) parts = 0;
    // Separated ends converge step by step, forward in time.
    if (parts > 0 && set_targets(dt / substeps)) parts = 0;
    if (parts == 0 && may_take_fewer_steps && joints.size() >= min_large_joints)
        substeps =
            fewer_steps(substeps, joints.size() >= min_coarse_joints ? turn : FreeAxis::never);
    for (int part = 0; part < parts; part++) {
        const double h = dt / parts;
        store_ball_tree();
        save(0);
        if (compose_parts(h)) continue;
        const int steps = static_cast<int>(maximum(1, substeps / parts));
        ASSERT(steps >= 1);
        for (int k = 0; k < steps; k++) step(h / steps, 1);
    }
    for (int k = 0; parts == 0 && k < substeps; k++) {
        step(dt / substeps, 1);
        if (k % steps_at_halvings == steps_at_halvings - 1 && halvings_ > 0) halvings_--;
    }
    store_ball_tree();
}

// A composition has five steps, forwards and backwards. It requires that no free axis has damping,
// or friction, and that no limit is reached or left. Springs need several parts per radian.
int DirectGroup::parts_of(double dt, int substeps) {
    if (damped_ || actuated_ || outside != nullptr || substeps < 5) return 0;
    const double required = spring_rate_ * dt / followed_spring;
    // For a large group the cost would exceed the benefit for its oscillations.
    const double many = maximum(1, static_cast<double>(joints.size()) / springs_followed);
    if (required * many > max_spring_parts) return 0;
    return static_cast<int>(maximum(substeps / 5, required + 1));
}

// Fallback: kick, velocities that satisfy the joints and reduce their errors, drift, velocities
// without the error term. First order; cannot fail, and cannot gain energy.
void DirectGroup::resort_to_velocities(double h) {
    count_.last_resorts++;
    ASSERT(h > 0);
    const EnergyBooks books = open_books();
    set_bounds(h);
    set_targets(h);
    for (DirectBody& body : bodies) {
        body.x1 = body.x;
        body.q1 = body.q;
        body.axes1 = body.axes;
    }
    measure_all(0);
    factor_here();
    soften_springs(h);
    kick(h, false);
    kick(h, true);
    project_velocities(h, 0.2 / h);
    const int rounds = (looped_ || net_) && smooth_ ? proximal_rounds : 1;
    for (int round = 1; round < rounds; round++) project_velocities(h, 0.2 / h, false);
    time_ += h;
    for (DirectBody& body : bodies) {
        body.x1 = body.x + velocity(body) * h;
        body.q1 = normalized(turn_by(spin(body) * h) * body.q);
        body.axes1 = to_matrix(body.q1);
    }
    commit();
    for (int round = 0; round < rounds; round++) project_velocities(h, 0, false);
    remove_gain(books, h);
}

}  // namespace jostle::physics
