// SPDX-License-Identifier: MIT
//
// Engine, clutch, gearbox, differentials, brakes and the spin of all wheels, with how tyres answer
// to it, as one implicit linear system per sub-step.
#pragma once

#include "modules/vehicle/src/car.h"

namespace jostle::modules::vehicle_detail {

// A wheel as the drive line sees it.
struct DriveLineWheel {
    double radius, inertia, share;
    double brake;              // N m that hold it, at most
    double force;              // N of its tyre ahead if it spins on as it does
    double slope;              // N s/rad by which that grows with its spin
    double spin;               // rad/s; becomes that at the end of the sub-step
    double effective_inertia;  // kg m^2 that a change of its tyre's force meets
};
using DriveLineWheels = std::array<DriveLineWheel, wheels_max>;

// Also moves the engine on.
void solve_drive_line(Car& car, double h, DriveLineWheels& wheels);

// Engine speed per wheel speed; 0: neutral or between two gears.
double current_gear_ratio(const Car& car);
double mean_driven_spin(const Car& car);
double brake_torque(const Car& car, std::size_t wheel);  // N m of its brakes, as they are pressed
double torque_at(const Engine& engine, double speed);

}  // namespace jostle::modules::vehicle_detail
