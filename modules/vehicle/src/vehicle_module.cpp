// SPDX-License-Identifier: MIT
//
// Vehicles as a module: serialization, scene settings and client channels.
#include <algorithm>

#include "jostle/modules/settings.h"
#include "jostle/modules/vehicle.h"
#include "jostle/physics/world.h"
#include "modules/vehicle/src/car_parts.h"

namespace jostle::modules {

using namespace physics;
using namespace vehicle_detail;

namespace {

constexpr std::size_t scene_cars = 16;

std::string name_of(std::size_t car) {
    return car == 0 ? "car" : "car" + std::to_string(car + 1);
}

// Settings that a scene gives for all of its cars.
struct SceneCars {
    SaloonDef saloon;
    double make = 0, power = 1, cast = 2;
    CarControls controls;
    Pilot pilot{.center = {}, .radius = 0, .speed = 10};
    std::array<BodyId, scene_cars> bodies;
};

Status read(const ModuleSettings& given, SceneCars& cars) {
    SettingsReader settings(given);
    Wheel& wheel = cars.saloon.wheel;
    settings.number("make", cars.make, 0, 2);
    settings.number("track", cars.saloon.track, 0.1, 20);
    settings.number("wheel_base", cars.saloon.wheel_base, 0.1, 50);
    settings.number("height", cars.saloon.height, -10, 10);
    settings.number("radius", wheel.radius, 0.02, 10);
    settings.number("width", wheel.width, 0.01, 10);
    settings.number("shortest", wheel.suspension.min_length, -10, 10);
    settings.number("longest", wheel.suspension.max_length, -10, 10);
    settings.number("frequency", wheel.suspension.frequency, 0.1, 100);
    settings.number("damping", wheel.suspension.damping, 0, 10);
    settings.number("friction", wheel.tyre.friction, 0, 10);
    settings.number("front_drive", cars.saloon.front_drive, 0, 1);
    settings.number("steering_most", cars.saloon.max_steering_angle, 0, 1.4);
    settings.number("anti_roll", cars.saloon.anti_roll, 0, 1e7);
    settings.number("power_scale", cars.power, 0, 100);
    settings.number("cast", cars.cast, 0, 3);
    settings.number("throttle", cars.controls.throttle, 0, 1);
    settings.number("brake", cars.controls.brake, 0, 1);
    settings.number("steering", cars.controls.steering, -1, 1);
    settings.number("pilot_radius", cars.pilot.radius, 4, 1e4);
    settings.number("pilot_speed", cars.pilot.speed, 0, 200);
    for (std::size_t k = 0; k < scene_cars; k++) settings.body(name_of(k), cars.bodies[k]);
    return settings.finish();
}

// Creates a saloon, or another type of car from the numbers that apply to it.
VehicleDef make_of(const SceneCars& cars, BodyId chassis) {
    SaloonDef of = cars.saloon;
    of.chassis = chassis;
    if (cars.make < 0.5) return saloon(of);
    if (cars.make < 1.5) {
        VehicleDef tank = tracked({.chassis = chassis,
                                   .gauge = of.track,
                                   .length = of.wheel_base,
                                   .height = of.height,
                                   .wheel = of.wheel});
        tank.gearbox.forward = {16, 8, 4};
        tank.gearbox.reverse = 16;
        return tank;
    }
    return motorcycle({.chassis = chassis,
                       .wheel_base = of.wheel_base,
                       .height = of.height,
                       .wheel = of.wheel,
                       .max_steering_angle = of.max_steering_angle});
}

VehicleDef def_of(const SceneCars& cars, BodyId chassis) {
    VehicleDef def = make_of(cars, chassis);
    for (TorquePoint& point : def.engine.curve) point.torque *= cars.power;
    if (def.balance.enabled) return def;
    def.cast = cars.cast < 0.5   ? WheelCast::ray
               : cars.cast < 1.5 ? WheelCast::sphere
               : cars.cast < 2.5 ? WheelCast::cylinder
                                 : WheelCast::body;
    return def;
}

void publish_wheel(const Wheel& wheel, const WheelRuntime& run, double angle,
                   ChannelWriter& channels) {
    channels.quantized(wheel.radius, 0, 2, 8);
    channels.quantized(wheel.width, 0, 1, 8);
    const Vec3 center = wheel.attachment + wheel.down * (wheel.suspension.max_length - run.travel);
    for (const double x : {center.x, center.y, center.z}) channels.quantized(x, -8, 8, 16);
    const double limit = run.friction * run.load;
    const bool slides =
        run.touches && run.forward * run.forward + run.lateral * run.lateral > 0.9 * limit * limit;
    channels.value((run.touches ? 1 : 0) + (slides ? 2 : 0));
    channels.quantized(run.angle, 0, 2 * pi, 16);
    channels.quantized(run.spin, -400, 400, 16);
    channels.quantized(angle, -pi / 2, pi / 2, 16);
}

}  // namespace

VehicleDef saloon(const SaloonDef& def) {
    VehicleDef made{.chassis = def.chassis};
    for (int k = 0; k < 4; k++) {
        const bool front = k < 2, left = k % 2 == 0;
        Wheel wheel = def.wheel;
        wheel.attachment = {(left ? -0.5 : 0.5) * def.track, def.height,
                            def.center_z + (front ? -0.5 : 0.5) * def.wheel_base};
        wheel.max_steering_angle = front ? def.max_steering_angle : 0;
        wheel.drive_share = 0.5 * (front ? def.front_drive : 1 - def.front_drive);
        wheel.hand_brake_torque = front ? 0 : def.hand_brake_torque;
        made.wheels.push_back(wheel);
    }
    made.anti_roll_bars = {{0, 1, def.anti_roll}, {2, 3, def.anti_roll}};
    if (def.front_drive < 1) made.differential_locks.push_back({.first = {2}, .second = {3}});
    return made;
}

VehicleDef tracked(const TrackedDef& def) {
    VehicleDef made{.chassis = def.chassis};
    const std::uint32_t wheels = def.wheels < 2 ? 2 : def.wheels > 8 ? 8 : def.wheels;
    for (std::uint32_t k = 0; k < 2 * wheels; k++) {
        const bool left = k < wheels;
        const double along = static_cast<double>(k % wheels) / (wheels - 1) - 0.5;
        Wheel wheel = def.wheel;
        wheel.attachment = {(left ? -0.5 : 0.5) * def.gauge, def.height,
                            def.center_z + along * def.length};
        wheel.drive_share = 0.5 / wheels;
        wheel.steering_brake = left ? -def.steering_brake : def.steering_brake;
        if (def.steering_ratio > 0)
            (left ? made.steering_drive.left : made.steering_drive.right).push_back(k);
        made.wheels.push_back(wheel);
        if (k % wheels > 0)
            made.differential_locks.push_back(
                {.first = {k - 1}, .second = {k}, .kind = DifferentialLockKind::locked});
    }
    made.steering_drive.ratio = def.steering_ratio;
    made.steering_drive.torque = def.steering_torque;
    return made;
}

VehicleDef motorcycle(const MotorcycleDef& def) {
    VehicleDef made{.chassis = def.chassis};
    for (const bool front : {true, false}) {
        Wheel wheel = def.wheel;
        wheel.attachment = {0, def.height, def.center_z + (front ? -0.5 : 0.5) * def.wheel_base};
        wheel.max_steering_angle = front ? def.max_steering_angle : 0;
        wheel.drive_share = front ? 0 : 1;
        wheel.crown = minimum(0.5 * wheel.width, wheel.radius);
        made.wheels.push_back(wheel);
    }
    made.balance.enabled = true;
    made.cast = WheelCast::ray;
    made.steering_rate = 20;
    made.aerodynamics.drag_area = 0.4;
    return made;
}

Status Vehicles::configure(World& world, const ModuleSettings& settings) {
    SceneCars cars;
    if (Status good = read(settings, cars); !good.ok()) return good;
    for (std::size_t k = 0; k < scene_cars; k++) {
        if (is_null(cars.bodies[k])) continue;
        const Result<CarId> car = add(world, def_of(cars, cars.bodies[k]));
        if (!car.ok()) return Error{car.error().code, name_of(k) + ": " + car.error().message};
        if (Status good = set_controls(world, *car, cars.controls); !good.ok()) return good;
        if (cars.pilot.radius < 4) continue;
        if (Status good = set_pilot(world, *car, cars.pilot); !good.ok()) return good;
    }
    return {};
}

bool Vehicles::is_controllable(BodyId body) const {
    return std::any_of(cars_.begin(), cars_.end(),
                       [&](const Car& car) { return car.def.chassis == body; });
}

void Vehicles::control(World& world, BodyId body, const Controls& controls) {
    for (Car& car : cars_) {
        if (car.def.chassis != body) continue;
        apply_driver_input(car, controls);
        // A missing body is ignored: the car is removed in the next step.
        static_cast<void>(world.wake(body));
    }
}

bool Vehicles::visit_controlled_entity(World& world, BodyId body, StateVisitor& v) {
    const auto at = std::find_if(cars_.begin(), cars_.end(),
                                 [&](const Car& car) { return car.def.chassis == body; });
    const bool known = at != cars_.end();
    if (!v.loading()) {
        if (!known || !at->bodies.empty()) return false;
        visit_car(v, *at);
        return true;
    }
    const Result<BodyState> chassis = world.body(body);
    if (!chassis.ok() || chassis->type != BodyType::dynamic || next_ == 0xffffffff) return false;
    Car car;
    visit_car(v, car);
    if (v.failed() || car.def.chassis != body || !car.bodies.empty()) return false;
    if (known && !at->bodies.empty()) return false;
    car.id = known ? at->id : next_++;
    if (known)
        *at = std::move(car);
    else
        cars_.push_back(std::move(car));
    return true;
}

void Vehicles::visit(StateVisitor& v) {
    v.field("next", next_);
    v.all("cars", cars_, [&](Car& car) { visit_car(v, car); });
    if (!v.loading()) return;
    for (std::size_t k = 0; k < cars_.size(); k++) {
        if (cars_[k].id >= next_ || cars_[k].id == 0)
            v.fail("cars", "has an id that was not assigned yet");
        if (k > 0 && cars_[k].id <= cars_[k - 1].id) v.fail("cars", "is not sorted by id");
    }
}

void Vehicles::publish(const World&, ChannelWriter& channels) const {
    for (const Car& car : cars_) {
        if (!channels.begin(0, car.def.chassis)) continue;
        channels.value(car.gear);
        channels.quantized(car.engine_speed / car.def.engine.max_speed, 0, 1, 8);
        for (std::size_t k = 0; k < car.wheels.size(); k++)
            publish_wheel(car.def.wheels[k], car.wheels[k],
                          car.steering * car.def.wheels[k].max_steering_angle, channels);
    }
}

}  // namespace jostle::modules
