// SPDX-License-Identifier: MIT
//
// The unknowns are the speeds y of all wheels and the engine at the end of the sub-step:
//
//     I (y' - y) = h T - h R F(y')
//
// F is linearized in the spin around the current tyre force. A friction element (brake, clutch,
// coupling) is a constraint r, a row over y. While it sticks, it is a stiff damper of r.y', which
// adds h c r r^T to the matrix. If that requires more torque than it can transmit, it slips and
// applies its maximum torque. The states are initially guessed from the previous speeds and
// corrected until they are consistent, so usually one solve suffices. The matrix is symmetric
// positive definite for all states.
#include "modules/vehicle/src/drive_line.h"

#include "modules/vehicle/src/car_parts.h"
#include "modules/vehicle/src/small_linear_system.h"

namespace jostle::modules::vehicle_detail {

using namespace physics;

namespace {

constexpr std::size_t unknowns_max = wheels_max + 1;
constexpr std::size_t constraints_max = wheels_max + 1 + differential_locks_max + 1;
constexpr int rounds_max = 4;

// Stiffness of sticking constraints relative to the inertia that they act on: a sticking constraint
// slips by its torque divided by this in a sub-step. A brake at 300 N m lets a wheel creep at 1e-7
// rad/s.
constexpr double brake_stiffness = 1e7, clutch_stiffness = 300, differential_lock_stiffness = 3000;

struct FrictionConstraint {
    std::array<std::uint8_t, unknowns_max> at;
    std::array<double, unknowns_max> weight;
    std::size_t size;
    double torque_max;  // N m
    double stiff;       // N m s/rad
    FrictionState grip;
    double initial_speed;  // rad/s, speed at the start of the sub-step
};
struct FrictionConstraints {
    std::array<FrictionConstraint, constraints_max> of;
    std::size_t count = 0;
};
using System = SmallLinearSystem<unknowns_max>;
using Speeds = std::array<double, unknowns_max>;

double speed_of(const FrictionConstraint& constraint, const Speeds& y) {
    double sum = 0;
    for (std::size_t k = 0; k < constraint.size; k++)
        sum += constraint.weight[k] * y[constraint.at[k]];
    return sum;
}

// It slips if its maximum torque cannot stop it within a sub-step.
FrictionState initial_friction_state(const FrictionConstraint& constraint, double inertia,
                                     double h) {
    if (absolute(constraint.initial_speed) * inertia <= h * constraint.torque_max)
        return FrictionState::sticking;
    return constraint.initial_speed > 0 ? FrictionState::slipping_forward
                                        : FrictionState::slipping_backward;
}

void add_brakes(const Car& car, double h, const DriveLineWheels& wheels,
                FrictionConstraints& constraints) {
    for (std::size_t i = 0; i < car.wheels.size(); i++) {
        const DriveLineWheel& wheel = wheels[i];
        if (wheel.brake <= 0) continue;
        FrictionConstraint& constraint = constraints.of[constraints.count++];
        constraint.at[0] = static_cast<std::uint8_t>(i);
        constraint.weight[0] = 1;
        constraint.size = 1;
        constraint.torque_max = wheel.brake;
        constraint.stiff = brake_stiffness * wheel.effective_inertia / h;
        constraint.initial_speed = wheel.spin;
        constraint.grip = initial_friction_state(constraint, wheel.inertia, h);
    }
}

// Couples the engine and the mean speed of the driven wheels.
void add_clutch(const Car& car, double h, const Speeds& y, FrictionConstraints& constraints) {
    const double ratio = current_gear_ratio(car), idle = car.def.engine.idle_speed;
    if (ratio == 0) return;
    // Engagement depends on the faster side. When starting, the engine speed engages the clutch;
    // when coasting in gear, the engine brakes the car.
    const double fastest = maximum(car.engine_speed, ratio * mean_driven_spin(car));
    const double pressed = clamp((fastest - 1.05 * idle) / (0.6 * idle), 0, 1);
    const double most = car.def.gearbox.clutch_torque * pressed * (1 - car.controls.clutch);
    if (most <= 0) return;
    FrictionConstraint& constraint = constraints.of[constraints.count++];
    constraint.size = 0;
    for (std::size_t i = 0; i < car.wheels.size(); i++) {
        if (car.def.wheels[i].drive_share <= 0) continue;
        constraint.at[constraint.size] = static_cast<std::uint8_t>(i);
        constraint.weight[constraint.size++] = -ratio * car.def.wheels[i].drive_share;
    }
    constraint.at[constraint.size] = static_cast<std::uint8_t>(car.wheels.size());
    constraint.weight[constraint.size++] = 1;
    constraint.torque_max = most;
    constraint.stiff = clutch_stiffness * car.def.engine.inertia / h;
    constraint.initial_speed = speed_of(constraint, y);
    constraint.grip = initial_friction_state(constraint, car.def.engine.inertia, h);
}

double add_group(const Car& car, const std::vector<std::uint32_t>& group, double sign,
                 FrictionConstraint& constraint) {
    double inertia = 0;
    for (const std::uint32_t wheel : group) {
        constraint.at[constraint.size] = static_cast<std::uint8_t>(wheel);
        constraint.weight[constraint.size++] = sign / static_cast<double>(group.size());
        inertia += car.def.wheels[wheel].inertia;
    }
    return inertia;
}

void add_differential_locks(const Car& car, double h, const Speeds& y,
                            FrictionConstraints& constraints) {
    const double drive = absolute(car.clutch_torque * current_gear_ratio(car));
    for (const DifferentialLock& coupling : car.def.differential_locks) {
        FrictionConstraint& constraint = constraints.of[constraints.count++];
        constraint.size = 0;
        const double inertia = add_group(car, coupling.first, 1, constraint) +
                               add_group(car, coupling.second, -1, constraint);
        const bool locked = coupling.kind == DifferentialLockKind::locked;
        constraint.torque_max = locked ? 1e12 : coupling.preload + coupling.ratio * drive;
        constraint.stiff = differential_lock_stiffness * inertia / h;
        constraint.initial_speed = speed_of(constraint, y);
        constraint.grip = initial_friction_state(constraint, inertia / 4, h);
    }
}

// The engine drives the left and right sides against each other.
void add_steering(const Car& car, double h, const Speeds& y, FrictionConstraints& constraints) {
    const SteeringDrive& drive = car.def.steering_drive;
    if (drive.left.empty()) return;
    FrictionConstraint& constraint = constraints.of[constraints.count++];
    constraint.size = 0;
    const double inertia =
        add_group(car, drive.left, 1, constraint) + add_group(car, drive.right, -1, constraint);
    constraint.at[constraint.size] = static_cast<std::uint8_t>(car.wheels.size());
    constraint.weight[constraint.size++] = -2 * drive.ratio * car.steering;
    constraint.torque_max = drive.torque;
    constraint.stiff = differential_lock_stiffness * inertia / h;
    constraint.initial_speed = speed_of(constraint, y);
    constraint.grip = initial_friction_state(constraint, inertia / 4, h);
}

// Equations without constraints.
void assemble(const Car& car, double h, const DriveLineWheels& wheels, double throttle,
              System& system) {
    const std::size_t engine = car.wheels.size();
    system.clear(engine + 1);
    const double lost =
        (1 - car.def.gearbox.efficiency) * maximum(car.clutch_torque, 0) * current_gear_ratio(car);
    for (std::size_t i = 0; i < engine; i++) {
        const DriveLineWheel& wheel = wheels[i];
        system.a[i][i] = wheel.effective_inertia;
        system.b[i] = wheel.effective_inertia * wheel.spin -
                      h * (wheel.radius * wheel.force + wheel.share * lost);
    }
    const Engine& made = car.def.engine;
    const double torque = throttle * torque_at(made, car.engine_speed);
    system.a[engine][engine] = made.inertia + h * made.friction * (1 - throttle);
    system.b[engine] = made.inertia * car.engine_speed + h * torque;
}

void add(const FrictionConstraint& constraint, double h, System& system) {
    if (constraint.grip != FrictionState::sticking) {
        const double push =
            h * (constraint.grip == FrictionState::slipping_forward ? constraint.torque_max
                                                                    : -constraint.torque_max);
        for (std::size_t k = 0; k < constraint.size; k++)
            system.b[constraint.at[k]] -= push * constraint.weight[k];
        return;
    }
    const double hold = h * constraint.stiff;
    for (std::size_t k = 0; k < constraint.size; k++)
        for (std::size_t l = 0; l < constraint.size; l++)
            if (constraint.at[l] <= constraint.at[k])
                system.a[constraint.at[k]][constraint.at[l]] +=
                    hold * constraint.weight[k] * constraint.weight[l];
}

// Returns true if the state of a constraint was guessed wrong.
bool update_friction_state(FrictionConstraint& constraint, const Speeds& y) {
    const double speed = speed_of(constraint, y);
    if (constraint.grip == FrictionState::sticking) {
        if (absolute(constraint.stiff * speed) <= constraint.torque_max) return false;
        constraint.grip =
            speed > 0 ? FrictionState::slipping_forward : FrictionState::slipping_backward;
        return true;
    }
    if (constraint.grip == FrictionState::slipping_forward ? speed >= 0 : speed <= 0) return false;
    constraint.grip = FrictionState::sticking;
    return true;
}

double torque_of(const FrictionConstraint& constraint, const Speeds& y) {
    if (constraint.grip == FrictionState::sticking)
        return clamp(constraint.stiff * speed_of(constraint, y), -constraint.torque_max,
                     constraint.torque_max);
    return constraint.grip == FrictionState::slipping_forward ? constraint.torque_max
                                                              : -constraint.torque_max;
}

// Throttle of the driver, the governor that keeps the engine idling, and the fuel cut above maximum
// speed.
double effective_throttle(const Car& car) {
    const Engine& engine = car.def.engine;
    const double speed = car.engine_speed;
    const double foot = car.shift_left > 0 ? 0 : car.controls.throttle * rider_throttle(car);
    const double governor = clamp((engine.idle_speed - speed) / (0.1 * engine.idle_speed), 0, 1);
    const double cut = clamp((engine.max_speed - speed) / (0.02 * engine.max_speed), 0, 1);
    return maximum(foot * cut, governor);
}

}  // namespace

double brake_torque(const Car& car, std::size_t wheel) {
    const Wheel& made = car.def.wheels[wheel];
    const double pedal = maximum(car.controls.brake * made.brake_torque,
                                 car.controls.hand_brake * made.hand_brake_torque);
    return rider_brake(car, wheel, maximum(pedal, car.steering * made.steering_brake));
}

double torque_at(const Engine& engine, double speed) {
    const std::vector<TorquePoint>& curve = engine.curve;
    if (speed <= curve.front().speed) return curve.front().torque;
    for (std::size_t k = 1; k < curve.size(); k++) {
        if (speed > curve[k].speed) continue;
        const TorquePoint &a = curve[k - 1], &b = curve[k];
        return a.torque + (b.torque - a.torque) * ((speed - a.speed) / (b.speed - a.speed));
    }
    return curve.back().torque;
}

double current_gear_ratio(const Car& car) {
    const Gearbox& gearbox = car.def.gearbox;
    if (car.gear == 0 || car.shift_left > 0) return 0;
    if (car.gear < 0) return -gearbox.reverse * gearbox.final_ratio;
    return gearbox.forward[static_cast<std::size_t>(car.gear) - 1] * gearbox.final_ratio;
}

double mean_driven_spin(const Car& car) {
    double sum = 0;
    for (std::size_t i = 0; i < car.wheels.size(); i++)
        sum += car.def.wheels[i].drive_share * car.wheels[i].spin;
    return sum;
}

void solve_drive_line(Car& car, double h, DriveLineWheels& wheels) {
    const std::size_t engine = car.wheels.size();
    Speeds y;
    for (std::size_t i = 0; i < engine; i++) {
        wheels[i].effective_inertia =
            wheels[i].inertia + h * wheels[i].radius * maximum(wheels[i].slope, 0);
        y[i] = wheels[i].spin;
    }
    y[engine] = car.engine_speed;
    FrictionConstraints constraints;
    add_brakes(car, h, wheels, constraints);
    const std::size_t clutch = constraints.count;
    add_clutch(car, h, y, constraints);
    const bool clutched = constraints.count > clutch;
    add_differential_locks(car, h, y, constraints);
    add_steering(car, h, y, constraints);

    const double throttle = effective_throttle(car);
    System system;
    for (int round = 0; round < rounds_max; round++) {
        assemble(car, h, wheels, throttle, system);
        for (std::size_t k = 0; k < constraints.count; k++) add(constraints.of[k], h, system);
        system.solve();
        y = system.b;
        bool again = false;
        for (std::size_t k = 0; k < constraints.count; k++)
            again = update_friction_state(constraints.of[k], y) || again;
        if (!again) break;
    }
    car.clutch_torque = clutched ? torque_of(constraints.of[clutch], y) : 0;
    car.engine_torque = throttle * torque_at(car.def.engine, car.engine_speed) -
                        (1 - throttle) * car.def.engine.friction * y[engine];
    car.engine_speed = clamp(y[engine], 0, 1e5);
    for (std::size_t i = 0; i < engine; i++) wheels[i].spin = clamp(y[i], -1e5, 1e5);
    // A wheel with a sticking brake has exactly zero spin.
    for (std::size_t k = 0; k < clutch; k++)
        if (constraints.of[k].grip == FrictionState::sticking)
            wheels[constraints.of[k].at[0]].spin = 0;
}

}  // namespace jostle::modules::vehicle_detail
