// SPDX-License-Identifier: MIT
//
// The bend u of the tread, m, against the slip velocity v_s and rolling at v (Pacejka 7.2.1, the
// single contact point):
//
//     du/dt = -v_s - |v| u / length            at rest: u = -v_s length / |v|, the slip
//
// is solved implicitly. At standstill it is a spring that stays where it is: the car does not
// creep. The force is that of brushes with a parabolic pressure (Pacejka 3.2.1),
//
//     F = mu N (3 s - 3 s^2 + s^3),   s = C |u| / (3 mu length),   C force per load and slip
//
// and mu N from s = 1 on. Beyond s = 1 the tread is not bent further. It pushes along
// (C_x u_x, C_y u_y) while it sticks and against the slip once it slides. A tread that does not
// roll sticks all along: F = mu N min(3 s, 1), and is bent a third as far. In between the two are
// mixed by speed.
#include "tyre.h"

namespace jostle::modules::vehicle_detail {

using namespace physics;

namespace {

constexpr double rolls_at = 1;  // m/s from which a tread is not damped: its contact patch renews

double damping_of(double ratio, double stiffness, double inverse_mass, double speed, double h) {
    const double at_rest = 1 - speed / rolls_at;
    if (at_rest <= 0 || stiffness <= 0) return 0;
    const double c = 2 * ratio * square_root(stiffness / inverse_mass) * at_rest;
    return c / (1 + h * c * inverse_mass);
}

}  // namespace

Tread tread_of(const Tyre& tyre, const Contact& contact, double friction, double speed, double h,
               double inverse_mass, const WheelRun& wheel) {
    Tread tread;
    tread.limit = friction * contact.load;
    tread.rolls = minimum(speed / rolls_at, 1);
    tread.roll = 1 / (1 + h * speed / tyre.relaxation_length);
    const double scale = 1 / (3 * maximum(friction, 1e-9) * tyre.relaxation_length);
    tread.bend_ahead = tyre.longitudinal_stiffness * scale;
    tread.bend_aside = tyre.cornering_stiffness * scale;
    const double k_ahead = 3 * tread.limit * tread.bend_ahead,
                 k_aside = 3 * tread.limit * tread.bend_aside;
    tread.damping_ahead = damping_of(tyre.damping, k_ahead, inverse_mass, speed, h);
    tread.damping_aside = damping_of(tyre.damping, k_aside, inverse_mass, speed, h);
    // Where a tread is too stiff for the sub-step it gives way; suspension.cpp says how.
    const double z2 = h * h * maximum(k_ahead, k_aside) * inverse_mass;
    const double gives = 1 / (1 + z2 * z2 / (4 + z2));
    tread.bend_ahead *= gives;
    tread.bend_aside *= gives;
    double ahead = wheel.bend_ahead, aside = wheel.bend_aside;
    hold(tread, ahead, aside);
    return tread;
}

void hold(Tread& tread, double& ahead, double& aside) {
    const double x = tread.bend_ahead * ahead, y = tread.bend_aside * aside;
    double s = square_root(x * x + y * y);
    const double most = (1 + 2 * tread.rolls) / 3;
    if (s > most) {
        ahead *= most / s;
        aside *= most / s;
        s = most;
    }
    const double rolling = 3 - 3 * s + s * s, standing = s > 1.0 / 3 ? 1 / s : 3;
    const double secant =
        tread.limit * (tread.rolls * rolling + (1 - tread.rolls) * standing);
    const double slides = (s / most) * (s / most);
    const double bend = square_root(ahead * ahead + aside * aside);
    const double against = bend > 0 ? slides * s / bend : 0;
    tread.secant_ahead = secant * ((1 - slides) * tread.bend_ahead + against);
    tread.secant_aside = secant * ((1 - slides) * tread.bend_aside + against);
}

}  // namespace jostle::modules::vehicle_detail
