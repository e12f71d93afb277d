// SPDX-License-Identifier: MIT
#include "modules/vehicle/src/car_parts.h"

namespace jostle::modules::vehicle_detail {

using namespace physics;

namespace {

void visit_tyre(StateVisitor& v, Tyre& tyre) {
    v.field("friction", tyre.friction);
    v.field("friction_rule", tyre.friction_rule, Combine::maximum);
    v.field("longitudinal_stiffness", tyre.longitudinal_stiffness);
    v.field("cornering_stiffness", tyre.cornering_stiffness);
    v.field("relaxation_length", tyre.relaxation_length);
    v.field("tyre_damping", tyre.damping);
    v.field("rolling_resistance", tyre.rolling_resistance);
}

void visit_suspension(StateVisitor& v, Suspension& suspension) {
    v.field("shortest", suspension.min_length);
    v.field("longest", suspension.max_length);
    v.field("frequency", suspension.frequency);
    v.field("damping", suspension.damping);
    v.field("preload", suspension.preload);
}

void visit_wheel(StateVisitor& v, Wheel& wheel) {
    v.field("attachment", wheel.attachment);
    v.field("down", wheel.down);
    v.field("axle", wheel.axle);
    v.field("radius", wheel.radius);
    v.field("width", wheel.width);
    v.field("inertia", wheel.inertia);
    v.field("mass", wheel.mass);
    visit_suspension(v, wheel.suspension);
    visit_tyre(v, wheel.tyre);
    v.field("steering_most", wheel.max_steering_angle);
    v.field("drive_share", wheel.drive_share);
    v.field("brake_torque", wheel.brake_torque);
    v.field("hand_brake_torque", wheel.hand_brake_torque);
    v.field("steering_brake", wheel.steering_brake);
    v.field("crown", wheel.crown);
}

void visit_group(StateVisitor& v, std::string_view name, std::vector<std::uint32_t>& group) {
    v.all(name, group, [&](std::uint32_t& wheel) { v.field("wheel", wheel); });
}

void visit_def(StateVisitor& v, VehicleDef& def) {
    v.field("chassis", def.chassis);
    v.all("wheels", def.wheels, [&](Wheel& wheel) { visit_wheel(v, wheel); });
    v.all("anti_roll_bars", def.anti_roll_bars, [&](AntiRollBar& bar) {
        v.field("left", bar.left);
        v.field("right", bar.right);
        v.field("stiffness", bar.stiffness);
    });
    v.all("couplings", def.differential_locks, [&](DifferentialLock& coupling) {
        visit_group(v, "first", coupling.first);
        visit_group(v, "second", coupling.second);
        v.field("kind", coupling.kind, DifferentialLockKind::locked);
        v.field("preload", coupling.preload);
        v.field("ratio", coupling.ratio);
    });
    visit_group(v, "steering_left", def.steering_drive.left);
    visit_group(v, "steering_right", def.steering_drive.right);
    v.field("steering_ratio", def.steering_drive.ratio);
    v.field("steering_torque", def.steering_drive.torque);
    v.field("balanced", def.balance.enabled);
    v.field("max_lean_angle", def.balance.max_lean_angle);
    v.field("lean_frequency", def.balance.frequency);
    v.field("feet_speed_max", def.balance.feet_speed_max);
    v.field("cast", def.cast, WheelCast::body);
    v.field("ground", def.ground);
    v.field("steering_rate", def.steering_rate);
    v.field("rate", def.rate);
}

void visit_drive(StateVisitor& v, VehicleDef& def) {
    v.all("curve", def.engine.curve, [&](TorquePoint& point) {
        v.field("speed", point.speed);
        v.field("torque", point.torque);
    });
    v.field("inertia", def.engine.inertia);
    v.field("idle", def.engine.idle_speed);
    v.field("most", def.engine.max_speed);
    v.field("friction", def.engine.friction);
    Gearbox& gearbox = def.gearbox;
    v.field("automatic", gearbox.automatic);
    v.all("ahead", gearbox.forward, [&](double& ratio) { v.field("ratio", ratio); });
    v.field("reverse", gearbox.reverse);
    v.field("final_ratio", gearbox.final_ratio);
    v.field("efficiency", gearbox.efficiency);
    v.field("shift_time", gearbox.shift_time);
    v.field("shift_pause", gearbox.shift_pause);
    v.field("shift_up_speed", gearbox.shift_up_speed);
    v.field("shift_down_speed", gearbox.shift_down_speed);
    v.field("clutch_torque", gearbox.clutch_torque);
    v.field("drag_area", def.aerodynamics.drag_area);
    v.field("downforce_area", def.aerodynamics.downforce_area);
    v.field("density", def.aerodynamics.density);
}

void visit_controls(StateVisitor& v, Car& car) {
    v.field("throttle", car.controls.throttle);
    v.field("brake", car.controls.brake);
    v.field("hand_brake", car.controls.hand_brake);
    v.field("steering", car.controls.steering);
    v.field("clutch", car.controls.clutch);
    v.field("gear", car.controls.gear);
    v.field("driver", car.driver, Driver::player);
    v.field("driver_steering", car.driver_steering);
    v.field("driver_throttle", car.driver_throttle);
    v.field("driver_buttons", car.driver_buttons);
    v.field("pilot_center", car.pilot.center);
    v.field("pilot_radius", car.pilot.radius);
    v.field("pilot_speed", car.pilot.speed);
}

void visit_wheel_runtime(StateVisitor& v, WheelRuntime& run) {
    v.field("stiffness", run.stiffness);
    v.field("damping", run.damping);
    v.field("spin", run.spin);
    v.field("angle", run.angle);
    v.field("longitudinal_deflection", run.longitudinal_deflection);
    v.field("lateral_deflection", run.lateral_deflection);
    v.field("travel", run.travel);
    v.field("load", run.load);
    v.field("ahead", run.forward);
    v.field("aside", run.lateral);
    v.field("friction", run.friction);
    v.field("touches", run.touches);
    v.field("ground", run.ground);
    v.field("shape", run.shape);
    v.field("point", run.point);
    v.field("normal", run.normal);
}

}  // namespace

void visit_car(StateVisitor& v, Car& car) {
    v.field("id", car.id);
    visit_def(v, car.def);
    visit_drive(v, car.def);
    visit_controls(v, car);
    v.all("runs", car.wheels, [&](WheelRuntime& run) { visit_wheel_runtime(v, run); });
    v.all("bodies", car.bodies, [&](WheelBody& wheel) {
        v.field("body", wheel.body);
        v.field("joint", wheel.joint);
        v.field("last_spin", wheel.spin);
        v.field("pushed", wheel.drive_impulse);
        v.field("resists", wheel.resistance);
    });
    v.field("turned", car.steering);
    v.field("engine_speed", car.engine_speed);
    v.field("engine_torque", car.engine_torque);
    v.field("clutch_torque", car.clutch_torque);
    v.field("engaged", car.gear);
    v.field("shift_left", car.shift_left);
    v.field("pause_left", car.pause_left);
    v.field("speed", car.speed);
    v.field("follows", car.has_expected_motion);
    v.field("carried", car.supported);
    v.field("expected_v", car.expected_v);
    v.field("expected_w", car.expected_w);
    v.field("external_acceleration", car.external_acceleration);
    v.field("external_angular_acceleration", car.external_angular_acceleration);
    if (!v.loading()) return;
    car.active = false;
    const std::string fault = validate(car);
    if (!fault.empty()) v.fail("car", fault);
}

}  // namespace jostle::modules::vehicle_detail
