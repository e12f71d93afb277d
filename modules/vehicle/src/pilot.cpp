// SPDX-License-Identifier: MIT
#include "modules/vehicle/src/car_parts.h"

namespace jostle::modules::vehicle_detail {

using namespace physics;

namespace {

double wheel_base(const VehicleDef& def) {
    double front = 1e9, rear = -1e9;
    for (const Wheel& wheel : def.wheels) {
        front = minimum(front, wheel.attachment.z);
        rear = maximum(rear, wheel.attachment.z);
    }
    return rear - front;
}

}  // namespace

// Steers along the tangent of the circle, and back to the circle if the car is off it.
CarControls pilot_controls(const Car& car, const BodyState& chassis) {
    const Pilot& pilot = car.pilot;
    const Vec3 out{chassis.center.x - pilot.center.x, 0, chassis.center.z - pilot.center.z};
    const double distance = length(out);
    const Vec3 radial = distance > 0.1 ? out / distance : Vec3{1, 0, 0};
    const Vec3 along{radial.z, 0, -radial.x};
    const Vec3 course = normalized(along - radial * clamp((distance - pilot.radius) / 10, -1, 1));
    const Vec3 forward = rotate(chassis.pose.rotation, {0, 0, -1});
    const double left = cross(forward, course).y;
    const double off = dot(forward, course) < 0 ? (left < 0 ? -1 : 1) : left;
    const double angle = off + wheel_base(car.def) / pilot.radius;

    CarControls controls = car.controls;
    controls.steering = clamp(-angle / full_lock(car.def), -1, 1);
    const double slow = pilot.speed - car.speed;
    controls.throttle = clamp(0.15 + 0.3 * slow, 0, 1);
    controls.brake = clamp(-0.2 * (slow + 1), 0, 1);
    controls.hand_brake = 0;
    controls.clutch = 0;
    if (controls.gear < 1) controls.gear = 1;
    return controls;
}

CarControls driver_controls(const Car& car) {
    constexpr double stands = 0.5;  // m/s
    const double forward = car.driver_throttle, speed = car.speed;
    CarControls controls = car.controls;
    controls.steering = car.driver_steering;
    controls.hand_brake = (car.driver_buttons & 1) != 0 ? 1 : 0;
    controls.clutch = 0;
    const bool back = controls.gear < 0;
    if (forward < 0 && !back && speed < stands && car.def.gearbox.automatic) controls.gear = -1;
    if (forward > 0 && controls.gear < 1 && speed > -stands) controls.gear = 1;
    // Input along the gear is throttle, against it brake.
    const double along = controls.gear < 0 ? -forward : forward;
    controls.throttle = maximum(along, 0);
    controls.brake = maximum(-along, 0);
    return controls;
}

void apply_driver_input(Car& car, const Controls& controls) {
    constexpr std::uint32_t up = 4, down = 8;
    const std::uint32_t pressed = controls.buttons & ~car.driver_buttons;
    const auto top = static_cast<std::int32_t>(car.def.gearbox.forward.size());
    car.driver = Driver::player;
    car.driver_steering = controls.axes[0];
    car.driver_throttle = controls.axes[1];
    car.driver_buttons = controls.buttons;
    if (car.def.gearbox.automatic) return;
    if ((pressed & up) != 0 && car.controls.gear < top) car.controls.gear++;
    if ((pressed & down) != 0 && car.controls.gear > -1) car.controls.gear--;
}

}  // namespace jostle::modules::vehicle_detail
