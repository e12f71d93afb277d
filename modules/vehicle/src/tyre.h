// SPDX-License-Identifier: MIT
//
// The brush tyre: force of a deflected tread, and its deflection by slip.
//
// The deflection u of the tread, m, with the slip velocity v_s and the rolling speed v (Pacejka
// 7.2.1, single contact point) follows
//
//     du/dt = -v_s - |v| u / length            in steady state: u = -v_s length / |v|, the slip
//
// and is solved implicitly. At standstill it is a spring with a fixed anchor, so the car does not
// creep. The force is that of brushes with a parabolic pressure distribution (Pacejka 3.2.1),
//
//     F = mu N (3 s - 3 s^2 + s^3),   s = C |u| / (3 mu length),   C force per load and slip
//
// and mu N for s >= 1. The deflection is limited to s = 1. The force acts along (C_x u_x, C_y u_y)
// while the tread sticks, and against the slip once it slides. A tread that does not roll sticks
// over its whole length: F = mu N min(3 s, 1), with the deflection limited to a third. In between,
// both are blended by speed.
#pragma once

#include "modules/vehicle/src/car.h"

namespace jostle::modules::vehicle_detail {

// m/s from which a tread is rolling, so that its contact patch is renewed
inline constexpr double rolling_speed_min = 1;

// Damping of a tread at standstill, N s/m, limited for stability in the sub-step.
inline double tread_damping(double ratio, double stiffness, double inverse_mass, double rolls,
                            double h) {
    if (rolls >= 1 || stiffness <= 0) return 0;
    const double c = 2 * ratio * physics::square_root(stiffness / inverse_mass) * (1 - rolls);
    return c / (1 + h * c * inverse_mass);
}

// Tread state for a sub-step in which the tyre rolls at `speed`, m/s.
inline TreadState tread_of(const Tyre& tyre, const Contact& contact, double friction, double speed,
                           double h) {
    TreadState tread;
    tread.limit = friction * contact.load;
    tread.rolling_share = physics::minimum(speed / rolling_speed_min, 1);
    const double per_length = 1 / tyre.relaxation_length;
    tread.roll = 1 / (1 + h * speed * per_length);
    const double k_ahead = contact.load * tyre.longitudinal_stiffness * per_length,
                 k_aside = contact.load * tyre.cornering_stiffness * per_length;
    tread.longitudinal_damping =
        tread_damping(tyre.damping, k_ahead, contact.inverse_mass, tread.rolling_share, h);
    tread.lateral_damping =
        tread_damping(tyre.damping, k_aside, contact.inverse_mass, tread.rolling_share, h);
    // A tread that is too stiff for the sub-step is softened as explained in suspension.cpp.
    const double z2 = h * h * physics::maximum(k_ahead, k_aside) * contact.inverse_mass;
    const double compliance = (4 + z2) / (4 + z2 + z2 * z2);
    const double scale = compliance * per_length / (3 * physics::maximum(friction, 1e-9));
    tread.longitudinal_deflection = tyre.longitudinal_stiffness * scale;
    tread.lateral_deflection = tyre.cornering_stiffness * scale;
    return tread;
}

// Limits the deflection to friction: s is at most 1, or 1/3 at standstill. Returns s^2.
inline double clamp_to_friction(const TreadState& tread, double& forward, double& lateral) {
    const double x = tread.longitudinal_deflection * forward,
                 y = tread.lateral_deflection * lateral;
    const double most = (1 + 2 * tread.rolling_share) / 3, s2 = x * x + y * y;
    if (s2 <= most * most) return s2;
    const double less = most / physics::square_root(s2);
    forward *= less;
    lateral *= less;
    return most * most;
}

// Computes the force per deflection. If the squared fraction of the limit is below `sticks`, the
// tread sticks.
inline void compute_secant_stiffness(TreadState& tread, double forward, double lateral, double s2) {
    constexpr double sticks = 0.05;
    const double s = physics::square_root(s2);
    double secant = tread.limit * (3 - 3 * s + s2);
    if (tread.rolling_share < 1) {
        const double standing = tread.limit * (s > 1.0 / 3 ? 1 / s : 3);
        secant = tread.rolling_share * secant + (1 - tread.rolling_share) * standing;
    }
    tread.longitudinal_secant = secant * tread.longitudinal_deflection;
    tread.lateral_secant = secant * tread.lateral_deflection;
    const double most = (1 + 2 * tread.rolling_share) / 3, share = s2 / (most * most);
    if (share <= sticks) return;
    const double slides = (share - sticks) / (1 - sticks);
    const double bend2 = forward * forward + lateral * lateral;
    const double against = secant * slides * physics::square_root(s2 / bend2);
    tread.longitudinal_secant += against - slides * tread.longitudinal_secant;
    tread.lateral_secant += against - slides * tread.lateral_secant;
}

}  // namespace jostle::modules::vehicle_detail
