// SPDX-License-Identifier: MIT
#include "modules/destruction/src/impulse_reversal.h"

#include <algorithm>
#include <vector>

#include "modules/destruction/src/destruction_steps.h"

namespace jostle::modules::destruction_detail {

using namespace physics;

namespace {

constexpr int solver_iterations = 16;

void push(BodyState& body, Vec3 impulse, Vec3 point) {
    if (!(body.mass > 0)) return;
    body.linear_velocity += impulse / body.mass;
    body.angular_velocity += inverse(body.inertia) * cross(point - body.center, impulse);
}

void push(std::span<ReversalBody> bodies, const ImpulseReversal& one, double impulse) {
    push(bodies[one.struck].state, one.normal * impulse, one.point);
    if (one.inverse_mass_piece > 0) push(bodies[one.piece].state, one.normal * -impulse, one.point);
}

// A piece returns at most the impulse that it received in the step.
void share(std::span<ReversalBody> bodies, ImpulseReversal& one) {
    if (!(one.inverse_mass_piece + one.inverse_mass_struck > 0)) return;
    const BodyState &piece = bodies[one.piece].state, &struck = bodies[one.struck].state;
    const double now =
        dot(velocity_at(struck, one.point) - velocity_at(piece, one.point), one.normal);
    double more = (one.speed - now) / (one.inverse_mass_piece + one.inverse_mass_struck);
    if (one.inverse_mass_piece > 0) {
        const ReversalBody& reversal_body = bodies[one.piece];
        const Vec3 gained_velocity =
            piece.linear_velocity - reversal_body.linear - reversal_body.gravity_velocity +
            cross(piece.angular_velocity - reversal_body.angular, one.point - piece.center);
        more = minimum(more, dot(gained_velocity, one.normal) / one.inverse_mass_piece);
    }
    more = maximum(more, -one.impulse);
    one.impulse += more;
    push(bodies, one, more);
}

double energy_of(const BodyState& body, Vec3 linear, Vec3 angular) {
    return 0.5 * (body.mass * length_squared(linear) + dot(angular, body.inertia * angular));
}

// Groups of connected bodies: for each body, the lowest index of its group.
std::vector<std::size_t> groups_of(std::span<const ReversalBody> bodies,
                                   std::span<const ImpulseReversal> all,
                                   std::span<const std::pair<std::size_t, std::size_t>> pairs) {
    std::vector<std::size_t> group(bodies.size());
    for (std::size_t k = 0; k < group.size(); k++) group[k] = k;
    const auto lowest = [&](std::size_t k) {
        while (group[k] != k) k = group[k] = group[group[k]];
        return k;
    };
    const auto join = [&](std::size_t x, std::size_t y) {
        const std::size_t a = lowest(x), b = lowest(y);
        group[a > b ? a : b] = a > b ? b : a;
    };
    for (const ImpulseReversal& one : all) join(one.piece, one.struck);
    for (const auto& [a, b] : pairs) join(a, b);
    for (std::size_t k = 0; k < group.size(); k++) group[k] = lowest(k);
    return group;
}

// Energy budget of a group, J.
struct EnergyBudget {
    double initial = 0, final = 0;  // before and after the step
    // with all impulses applied; of the velocity change alone
    double reversed = 0, velocity_change_energy = 0;
    double dissipated_energy = 0;

    // Scale of the impulses at which the energy does not exceed the budget: final + b s +
    // velocity_change_energy s^2 = most.
    double share() const {
        const double most = maximum(initial - dissipated_energy, final),
                     b = reversed - final - velocity_change_energy;
        if (!(reversed > most) || !(velocity_change_energy > 0)) return 1;
        const double root = square_root(b * b + 4 * velocity_change_energy * (most - final));
        // Both forms are equal; each avoids cancellation in its case.
        const double part =
            b > 0 ? 2 * (most - final) / (b + root) : (root - b) / (2 * velocity_change_energy);
        return clamp(part, 0, 1);
    }
};

}  // namespace

double ReversalBody::energy() const {
    return energy_of(state, state.linear_velocity, state.angular_velocity);
}

double ReversalBody::energy_before() const {
    return energy_of(state, linear, angular) +
           0.5 * state.mass * dot(gravity_velocity, linear + state.linear_velocity);
}

// Projected Gauss-Seidel over the impulses. Each impulse restores the approach speed of its own
// pair. A body that is in several pairs, or was deflected, could then have more energy than before.
// All impulses of a group are therefore scaled by the same factor, which conserves momentum.
void reverse_impulses(std::span<ReversalBody> bodies, std::span<ImpulseReversal> all,
                      std::span<const std::pair<std::size_t, std::size_t>> pairs) {
    const std::vector<ReversalBody> after(bodies.begin(), bodies.end());
    for (int round = 0; round < solver_iterations; round++)
        for (ImpulseReversal& one : all) share(bodies, one);
    const std::vector<std::size_t> group = groups_of(bodies, all, pairs);
    std::vector<EnergyBudget> ledgers(bodies.size());
    for (std::size_t k = 0; k < bodies.size(); k++) {
        const BodyState &now = bodies[k].state, &was = after[k].state;
        EnergyBudget& ledger = ledgers[group[k]];
        ledger.initial += after[k].energy_before();
        ledger.final += after[k].energy();
        ledger.reversed += bodies[k].energy();
        ledger.velocity_change_energy += energy_of(now, now.linear_velocity - was.linear_velocity,
                                                   now.angular_velocity - was.angular_velocity);
    }
    for (const ImpulseReversal& one : all)
        ledgers[group[one.struck]].dissipated_energy += one.dissipated_energy;
    std::copy(after.begin(), after.end(), bodies.begin());
    for (ImpulseReversal& one : all) {
        one.impulse *= ledgers[group[one.struck]].share();
        push(bodies, one, one.impulse);
    }
}

}  // namespace jostle::modules::destruction_detail
