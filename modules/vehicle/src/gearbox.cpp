// SPDX-License-Identifier: MIT
#include "modules/vehicle/src/car_parts.h"

#include "modules/vehicle/src/drive_line.h"

namespace jostle::modules::vehicle_detail {

using namespace physics;

namespace {

// m/s, maximum speed at which an automatic reverses direction
constexpr double reverse_speed_max = 1.5;

void shift(Car& car, std::int32_t gear) {
    if (gear == car.gear) return;
    car.gear = gear;
    car.shift_left = car.def.gearbox.shift_time;
    car.pause_left = car.shift_left + car.def.gearbox.shift_pause;
}

// Returns true if the clutch transmits. Otherwise the engine speed does not indicate the gear.
bool is_in_gear(const Car& car) {
    const double driven = current_gear_ratio(car) * mean_driven_spin(car);
    return absolute(car.engine_speed - driven) < 0.05 * car.engine_speed;
}

// Engine speed of an upshift, rad/s: higher with more throttle, and never so low that the next gear
// would shift down again.
double shift_up_speed(const Car& car) {
    const Gearbox& gearbox = car.def.gearbox;
    const auto gear = static_cast<std::size_t>(car.gear);
    const double step = gearbox.forward[gear - 1] / gearbox.forward[gear];
    const double for_throttle = gearbox.shift_up_speed * (0.5 + 0.5 * car.controls.throttle);
    return minimum(maximum(for_throttle, 1.25 * step * gearbox.shift_down_speed),
                   gearbox.shift_up_speed);
}

// Lowest gear in which the road does not overspeed the engine. A lower gear would brake the driven
// wheels with all that the clutch transmits, usually more than the tyres can take: at 60 m/s, first
// gear of a saloon would brake with 6,700 N m, while 2,500 N m lock the wheels. A car with sliding
// rear wheels loses directional stability.
std::int32_t lowest_forward(const Car& car) {
    const Gearbox& gearbox = car.def.gearbox;
    double radius = 0;
    for (const Wheel& wheel : car.def.wheels) radius += wheel.drive_share * wheel.radius;
    const auto top = static_cast<std::int32_t>(gearbox.forward.size());
    std::int32_t gear = 1;
    while (gear < top && radius > 0 &&
           gearbox.forward[static_cast<std::size_t>(gear) - 1] * gearbox.final_ratio * car.speed >
               car.def.engine.max_speed * radius)
        gear++;
    return gear;
}

std::int32_t next_forward(const Car& car) {
    const Gearbox& gearbox = car.def.gearbox;
    const std::int32_t lowest = lowest_forward(car);
    if (car.gear < 1) return absolute(car.speed) < reverse_speed_max || car.speed > 0 ? lowest : 0;
    if (car.gear < lowest) return lowest;
    if (car.pause_left > 0) return car.gear;
    const auto top = static_cast<std::int32_t>(gearbox.forward.size());
    if (car.engine_speed < gearbox.shift_down_speed && car.gear > lowest) {
        // The clutch has opened because of slow wheels: shifts down until it engages again.
        return car.gear - 1;
    }
    if (!is_in_gear(car)) return car.gear;
    if (car.gear < top && car.engine_speed > shift_up_speed(car)) return car.gear + 1;
    return car.gear;
}

std::int32_t target_gear(const Car& car) {
    const std::int32_t requested = car.controls.gear;
    const auto top = static_cast<std::int32_t>(car.def.gearbox.forward.size());
    if (!car.def.gearbox.automatic) return requested > top ? top : requested;
    if (requested == 0) return 0;
    if (requested < 0) return car.speed < reverse_speed_max ? -1 : 0;
    return next_forward(car);
}

}  // namespace

void choose_gear(Car& car, double dt) {
    car.shift_left = maximum(car.shift_left - dt, 0);
    car.pause_left = maximum(car.pause_left - dt, 0);
    if (car.shift_left > 0) return;
    shift(car, target_gear(car));
}

}  // namespace jostle::modules::vehicle_detail
