// SPDX-License-Identifier: MIT
//
// Drive line: engine, clutch, gearbox, differentials, brakes, the spin of all wheels and the tyre
// response, solved as one implicit linear system per sub-step.
#pragma once

#include "modules/vehicle/src/car.h"

namespace jostle::modules::vehicle_detail {

// A wheel as the drive line models it.
struct DriveLineWheel {
    double radius, inertia, share;
    double brake;              // N m, maximum brake torque
    double force;              // N, forward tyre force at the current spin
    double slope;              // N s/rad, derivative of the force with respect to spin
    double spin;               // rad/s; receives the value at the end of the sub-step
    double effective_inertia;  // kg m^2, including the change of the tyre force
};
using DriveLineWheels = std::array<DriveLineWheel, wheels_max>;

// Solves one sub-step. Also updates the engine.
void solve_drive_line(Car& car, double h, DriveLineWheels& wheels);

// Engine speed per wheel speed; 0 in neutral and while shifting.
double current_gear_ratio(const Car& car);
double mean_driven_spin(const Car& car);
// N m, brake torque at the current brake input.
double brake_torque(const Car& car, std::size_t wheel);
double torque_at(const Engine& engine, double speed);

}  // namespace jostle::modules::vehicle_detail
