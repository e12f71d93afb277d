// SPDX-License-Identifier: MIT
//
// Unknown are the speeds y of all wheels and of the engine at the end of the sub-step:
//
//     I (y' - y) = h T - h R F(y')
//
// F is linear in the spin around what the tyre pushes now. What holds by friction (brake, clutch,
// coupling) is a link r, a row over y. While it holds it is a stiff damper of r.y', which adds
// h c r r^T to the matrix; when that asks for more than it can bear it slips, and pushes by just
// that. Which links hold is guessed from the speeds before and corrected until it agrees, so one
// solve is the rule. The matrix is symmetric and positive definite whatever holds.
#include "modules/vehicle/src/drive_line.h"

#include "modules/vehicle/src/balance.h"
#include "modules/vehicle/src/small_solve.h"

namespace jostle::modules::vehicle_detail {

using namespace physics;

namespace {

constexpr std::size_t unknowns_max = wheels_max + 1;
constexpr std::size_t links_max = wheels_max + 1 + differential_locks_max + 1;
constexpr int rounds_max = 4;

// How stiff links are while they hold, against the inertia that they hold: what a link that holds
// slips in a sub-step is its torque over this. A brake at 300 N m lets a wheel creep by 1e-7 rad/s.
constexpr double brake_stiffness = 1e7, clutch_stiffness = 300, differential_lock_stiffness = 3000;

struct FrictionConstraint {
    std::array<std::uint8_t, unknowns_max> at;
    std::array<double, unknowns_max> weight;
    std::size_t size;
    double most;   // N m
    double stiff;  // N m s/rad
    FrictionState grip;
    double before;  // rad/s: its speed at the start
};
struct FrictionConstraints {
    std::array<FrictionConstraint, links_max> of;
    std::size_t count = 0;
};
using System = SmallSystem<unknowns_max>;
using Speeds = std::array<double, unknowns_max>;

double speed_of(const FrictionConstraint& link, const Speeds& y) {
    double sum = 0;
    for (std::size_t k = 0; k < link.size; k++) sum += link.weight[k] * y[link.at[k]];
    return sum;
}

// Slips if a sub-step of all that it bears does not stop it.
FrictionState guess(const FrictionConstraint& link, double inertia, double h) {
    if (absolute(link.before) * inertia <= h * link.most) return FrictionState::holds;
    return link.before > 0 ? FrictionState::slipping_forward : FrictionState::slipping_backward;
}

void add_brakes(const Car& car, double h, const DriveLineWheels& wheels, FrictionConstraints& links) {
    for (std::size_t i = 0; i < car.wheels.size(); i++) {
        const DriveLineWheel& wheel = wheels[i];
        if (wheel.brake <= 0) continue;
        FrictionConstraint& link = links.of[links.count++];
        link.at[0] = static_cast<std::uint8_t>(i);
        link.weight[0] = 1;
        link.size = 1;
        link.most = wheel.brake;
        link.stiff = brake_stiffness * wheel.effective_inertia / h;
        link.before = wheel.spin;
        link.grip = guess(link, wheel.inertia, h);
    }
}

// Between the engine and the mean of what is driven.
void add_clutch(const Car& car, double h, const Speeds& y, FrictionConstraints& links) {
    const double ratio = ratio_now(car), idle = car.def.engine.idle;
    if (ratio == 0) return;
    // By the faster side: who sets off lets the clutch in by the engine's speed, who rolls in gear
    // is braked by the engine.
    const double fastest = maximum(car.engine_speed, ratio * mean_driven_spin(car));
    const double pressed = clamp((fastest - 1.05 * idle) / (0.6 * idle), 0, 1);
    const double most = car.def.gearbox.clutch_torque * pressed * (1 - car.controls.clutch);
    if (most <= 0) return;
    FrictionConstraint& link = links.of[links.count++];
    link.size = 0;
    for (std::size_t i = 0; i < car.wheels.size(); i++) {
        if (car.def.wheels[i].drive_share <= 0) continue;
        link.at[link.size] = static_cast<std::uint8_t>(i);
        link.weight[link.size++] = -ratio * car.def.wheels[i].drive_share;
    }
    link.at[link.size] = static_cast<std::uint8_t>(car.wheels.size());
    link.weight[link.size++] = 1;
    link.most = most;
    link.stiff = clutch_stiffness * car.def.engine.inertia / h;
    link.before = speed_of(link, y);
    link.grip = guess(link, car.def.engine.inertia, h);
}

double add_group(const Car& car, const std::vector<std::uint32_t>& group, double sign, FrictionConstraint& link) {
    double inertia = 0;
    for (const std::uint32_t wheel : group) {
        link.at[link.size] = static_cast<std::uint8_t>(wheel);
        link.weight[link.size++] = sign / static_cast<double>(group.size());
        inertia += car.def.wheels[wheel].inertia;
    }
    return inertia;
}

void add_differential_locks(const Car& car, double h, const Speeds& y, FrictionConstraints& links) {
    const double drive = absolute(car.clutch_torque * ratio_now(car));
    for (const DifferentialLock& coupling : car.def.differential_locks) {
        FrictionConstraint& link = links.of[links.count++];
        link.size = 0;
        const double inertia =
            add_group(car, coupling.first, 1, link) + add_group(car, coupling.second, -1, link);
        const bool locked = coupling.kind == DifferentialLockKind::locked;
        link.most = locked ? 1e12 : coupling.preload + coupling.ratio * drive;
        link.stiff = differential_lock_stiffness * inertia / h;
        link.before = speed_of(link, y);
        link.grip = guess(link, inertia / 4, h);
    }
}

// The engine drives left and right against each other.
void add_steering(const Car& car, double h, const Speeds& y, FrictionConstraints& links) {
    const SteeringDrive& drive = car.def.steering_drive;
    if (drive.left.empty()) return;
    FrictionConstraint& link = links.of[links.count++];
    link.size = 0;
    const double inertia =
        add_group(car, drive.left, 1, link) + add_group(car, drive.right, -1, link);
    link.at[link.size] = static_cast<std::uint8_t>(car.wheels.size());
    link.weight[link.size++] = -2 * drive.ratio * car.steering;
    link.most = drive.torque;
    link.stiff = differential_lock_stiffness * inertia / h;
    link.before = speed_of(link, y);
    link.grip = guess(link, inertia / 4, h);
}

// Without links.
void assemble(const Car& car, double h, const DriveLineWheels& wheels, double throttle, System& system) {
    const std::size_t engine = car.wheels.size();
    system.clear(engine + 1);
    const double lost =
        (1 - car.def.gearbox.efficiency) * maximum(car.clutch_torque, 0) * ratio_now(car);
    for (std::size_t i = 0; i < engine; i++) {
        const DriveLineWheel& wheel = wheels[i];
        system.a[i][i] = wheel.effective_inertia;
        system.b[i] =
            wheel.effective_inertia * wheel.spin - h * (wheel.radius * wheel.force + wheel.share * lost);
    }
    const Engine& made = car.def.engine;
    const double torque = throttle * torque_at(made, car.engine_speed);
    system.a[engine][engine] = made.inertia + h * made.friction * (1 - throttle);
    system.b[engine] = made.inertia * car.engine_speed + h * torque;
}

void add(const FrictionConstraint& link, double h, System& system) {
    if (link.grip != FrictionState::holds) {
        const double push = h * (link.grip == FrictionState::slipping_forward ? link.most : -link.most);
        for (std::size_t k = 0; k < link.size; k++) system.b[link.at[k]] -= push * link.weight[k];
        return;
    }
    const double hold = h * link.stiff;
    for (std::size_t k = 0; k < link.size; k++)
        for (std::size_t l = 0; l < link.size; l++)
            if (link.at[l] <= link.at[k])
                system.a[link.at[k]][link.at[l]] += hold * link.weight[k] * link.weight[l];
}

// Whether a link was not as guessed.
bool corrected(FrictionConstraint& link, const Speeds& y) {
    const double speed = speed_of(link, y);
    if (link.grip == FrictionState::holds) {
        if (absolute(link.stiff * speed) <= link.most) return false;
        link.grip = speed > 0 ? FrictionState::slipping_forward : FrictionState::slipping_backward;
        return true;
    }
    if (link.grip == FrictionState::slipping_forward ? speed >= 0 : speed <= 0) return false;
    link.grip = FrictionState::holds;
    return true;
}

double torque_of(const FrictionConstraint& link, const Speeds& y) {
    if (link.grip == FrictionState::holds)
        return clamp(link.stiff * speed_of(link, y), -link.most, link.most);
    return link.grip == FrictionState::slipping_forward ? link.most : -link.most;
}

// The driver's foot, the governor that keeps the engine idling, and the cut beyond its most.
double throttle_now(const Car& car) {
    const Engine& engine = car.def.engine;
    const double speed = car.engine_speed;
    const double foot = car.shift_left > 0 ? 0 : car.controls.throttle * rider_throttle(car);
    const double governor = clamp((engine.idle - speed) / (0.1 * engine.idle), 0, 1);
    const double cut = clamp((engine.most - speed) / (0.02 * engine.most), 0, 1);
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

double ratio_now(const Car& car) {
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
        wheels[i].effective_inertia = wheels[i].inertia + h * wheels[i].radius * maximum(wheels[i].slope, 0);
        y[i] = wheels[i].spin;
    }
    y[engine] = car.engine_speed;
    FrictionConstraints links;
    add_brakes(car, h, wheels, links);
    const std::size_t clutch = links.count;
    add_clutch(car, h, y, links);
    const bool clutched = links.count > clutch;
    add_differential_locks(car, h, y, links);
    add_steering(car, h, y, links);

    const double throttle = throttle_now(car);
    System system;
    for (int round = 0; round < rounds_max; round++) {
        assemble(car, h, wheels, throttle, system);
        for (std::size_t k = 0; k < links.count; k++) add(links.of[k], h, system);
        system.solve();
        y = system.b;
        bool again = false;
        for (std::size_t k = 0; k < links.count; k++) again = corrected(links.of[k], y) || again;
        if (!again) break;
    }
    car.clutch_torque = clutched ? torque_of(links.of[clutch], y) : 0;
    car.engine_torque = throttle * torque_at(car.def.engine, car.engine_speed) -
                        (1 - throttle) * car.def.engine.friction * y[engine];
    car.engine_speed = clamp(y[engine], 0, 1e5);
    for (std::size_t i = 0; i < engine; i++) wheels[i].spin = clamp(y[i], -1e5, 1e5);
    // What a brake holds stands still.
    for (std::size_t k = 0; k < clutch; k++)
        if (links.of[k].grip == FrictionState::holds) wheels[links.of[k].at[0]].spin = 0;
}

}  // namespace jostle::modules::vehicle_detail
