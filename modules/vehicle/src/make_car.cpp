// SPDX-License-Identifier: MIT
#include "modules/vehicle/src/car_parts.h"

#include "modules/vehicle/src/small_linear_system.h"

namespace jostle::modules::vehicle_detail {

using namespace physics;

namespace {

// Mass that rests on each wheel, kg: of all load distributions that balance the chassis, the one
// with the least sum of squares, load = p . (1, x, z), with wheels and centre of mass seen from
// above. The Lagrange multipliers p solve A p = (m, m x, m z), where A is the sum of (1, x, z)(1,
// x, z)^T.
std::vector<double> sprung_masses(const VehicleDef& def, Vec3 center, double mass) {
    SmallLinearSystem<3> system;
    system.clear(3);
    const auto row = [](Vec3 p) { return std::array<double, 3>{1, p.x, p.z}; };
    // Wheels in one line support nothing across it. A small stiffness keeps the system regular.
    for (std::size_t i = 0; i < 3; i++) system.a[i][i] = 1e-9;
    for (const Wheel& wheel : def.wheels) {
        const std::array<double, 3> at = row(wheel.attachment - center);
        for (std::size_t i = 0; i < 3; i++)
            for (std::size_t j = 0; j <= i; j++) system.a[i][j] += at[i] * at[j];
    }
    system.b = {mass, 0, 0};
    system.solve();
    std::vector<double> masses;
    for (const Wheel& wheel : def.wheels) {
        const std::array<double, 3> at = row(wheel.attachment - center);
        const double load = system.b[0] + system.b[1] * at[1] + system.b[2] * at[2];
        masses.push_back(maximum(load, 0.01 * mass));
    }
    return masses;
}

}  // namespace

Car make_car(const VehicleDef& def, const BodyState& chassis, Vec3 gravity) {
    Car car;
    car.def = def;
    const Vec3 center = apply_inverse(chassis.pose, chassis.center);
    const std::vector<double> masses = sprung_masses(def, center, chassis.mass);
    for (std::size_t k = 0; k < def.wheels.size(); k++) {
        Wheel& wheel = car.def.wheels[k];
        wheel.down = normalized(wheel.down);
        wheel.axle = normalized(wheel.axle);
        const double w = 2 * pi * wheel.suspension.frequency;
        WheelRuntime& run = car.wheels.emplace_back();
        run.stiffness = masses[k] * w * w;
        run.damping = 2 * wheel.suspension.damping * masses[k] * w;
    }
    car.engine_speed = def.engine.idle_speed;
    car.external_acceleration = gravity;
    car.speed = -dot(chassis.linear_velocity, rotate(chassis.pose.rotation, {0, 0, 1}));
    return car;
}

}  // namespace jostle::modules::vehicle_detail
