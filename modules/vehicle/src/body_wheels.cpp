// SPDX-License-Identifier: MIT
//
// The drive line has no information about the ground. It drives wheels with their own inertia
// against a resisting torque. This torque is estimated from the rotation in the last sub-steps that
// the drive line did not cause. The clutch therefore responds to the inertia of the whole car after
// about 60 ms of contact, and only to that of the wheel in the air or on ice. Its effect in a
// sub-step never exceeds what the wheel can take.
#include "modules/vehicle/src/car_parts.h"

#include "modules/vehicle/src/drive_line.h"

namespace jostle::modules::vehicle_detail {

using namespace physics;

namespace {

constexpr double resistance_time_constant = 0.02;  // s

// x forward, y up along the suspension, z along the axle to the right.
Quat frame_of(const Wheel& wheel) {
    const Quat level = rotation_between({0, 0, 1}, wheel.axle, {0, 1, 0});
    return rotation_between(rotate(level, {0, 1, 0}), -wheel.down, wheel.axle) * level;
}

double inertia_of(const Wheel& wheel) {
    return 0.5 * wheel.mass * wheel.radius * wheel.radius;
}

// Inverse effective mass at the spring of a wheel, 1/kg: its own mass, and the chassis along the
// suspension.
double inverse_mass_of(const Wheel& wheel, const BodyState& chassis) {
    const Vec3 arm = apply(chassis.pose, wheel.attachment) - chassis.center;
    const Vec3 turn = cross(arm, rotate(chassis.pose.rotation, wheel.down));
    return 1 / wheel.mass + 1 / chassis.mass + dot(turn, inverse(chassis.inertia) * turn);
}

WheelJoint joint_of(const Wheel& wheel, const WheelRuntime& run, const BodyState& chassis) {
    const Suspension& suspension = wheel.suspension;
    const double inverse_mass = inverse_mass_of(wheel, chassis);
    const double rate = square_root(run.stiffness * inverse_mass);
    WheelJoint joint;
    joint.suspension = {.hertz = rate / (2 * pi),
                        .damping_ratio = 0.5 * run.damping * inverse_mass / rate};
    joint.suspension_target = -suspension.max_length - suspension.preload / run.stiffness;
    joint.travel = {true, -suspension.max_length, -suspension.min_length};
    return joint;
}

// Compression of the spring under its design load.
double sag_of(const Wheel& wheel, double gravity) {
    const double w = 2 * pi * wheel.suspension.frequency;
    return clamp(gravity / (w * w), 0, wheel.suspension.max_length - wheel.suspension.min_length);
}

Status make_wheel_body(World& world, const BodyState& chassis, const Filter& filter,
                       std::size_t index, Car& car) {
    const Wheel& wheel = car.def.wheels[index];
    const double pressed = sag_of(wheel, length(world.gravity()));
    const Vec3 hub = wheel.attachment + wheel.down * (wheel.suspension.max_length - pressed);
    BodyDef body{.pose = {apply(chassis.pose, hub), chassis.pose.rotation}};
    body.linear_velocity = chassis.linear_velocity +
                           cross(chassis.angular_velocity, body.pose.position - chassis.center);
    // Starts rolling: wheels that must first spin up would slide in arbitrary directions.
    const Vec3 axle = rotate(chassis.pose.rotation, wheel.axle);
    const Vec3 forward = rotate(chassis.pose.rotation, cross(wheel.axle, wheel.down));
    WheelBody& run = car.bodies[index];
    run.spin = clamp(dot(body.linear_velocity, forward) / wheel.radius, -1e5, 1e5);
    body.angular_velocity = chassis.angular_velocity - axle * run.spin;
    ShapeDef shape{.geometry = Cylinder{wheel.radius, 0.5 * wheel.width},
                   .pose = {{}, rotation_between({0, 1, 0}, wheel.axle, {1, 0, 0})},
                   .mass = wheel.mass,
                   .filter = filter};
    shape.material.friction = wheel.tyre.friction;
    shape.material.friction_rule = wheel.tyre.friction_rule;
    const Result<BodyId> made = world.create_body(body, shape);
    if (!made.ok()) return made.error();
    run.body = *made;
    const Quat frame = frame_of(wheel);
    JointDef joint{.body_a = car.def.chassis,
                   .body_b = *made,
                   .frame_a = {wheel.attachment, frame},
                   .frame_b = {{}, frame},
                   .kind = joint_of(wheel, car.wheels[index], chassis)};
    const Result<JointId> held = world.create_joint(joint);
    if (!held.ok()) return held.error();
    run.joint = *held;
    return {};
}

// Wheels collide with the ground categories of the car, and have the categories of the first shape
// of the chassis.
Filter filter_of(const World& world, const Car& car) {
    Filter filter;
    const std::vector<ShapeId> shapes = world.shapes_of(car.def.chassis);
    if (!shapes.empty())
        if (const Result<ShapeState> shape = world.shape(shapes.front()); shape.ok())
            filter = shape->filter;
    filter.mask = car.def.ground;
    return filter;
}

double spin_of(const MovingBody& wheel, const MovingBody& chassis, Vec3 axle) {
    return -dot(wheel.angular_velocity - chassis.angular_velocity, axle);
}

// Updates the estimate of the torque that acted since the last sub-step in addition to the drive
// line.
void estimate_resistance(double spin, double inertia, double h, WheelBody& wheel) {
    const double resistance = (inertia * (spin - wheel.spin) - wheel.drive_impulse) / h;
    wheel.resistance += (resistance - wheel.resistance) * (h / (h + resistance_time_constant));
    wheel.spin = spin;
    wheel.drive_impulse = 0;
}

// The wheel as the drive line models it.
DriveLineWheel drive_line_wheel_of(const Wheel& def, const WheelBody& wheel) {
    return {.radius = def.radius,
            .inertia = inertia_of(def),
            .share = def.drive_share,
            .brake = 0,
            .force = -wheel.resistance / def.radius,
            .slope = 0,
            .spin = wheel.spin,
            .effective_inertia = 0};
}

// Force by which a bar pushes a wheel down, N; reduced if the bar is too stiff for the sub-step.
double anti_roll_force(const Car& car, std::uint32_t wheel,
                       const std::array<double, wheels_max>& pressed, double h) {
    double push = 0;
    for (const AntiRollBar& bar : car.def.anti_roll_bars) {
        if (bar.left != wheel && bar.right != wheel) continue;
        const std::uint32_t other = bar.left == wheel ? bar.right : bar.left;
        const double inverse_mass = 1 / car.def.wheels[wheel].mass + 1 / car.def.wheels[other].mass;
        const double compliance = 1 / (1 + h * h * bar.stiffness * inverse_mass);
        push += bar.stiffness * compliance * (pressed[wheel] - pressed[other]);
    }
    return push;
}

void apply_anti_roll_bars(SubstepContext& substep, const MovingBody& chassis, const Car& car) {
    if (car.def.anti_roll_bars.empty()) return;
    std::array<double, wheels_max> pressed{};
    for (std::size_t k = 0; k < car.bodies.size(); k++) {
        if (!substep.contains(car.bodies[k].body)) continue;
        const Wheel& wheel = car.def.wheels[k];
        const Vec3 hub = apply(chassis.pose, wheel.attachment),
                   down = rotate(chassis.pose.rotation, wheel.down);
        pressed[k] =
            wheel.suspension.max_length - dot(substep.body(car.bodies[k].body).center - hub, down);
    }
    for (std::uint32_t k = 0; k < car.bodies.size(); k++) {
        const BodyId body = car.bodies[k].body;
        if (!substep.contains(body)) continue;
        const Vec3 down = rotate(chassis.pose.rotation, car.def.wheels[k].down);
        const Vec3 push = down * (anti_roll_force(car, k, pressed, substep.h()) * substep.h());
        const Vec3 at = substep.body(body).center;
        substep.add_impulse(body, push, at);
        substep.add_impulse(car.def.chassis, -push, at);
    }
}

}  // namespace

Status make_body_wheels(World& world, Car& car) {
    const Result<BodyState> chassis = world.body(car.def.chassis);
    if (!chassis.ok()) return chassis.error();
    const Filter filter = filter_of(world, car);
    car.bodies.resize(car.wheels.size());
    for (std::size_t k = 0; k < car.bodies.size(); k++) {
        Status made = make_wheel_body(world, *chassis, filter, k, car);
        if (made.ok()) continue;
        destroy_body_wheels(world, car);
        return made;
    }
    return {};
}

void destroy_body_wheels(World& world, Car& car) {
    // Bodies that were destroyed already are skipped.
    for (const WheelBody& wheel : car.bodies)
        if (world.contains(wheel.body)) static_cast<void>(world.destroy_body(wheel.body));
    car.bodies.clear();
}

void steer_and_brake(World& world, Car& car) {
    for (std::size_t k = 0; k < car.bodies.size(); k++) {
        const Result<JointState> joint = world.joint(car.bodies[k].joint);
        if (!joint.ok()) continue;
        const auto* now = std::get_if<WheelJoint>(&joint->def.kind);
        if (now == nullptr) continue;
        const Wheel& wheel = car.def.wheels[k];
        WheelJoint next = *now;
        next.steering = -car.steering * wheel.max_steering_angle;
        next.friction_torque = brake_torque(car, k) +
                               wheel.tyre.rolling_resistance * car.wheels[k].load * wheel.radius;
        static_cast<void>(world.set_joint(car.bodies[k].joint, next));
    }
}

void drive_body_wheels(SubstepContext& substep, Car& car) {
    const MovingBody chassis = substep.body(car.def.chassis);
    const double h = substep.h();
    DriveLineWheels wheels;
    std::array<Vec3, wheels_max> axles;
    for (std::size_t k = 0; k < car.bodies.size(); k++) {
        WheelBody& wheel = car.bodies[k];
        if (substep.contains(wheel.body)) {
            const MovingBody body = substep.body(wheel.body);
            axles[k] = rotate(body.pose.rotation, car.def.wheels[k].axle);
            estimate_resistance(spin_of(body, chassis, axles[k]), inertia_of(car.def.wheels[k]), h,
                                wheel);
        }
        wheels[k] = drive_line_wheel_of(car.def.wheels[k], wheel);
    }
    solve_drive_line(car, h, wheels);
    for (std::size_t k = 0; k < car.bodies.size(); k++) {
        WheelBody& wheel = car.bodies[k];
        if (!substep.contains(wheel.body)) continue;
        wheel.drive_impulse =
            wheels[k].inertia * (wheels[k].spin - wheel.spin) - h * wheel.resistance;
        substep.add_angular_impulse(wheel.body, axles[k] * -wheel.drive_impulse);
        substep.add_angular_impulse(car.def.chassis, axles[k] * wheel.drive_impulse);
    }
    apply_anti_roll_bars(substep, chassis, car);
    const Vec3 up = rotate(chassis.pose.rotation, {0, 1, 0});
    substep.add_impulse(
        car.def.chassis,
        aerodynamic_impulse(car.def.aerodynamics, chassis.linear_velocity, up, car.mass, h),
        chassis.center);
}

void update_wheel_state(const World& world, double dt, Car& car) {
    const Result<BodyState> chassis = world.body(car.def.chassis);
    if (!chassis.ok()) return;
    const Quat turn = chassis->pose.rotation;
    car.speed = -dot(chassis->linear_velocity, rotate(turn, {0, 0, 1}));
    const Vec3 weight = world.gravity();
    for (std::size_t k = 0; k < car.bodies.size(); k++) {
        WheelRuntime& run = car.wheels[k];
        const Wheel& wheel = car.def.wheels[k];
        const Result<JointState> joint = world.joint(car.bodies[k].joint);
        const Result<BodyState> body = world.body(car.bodies[k].body);
        if (!joint.ok() || !body.ok()) {
            run.touches = false;
            run.load = run.forward = run.lateral = 0;
            continue;
        }
        run.travel = maximum(joint->travel + wheel.suspension.max_length, 0);
        const Vec3 axle = rotate(body->pose.rotation, wheel.axle);
        run.spin = clamp(-dot(body->angular_velocity - chassis->angular_velocity, axle), -1e5, 1e5);
        run.angle += run.spin * dt;
        run.angle -= 2 * pi * std::floor(run.angle / (2 * pi));
        const Vec3 down = rotate(turn, wheel.down);
        // Force of the ground on the wheel, assuming that the wheel does not accelerate.
        const Vec3 ground = -joint->force - weight * wheel.mass;
        run.load = maximum(-dot(ground, down), 0);
        run.forward = dot(ground, rotate(turn, car.wheel_axes[k].forward));
        run.lateral = dot(ground, axle);
        run.friction = wheel.tyre.friction;
        run.normal = -down;
        run.point = body->center + down * wheel.radius;
        const Result<std::vector<BodyId>> touched = world.touching_bodies(car.bodies[k].body);
        run.touches = touched.ok() && !touched->empty();
        run.ground = run.touches ? touched->front() : BodyId{};
    }
}

}  // namespace jostle::modules::vehicle_detail
