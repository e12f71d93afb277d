// SPDX-License-Identifier: MIT
#include "modules/vehicle/src/car_parts.h"

#include <cstdio>

namespace jostle::modules::vehicle_detail {

using namespace physics;

namespace {

// Stores the first error.
class Check {
public:
    void number(const char* name, double value, double low, double high) {
        if (value >= low && value <= high) return;
        char text[96];
        std::snprintf(text, sizeof text, " is %.10g; it must be from %.10g to %.10g", value, low,
                      high);
        fail(std::string(name) + text);
    }
    void vector(const char* name, Vec3 value, double most) {
        number(name, value.x, -most, most);
        number(name, value.y, -most, most);
        number(name, value.z, -most, most);
    }
    void that(bool holds, const char* message) {
        if (!holds) fail(message);
    }
    void enter(const char* list, std::size_t index) {
        path_ = std::string(list) + "[" + std::to_string(index) + "].";
    }
    void enter(const char* part) { path_ = std::string(part) + "."; }
    void leave() { path_.clear(); }
    std::string fault() const { return fault_; }

private:
    void fail(const std::string& what) {
        if (fault_.empty()) fault_ = path_ + what;
    }
    std::string path_, fault_;
};

void check_tyre(const Tyre& tyre, Check& check) {
    check.number("tyre.friction", tyre.friction, 0, 10);
    check.number("tyre.longitudinal_stiffness", tyre.longitudinal_stiffness, 1, 100);
    check.number("tyre.cornering_stiffness", tyre.cornering_stiffness, 1, 100);
    check.number("tyre.relaxation_length", tyre.relaxation_length, 0.02, 3);
    check.number("tyre.damping", tyre.damping, 0, 2);
    check.number("tyre.rolling_resistance", tyre.rolling_resistance, 0, 0.5);
    check.number("tyre.friction_rule", static_cast<double>(tyre.friction_rule), 0,
                 static_cast<double>(Combine::maximum));
}

void check_suspension(const Suspension& suspension, Check& check) {
    check.number("suspension.min_length", suspension.min_length, -10, 10);
    check.number("suspension.max_length", suspension.max_length, -10, 10);
    check.that(suspension.max_length - suspension.min_length >= 1e-3,
               "suspension.max_length must be at least 0.001 m more than suspension.min_length");
    check.number("suspension.frequency", suspension.frequency, 0.1, 100);
    check.number("suspension.damping", suspension.damping, 0, 10);
    check.number("suspension.preload", suspension.preload, 0, 1e7);
}

void check_wheel(const Wheel& wheel, Check& check) {
    check.vector("attachment", wheel.attachment, 100);
    check.vector("down", wheel.down, 1e3);
    check.vector("axle", wheel.axle, 1e3);
    check.that(length(wheel.down) > 1e-6, "down is zero; it must have a length");
    check.that(length(wheel.axle) > 1e-6, "axle is zero; it must have a length");
    check.that(
        absolute(dot(wheel.down, wheel.axle)) < 1e-3 * length(wheel.down) * length(wheel.axle),
        "axle is not perpendicular to down");
    check.number("radius", wheel.radius, 0.02, 10);
    check.number("width", wheel.width, 0.01, 10);
    check.number("inertia", wheel.inertia, 0.001, 1e5);
    check.number("mass", wheel.mass, 0.01, 1e6);
    check.number("max_steering_angle", wheel.max_steering_angle, -1.4, 1.4);
    check.number("drive_share", wheel.drive_share, 0, 1);
    check.number("brake_torque", wheel.brake_torque, 0, 1e7);
    check.number("hand_brake_torque", wheel.hand_brake_torque, 0, 1e7);
    check.number("steering_brake", wheel.steering_brake, -1e7, 1e7);
    check.number("crown", wheel.crown, 0, wheel.radius);
    check_suspension(wheel.suspension, check);
    check_tyre(wheel.tyre, check);
}

void check_wheels(const VehicleDef& def, Check& check) {
    check.number("wheels", static_cast<double>(def.wheels.size()), 1, wheels_max);
    double share = 0;
    for (std::size_t k = 0; k < def.wheels.size(); k++) {
        check.enter("wheels", k);
        check_wheel(def.wheels[k], check);
        share += def.wheels[k].drive_share;
    }
    check.leave();
    check.that(absolute(share) < 1e-6 || absolute(share - 1) < 1e-6,
               "wheels: drive_share of all wheels must sum to 0 or 1");
}

void check_anti_roll_bars(const VehicleDef& def, Check& check) {
    check.number("anti_roll_bars", static_cast<double>(def.anti_roll_bars.size()), 0,
                 anti_roll_bars_max);
    const double last = static_cast<double>(def.wheels.size()) - 1;
    for (std::size_t k = 0; k < def.anti_roll_bars.size(); k++) {
        const AntiRollBar& bar = def.anti_roll_bars[k];
        check.enter("anti_roll_bars", k);
        check.number("left", bar.left, 0, last);
        check.number("right", bar.right, 0, last);
        check.that(bar.left != bar.right, "left and right must be different wheels");
        check.number("stiffness", bar.stiffness, 0, 1e7);
    }
    check.leave();
}

// Two disjoint groups of wheels.
bool check_groups(const VehicleDef& def, const std::vector<std::uint32_t>& first,
                  const std::vector<std::uint32_t>& second, Check& check) {
    std::array<bool, wheels_max> taken{};
    for (const auto* group : {&first, &second}) {
        check.number("wheels", static_cast<double>(group->size()), 1, wheels_max - 1);
        for (const std::uint32_t wheel : *group) {
            const bool known = wheel < def.wheels.size() && wheel < wheels_max;
            check.that(known, "wheels contains an index that is not a wheel");
            if (!known) return false;
            check.that(!taken[wheel], "wheels contains a wheel twice");
            taken[wheel] = true;
        }
    }
    return true;
}

void check_differential_locks(const VehicleDef& def, Check& check) {
    check.number("differential_locks", static_cast<double>(def.differential_locks.size()), 0,
                 differential_locks_max);
    for (std::size_t k = 0; k < def.differential_locks.size(); k++) {
        const DifferentialLock& coupling = def.differential_locks[k];
        check.enter("differential_locks", k);
        if (!check_groups(def, coupling.first, coupling.second, check)) return;
        check.number("kind", static_cast<double>(coupling.kind), 0, 1);
        check.number("preload", coupling.preload, 0, 1e7);
        check.number("ratio", coupling.ratio, 0, 10);
    }
    check.leave();
}

void check_steering_drive(const VehicleDef& def, Check& check) {
    const SteeringDrive& drive = def.steering_drive;
    check.enter("steering_drive");
    if (!drive.left.empty() || !drive.right.empty())
        check_groups(def, drive.left, drive.right, check);
    check.number("ratio", drive.ratio, 0, 100);
    check.number("torque", drive.torque, 0, 1e8);
    check.leave();
}

void check_engine(const Engine& engine, Check& check) {
    check.enter("engine");
    check.number("curve", static_cast<double>(engine.curve.size()), 1, curve_points_max);
    double previous = -1;
    for (const TorquePoint& point : engine.curve) {
        check.number("curve.speed", point.speed, 0, 1e4);
        check.number("curve.torque", point.torque, -1e6, 1e6);
        check.that(point.speed > previous, "curve.speed must be strictly increasing");
        previous = point.speed;
    }
    check.number("inertia", engine.inertia, 0.001, 1e5);
    check.number("idle_speed", engine.idle_speed, 1, 5000);
    check.number("max_speed", engine.max_speed, 1, 1e4);
    check.that(engine.max_speed > engine.idle_speed, "max_speed must be greater than idle_speed");
    check.number("friction", engine.friction, 0, 1e4);
    check.leave();
}

void check_gearbox(const Gearbox& gearbox, Check& check) {
    check.enter("gearbox");
    check.number("forward", static_cast<double>(gearbox.forward.size()), 1, gears_max);
    for (const double ratio : gearbox.forward) check.number("forward", ratio, 0.01, 1000);
    check.number("reverse", gearbox.reverse, 0.01, 1000);
    check.number("final_ratio", gearbox.final_ratio, 0.01, 1000);
    check.number("efficiency", gearbox.efficiency, 0.1, 1);
    check.number("shift_time", gearbox.shift_time, 0, 10);
    check.number("shift_pause", gearbox.shift_pause, 0, 100);
    check.number("shift_up_speed", gearbox.shift_up_speed, 0, 1e4);
    check.number("shift_down_speed", gearbox.shift_down_speed, 0, 1e4);
    check.that(gearbox.shift_down_speed < gearbox.shift_up_speed,
               "shift_down_speed must be less than shift_up_speed");
    check.number("clutch_torque", gearbox.clutch_torque, 1, 1e7);
    check.leave();
}

void check_aerodynamics(const VehicleDef& def, Check& check) {
    check.enter("aerodynamics");
    check.number("drag_area", def.aerodynamics.drag_area, 0, 1000);
    check.number("downforce_area", def.aerodynamics.downforce_area, 0, 1000);
    check.number("density", def.aerodynamics.density, 0, 2000);
    check.leave();
    check.enter("balance");
    check.number("max_lean_angle", def.balance.max_lean_angle, 0, 1.2);
    check.number("frequency", def.balance.frequency, 0.1, 5);
    check.number("feet_speed_max", def.balance.feet_speed_max, 0, 20);
    check.leave();
    check.number("cast", static_cast<double>(def.cast), 0, static_cast<double>(WheelCast::body));
    check.that(def.cast != WheelCast::body || !def.balance.enabled,
               "balance.enabled is not supported with cast body; use ray, sphere or cylinder");
    check.number("steering_rate", def.steering_rate, 0.01, 1000);
    check.number("rate", def.rate, 10, 1e5);
}

bool is_unit(Vec3 axis) {
    return absolute(length_squared(axis) - 1) < 1e-9;
}

void check_wheel_runtime(const WheelRuntime& run, Check& check) {
    check.number("stiffness", run.stiffness, 0, 1e15);
    check.number("damping", run.damping, 0, 1e15);
    check.number("spin", run.spin, -1e5, 1e5);
    check.number("angle", run.angle, 0, 7);
    check.number("longitudinal_deflection", run.longitudinal_deflection, -1e3, 1e3);
    check.number("lateral_deflection", run.lateral_deflection, -1e3, 1e3);
    check.number("travel", run.travel, 0, 1e4);
    check.number("load", run.load, 0, 1e30);
    check.number("forward", run.forward, -1e30, 1e30);
    check.number("lateral", run.lateral, -1e30, 1e30);
    check.number("friction", run.friction, 0, 100);
    check.vector("point", run.point, 1e8);
    check.vector("normal", run.normal, 1.001);
}

}  // namespace

std::string validate(const VehicleDef& def) {
    Check check;
    check_wheels(def, check);
    check_anti_roll_bars(def, check);
    check_differential_locks(def, check);
    check_steering_drive(def, check);
    check_engine(def.engine, check);
    check_gearbox(def.gearbox, check);
    check_aerodynamics(def, check);
    return check.fault();
}

std::string validate(const CarControls& controls) {
    Check check;
    check.number("throttle", controls.throttle, 0, 1);
    check.number("brake", controls.brake, 0, 1);
    check.number("hand_brake", controls.hand_brake, 0, 1);
    check.number("steering", controls.steering, -1, 1);
    check.number("clutch", controls.clutch, 0, 1);
    check.number("gear", controls.gear, -1, gears_max);
    return check.fault();
}

std::string validate(const Pilot& pilot) {
    Check check;
    check.enter("pilot");
    check.vector("center", pilot.center, 1e7);
    check.number("radius", pilot.radius, 4, 1e4);
    check.number("speed", pilot.speed, 0, 200);
    return check.fault();
}

std::string validate(const Car& car) {
    for (const std::string& fault :
         {validate(car.def), validate(car.controls), validate(car.pilot)})
        if (!fault.empty()) return fault;
    Check check;
    check.that(car.wheels.size() == car.def.wheels.size(),
               "wheels has a different number of states than the definition");
    for (const Wheel& wheel : car.def.wheels)
        check.that(is_unit(wheel.down) && is_unit(wheel.axle),
                   "wheels has axes that are not unit vectors");
    for (std::size_t k = 0; k < car.wheels.size(); k++) {
        check.enter("wheels", k);
        check_wheel_runtime(car.wheels[k], check);
    }
    check.that(car.bodies.size() == (car.def.cast == WheelCast::body ? car.wheels.size() : 0),
               "wheels has the wrong number of bodies");
    for (const WheelBody& wheel : car.bodies) {
        check.number("spin", wheel.spin, -1e6, 1e6);
        check.number("drive_impulse", wheel.drive_impulse, -1e12, 1e12);
        check.number("resistance", wheel.resistance, -1e12, 1e12);
    }
    check.leave();
    check.number("driver_steering", car.driver_steering, -1, 1);
    check.number("driver_throttle", car.driver_throttle, -1, 1);
    check.number("steering", car.steering, -1, 1);
    check.number("engine_speed", car.engine_speed, 0, 1e5);
    check.number("engine_torque", car.engine_torque, -1e12, 1e12);
    check.number("clutch_torque", car.clutch_torque, -1e12, 1e12);
    check.number("gear", car.gear, -1, static_cast<double>(car.def.gearbox.forward.size()));
    check.number("shift_left", car.shift_left, 0, 10);
    check.number("pause_left", car.pause_left, 0, 120);
    check.number("speed", car.speed, -1e6, 1e6);
    check.vector("expected_v", car.expected_v, 1e6);
    check.vector("expected_w", car.expected_w, 1e6);
    check.vector("external_acceleration", car.external_acceleration, 1e6);
    check.vector("external_angular_acceleration", car.external_angular_acceleration, 1e6);
    return check.fault();
}

}  // namespace jostle::modules::vehicle_detail
