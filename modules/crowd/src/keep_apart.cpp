// SPDX-License-Identifier: MIT
#include "modules/crowd/src/keep_apart.h"

namespace jostle::modules::crowd_detail {

using namespace physics;

namespace {

// Solves one constraint. Returns its violation before, m/s.
double solve(DiscContact& contact, std::span<Vec3> velocities, double inverse_dt) {
    Vec3 &a = velocities[contact.a], &b = velocities[contact.b];
    const double excess = -contact.gap * inverse_dt - dot(contact.normal, b - a);
    const double next = maximum(contact.impulse + excess, 0);
    const double change = next - contact.impulse;
    contact.impulse = next;
    a -= contact.normal * (change * contact.share);
    b += contact.normal * (change * (1 - contact.share));
    return excess;
}

double solve(WallContact& contact, std::span<Vec3> velocities, double inverse_dt) {
    Vec3& v = velocities[contact.agent];
    const double excess = -contact.gap * inverse_dt - dot(contact.normal, v);
    const double next = maximum(contact.impulse + excess, 0);
    v += contact.normal * (next - contact.impulse);
    contact.impulse = next;
    return excess;
}

}  // namespace

KeepApartResult keep_apart(std::span<Vec3> velocities, std::span<DiscContact> discs,
                           std::span<WallContact> walls, double dt, double tolerance,
                           int iterations_max) {
    KeepApartResult result;
    const double inverse_dt = 1 / dt;
    while (result.iterations < iterations_max) {
        double worst = 0;
        for (DiscContact& contact : discs)
            worst = maximum(worst, solve(contact, velocities, inverse_dt));
        for (WallContact& contact : walls)
            worst = maximum(worst, solve(contact, velocities, inverse_dt));
        result.iterations++;
        result.overlap = worst * dt;
        if (result.overlap <= tolerance) break;
    }
    return result;
}

}  // namespace jostle::modules::crowd_detail
