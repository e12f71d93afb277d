// SPDX-License-Identifier: MIT
#include "jostle/modules/vehicle.h"

#include <algorithm>

#include "jostle/physics/world.h"
#include "modules/vehicle/src/car_parts.h"

namespace jostle::modules {

using namespace physics;
using namespace vehicle_detail;

namespace {

constexpr int cars_at_once = 16;  // per task of a thread: about 20 us of ground queries

Error unknown_car(CarId car) {
    return {ErrorCode::not_found, "car " + std::to_string(car) + " does not exist"};
}

bool by_id(const Car& car, CarId id) {
    return car.id < id;
}

// rad, positive to the right.
double angle_of(const Car& car, std::size_t wheel) {
    return car.steering * car.def.wheels[wheel].max_steering_angle;
}

void steer(Car& car, double dt) {
    const double most = car.def.steering_rate * dt;
    const double target =
        car.def.balance.enabled ? balance_steering(car, dt) : car.controls.steering;
    car.steering += clamp(target - car.steering, -most, most);
    car.wheel_axes.resize(car.wheels.size());
    for (std::size_t k = 0; k < car.wheels.size(); k++) {
        const Wheel& wheel = car.def.wheels[k];
        const Vec3 back = cross(wheel.axle, -wheel.down);
        const SinCos turn = sin_cos(angle_of(car, k));
        car.wheel_axes[k] = {wheel.down, wheel.axle * turn.cos + back * turn.sin,
                             wheel.axle * turn.sin - back * turn.cos};
    }
}

// The ground under a sleeping car must exist and be asleep, otherwise the car wakes.
bool has_lost_ground(const World& world, const Car& car) {
    return std::any_of(car.wheels.begin(), car.wheels.end(), [&](const WheelRuntime& run) {
        if (!run.touches) return false;
        if (!world.contains(run.shape)) return true;
        const Result<BodyState> ground = world.body(run.ground);
        return !ground.ok() || ground->awake;
    });
}

// Only reads the world.
void begin_step(const World& world, const Queries& queries, const BodyState& chassis, double dt,
                Car& car) {
    if (car.driver == Driver::pilot) car.controls = pilot_controls(car, chassis);
    if (car.driver == Driver::player) car.controls = driver_controls(car);
    car.mass = chassis.mass;
    car.external_acceleration_max = 100 + 10 * length(world.gravity());
    car.inverse_inertia = inverse(chassis.inertia);
    choose_gear(car, dt);
    if (car.def.balance.enabled) measure_lean(chassis, car);
    steer(car, dt);
    if (car.bodies.empty()) find_wheel_ground(world, queries, chassis, dt, car);
}

WheelState state_of(const Car& car, std::size_t k) {
    const WheelRuntime& run = car.wheels[k];
    return {.touches = run.touches,
            .ground = run.ground,
            .point = run.point,
            .normal = run.normal,
            .travel = run.travel,
            .load = run.load,
            .force = {run.forward, run.lateral, 0},
            .spin = run.spin,
            .angle = run.angle,
            .steering = angle_of(car, k),
            .stiffness = run.stiffness,
            .damping = run.damping};
}

}  // namespace

Vehicles::Vehicles() = default;
Vehicles::~Vehicles() = default;

Car* Vehicles::find(CarId car) {
    const auto at = std::lower_bound(cars_.begin(), cars_.end(), car, by_id);
    return at != cars_.end() && at->id == car ? &*at : nullptr;
}
const Car* Vehicles::find(CarId car) const {
    const auto at = std::lower_bound(cars_.begin(), cars_.end(), car, by_id);
    return at != cars_.end() && at->id == car ? &*at : nullptr;
}

Result<CarId> Vehicles::add(World& world, const VehicleDef& def) {
    const std::string fault = validate(def);
    if (!fault.empty()) return invalid_argument(fault);
    const Result<BodyState> chassis = world.body(def.chassis);
    if (!chassis.ok()) return chassis.error();
    if (chassis->type != BodyType::dynamic)
        return Error{ErrorCode::failed_precondition, "chassis is not a dynamic body"};
    for (const Car& car : cars_)
        if (car.def.chassis == def.chassis)
            return Error{ErrorCode::already_exists,
                         "chassis already belongs to car " + std::to_string(car.id)};
    if (next_ == 0xffffffff)
        return Error{ErrorCode::resource_exhausted, "no car ids are left in this world"};
    Car car = make_car(def, *chassis, world.gravity());
    if (def.cast == WheelCast::body)
        if (Status made = make_body_wheels(world, car); !made.ok()) return made.error();
    car.id = next_++;
    return cars_.emplace_back(std::move(car)).id;
}

Status Vehicles::remove(World& world, CarId car) {
    Car* found = find(car);
    if (found == nullptr) return unknown_car(car);
    destroy_body_wheels(world, *found);
    cars_.erase(cars_.begin() + (found - cars_.data()));
    return {};
}

std::vector<CarId> Vehicles::cars() const {
    std::vector<CarId> ids;
    for (const Car& car : cars_) ids.push_back(car.id);
    return ids;
}

Status Vehicles::set_controls(World& world, CarId car, const CarControls& controls) {
    Car* found = find(car);
    if (found == nullptr) return unknown_car(car);
    const std::string fault = validate(controls);
    if (!fault.empty()) return invalid_argument(fault);
    found->driver = Driver::none;
    if (found->controls == controls) return {};
    if (Status woken = world.wake(found->def.chassis); !woken.ok()) return woken;
    found->controls = controls;
    return {};
}

Status Vehicles::set_pilot(World& world, CarId car, const Pilot& pilot) {
    Car* found = find(car);
    if (found == nullptr) return unknown_car(car);
    const std::string fault = validate(pilot);
    if (!fault.empty()) return invalid_argument(fault);
    if (Status woken = world.wake(found->def.chassis); !woken.ok()) return woken;
    found->driver = Driver::pilot;
    found->pilot = pilot;
    return {};
}

Result<CarState> Vehicles::state(CarId car) const {
    const Car* found = find(car);
    if (found == nullptr) return unknown_car(car);
    CarState state{.chassis = found->def.chassis,
                   .controls = found->controls,
                   .gear = found->gear,
                   .shifting = found->shift_left > 0,
                   .engine_speed = found->engine_speed,
                   .engine_torque = found->engine_torque,
                   .clutch_torque = found->clutch_torque,
                   .speed = found->speed};
    for (std::size_t k = 0; k < found->wheels.size(); k++)
        state.wheels.push_back(state_of(*found, k));
    return state;
}

Result<VehicleDef> Vehicles::def(CarId car) const {
    const Car* found = find(car);
    if (found == nullptr) return unknown_car(car);
    return found->def;
}

// Ground queries of the cars run in parallel on all threads; each writes only its own car.
void Vehicles::before_step(World& world, double dt) {
    std::size_t remaining = 0;
    std::vector<BodyState> bodies;
    bodies.reserve(cars_.size());
    for (std::size_t k = 0; k < cars_.size(); k++) {
        const Result<BodyState> chassis = world.body(cars_[k].def.chassis);
        // Removes cars whose chassis was destroyed or is no longer dynamic.
        if (!chassis.ok() || chassis->type != BodyType::dynamic) {
            destroy_body_wheels(world, cars_[k]);
            continue;
        }
        if (remaining != k) cars_[remaining] = std::move(cars_[k]);
        Car& car = cars_[remaining++];
        bodies.push_back(*chassis);
        car.active = chassis->awake;
        if (!chassis->awake && car.bodies.empty() && has_lost_ground(world, car))
            car.active = world.wake(car.def.chassis).ok();
        if (!car.active) car.has_expected_motion = false;
    }
    cars_.erase(cars_.begin() + static_cast<std::ptrdiff_t>(remaining), cars_.end());
    const Queries queries = world.queries();
    world.parallel_for(static_cast<int>(cars_.size()), cars_at_once, [&](int first, int last) {
        for (auto k = static_cast<std::size_t>(first); k < static_cast<std::size_t>(last); k++)
            if (cars_[k].active) begin_step(world, queries, bodies[k], dt, cars_[k]);
    });
    for (Car& car : cars_)
        if (car.active && !car.bodies.empty()) steer_and_brake(world, car);
}

void Vehicles::before_substep(SubstepContext& substep) {
    for (Car& car : cars_) {
        if (!car.active || !substep.contains(car.def.chassis)) continue;
        if (car.bodies.empty())
            step_car(substep, car);
        else
            drive_body_wheels(substep, car);
    }
}

// Applies the pending reaction to ground in other groups as a force over the next step. An impulse
// now would move it before its supports can react.
void Vehicles::after_step(World& world, double dt) {
    for (Car& car : cars_) {
        if (!car.active) continue;
        if (!car.bodies.empty()) {
            update_wheel_state(world, dt, car);
            continue;
        }
        for (std::size_t k = 0; k < car.grounds.size(); k++) {
            const Ground& ground = car.grounds[k];
            if (!ground.dynamic || ground.reaction_impulse == Vec3{}) continue;
            // A missing body is ignored.
            static_cast<void>(world.apply_force(car.wheels[k].ground, ground.reaction_impulse / dt,
                                                ground.point));
        }
    }
}

}  // namespace jostle::modules
