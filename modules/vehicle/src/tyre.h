// SPDX-License-Identifier: MIT
//
// The brush tyre: how hard a bent tread pushes, and how slip bends it.
#pragma once

#include "car.h"

namespace jostle::modules::vehicle_detail {

// How a tread pushes at a load.
struct Tread {
    double limit = 0;                        // N: friction * load
    double bend_ahead = 0, bend_aside = 0;   // of the whole limit per m: C / (3 mu length), 1/m
    double roll = 0;                         // share of its bend that a sub-step leaves
    double rolls = 1;                        // 0 at standstill, 1 from 1 m/s on
    double damping_ahead = 0, damping_aside = 0;  // N s/m, at standstill
    // N per m of bend, as it is bent: force = secant * bend.
    double secant_ahead = 0, secant_aside = 0;
};

// For a sub-step in which it rolls at `speed`, m/s. `inverse_mass`: 1/kg of what a tread moves, at
// most.
Tread tread_of(const Tyre& tyre, const Contact& contact, double friction, double speed, double h,
               double inverse_mass, const WheelRun& wheel);

// Back to where friction holds it; the secants follow.
void hold(Tread& tread, double& ahead, double& aside);

}  // namespace jostle::modules::vehicle_detail
