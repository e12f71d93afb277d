// SPDX-License-Identifier: MIT
#include "modules/vehicle/src/car_parts.h"

#include "modules/vehicle/src/drive_line.h"
#include "modules/vehicle/src/tyre.h"

namespace jostle::modules::vehicle_detail {

using namespace physics;

namespace {

// Time constant, s, of the estimate of other accelerations of the chassis (gravity, contacts). It
// must not be much shorter than a sub-step, otherwise impacts are mistaken for weight.
constexpr double external_time_constant = 0.02;

Vec3 clamp_components(Vec3 a, double most) {
    return min(max(a, Vec3{-most, -most, -most}), Vec3{most, most, most});
}

// Estimates the acceleration of the chassis since the last solve that the car did not cause.
void estimate_external_acceleration(const MovingBody& chassis, double h, Car& car) {
    if (car.has_expected_motion) {
        const double share = h / (h + external_time_constant);
        // The limit prevents a crash from being treated as a lasting acceleration.
        const Vec3 a = (chassis.linear_velocity - car.expected_v) / h,
                   alpha = (chassis.angular_velocity - car.expected_w) / h;
        car.external_acceleration +=
            (clamp_components(a, car.external_acceleration_max) - car.external_acceleration) *
            share;
        car.external_angular_acceleration +=
            (clamp_components(alpha, car.external_acceleration_max) -
             car.external_angular_acceleration) *
            share;
    }
    car.has_expected_motion = true;
    car.expected_v = chassis.linear_velocity;
    car.expected_w = chassis.angular_velocity;
}

// Number of sub-steps covered by one solve.
int substeps_per_solve(const SubstepContext& substep, const Car& car) {
    const double most = 1 / car.def.rate + 1e-9;
    return most < 2 * substep.h() ? 1 : static_cast<int>(most / substep.h());
}

ChassisFrame frame_of(const SubstepContext& substep, double h, Car& car) {
    const MovingBody chassis = substep.body(car.def.chassis);
    estimate_external_acceleration(chassis, h, car);
    ChassisFrame frame;
    frame.pose = chassis.pose;
    frame.axes = to_matrix(chassis.pose.rotation);
    frame.center = chassis.center;
    // The mean velocity since the last solve. Between solves, other accelerations cause a ripple
    // that tyres and dampers would mistake for drift.
    const double ripple = 0.5 * (h - substep.h());
    frame.v = chassis.linear_velocity;
    if (!car.supported) frame.v += car.external_acceleration * -ripple;
    frame.w = chassis.angular_velocity - car.external_angular_acceleration * ripple;
    frame.next_v = frame.v + car.external_acceleration * h;
    frame.next_w = frame.w + car.external_angular_acceleration * h;
    frame.h = h;
    frame.time = (substep.index() + 0.5) * substep.h();
    return frame;
}

// ---- contacts ----

// Inverse effective mass of a tyre force, lateral or longitudinal, if all tyres apply the same
// force.
double inverse_mass_at(const Car& car, const Contact& contact) {
    const auto along = [&](Vec3 direction) {
        const Vec3 turn = cross(contact.arm, direction);
        return 1 / car.mass + dot(turn, car.inverse_inertia * turn);
    };
    return maximum(along(contact.forward), along(contact.lateral)) *
           static_cast<double>(car.wheels.size());
}

bool touch(const SubstepContext& substep, const ChassisFrame& frame, std::uint32_t index, Car& car,
           Contact& contact) {
    Ground& ground = car.grounds[index];
    if (!ground.found) return false;
    const Wheel& wheel = car.def.wheels[index];
    const WheelAxes& rig = car.wheel_axes[index];
    const Vec3 down = frame.axes * rig.down, normal = ground.normal;
    const double facing = -dot(down, normal);
    if (facing < 0.1) return false;
    const Vec3 hub = frame.pose.position + frame.axes * wheel.attachment;
    const Vec3 plane = ground.point + ground.velocity * frame.time;
    // Length of the suspension at which the wheel touches the plane.
    const double length = (dot(hub - plane, normal) - ground.reach) / facing;
    contact.pressed = wheel.suspension.max_length - length;
    if (contact.pressed <= 0) return false;

    contact.wheel = index;
    contact.normal = normal;
    contact.lever = 1 / facing;
    const Vec3 axle = frame.axes * rig.axle;
    contact.forward = normalized(cross(normal, axle), frame.axes * rig.forward);
    contact.lateral = cross(contact.forward, normal);
    contact.arm = hub + down * length - frame.center;
    if (wheel.crown > 0) {
        // Round cross-section: the contact point moves to the side to which the wheel leans.
        const Vec3 rim = normalized(normal - axle * dot(axle, normal), -down);
        contact.arm += rim * (wheel.crown - wheel.radius) - normal * wheel.crown;
    } else {
        contact.arm += normal * -ground.reach;
    }
    Vec3 below = ground.velocity;
    const BodyId body = car.wheels[index].ground;
    if (ground.dynamic && substep.contains(body))
        below = substep.velocity_at(body, frame.center + contact.arm);
    contact.velocity = frame.v + cross(frame.w, contact.arm) - below;
    if (ground.inverse_mass == 0) ground.inverse_mass = inverse_mass_at(car, contact);
    contact.inverse_mass = ground.inverse_mass;
    return true;
}

void find_contacts(const SubstepContext& substep, const ChassisFrame& frame, Car& car,
                   Contacts& contacts) {
    for (std::uint32_t k = 0; k < car.wheels.size(); k++) {
        WheelRuntime& run = car.wheels[k];
        Contact& contact = contacts.all[contacts.count];
        run.touches = touch(substep, frame, k, car, contact);
        if (run.touches) {
            contacts.count++;
            run.travel = contact.pressed;
            run.point = frame.center + contact.arm;
            run.normal = contact.normal;
            continue;
        }
        run.travel = run.load = run.forward = run.lateral = 0;
        run.longitudinal_deflection = run.lateral_deflection = 0;
    }
}

// ---- spin and grip ----

void prepare_spin(const Car& car, DriveLineWheels& wheels) {
    for (std::size_t k = 0; k < car.wheels.size(); k++) {
        const Wheel& made = car.def.wheels[k];
        DriveLineWheel& wheel = wheels[k];
        wheel.radius = made.radius;
        wheel.inertia = made.inertia;
        wheel.share = made.drive_share;
        wheel.brake = brake_torque(car, k);
        wheel.force = wheel.slope = 0;
        wheel.spin = car.wheels[k].spin;
    }
}

// Computes the tyre force at the current spin and its derivative with respect to the spin.
void deflect_tread(const ChassisFrame& frame, Car& car, DriveLineWheel& spun, Contact& contact) {
    WheelRuntime& run = car.wheels[contact.wheel];
    const Tyre& tyre = car.def.wheels[contact.wheel].tyre;
    contact.longitudinal_velocity = dot(contact.velocity, contact.forward);
    contact.lateral_velocity = dot(contact.velocity, contact.lateral);
    TreadState& tread = contact.tread =
        tread_of(tyre, contact, run.friction, absolute(contact.longitudinal_velocity), frame.h);
    const double slip = contact.longitudinal_velocity - spun.radius * run.spin;
    run.longitudinal_deflection = (run.longitudinal_deflection - frame.h * slip) * tread.roll;
    run.lateral_deflection =
        (run.lateral_deflection - frame.h * contact.lateral_velocity) * tread.roll;
    const double s2 = clamp_to_friction(tread, run.longitudinal_deflection, run.lateral_deflection);
    compute_secant_stiffness(tread, run.longitudinal_deflection, run.lateral_deflection, s2);
    spun.force =
        tread.longitudinal_secant * run.longitudinal_deflection - tread.longitudinal_damping * slip;
    spun.slope = spun.radius *
                 (tread.longitudinal_secant * frame.h * tread.roll + tread.longitudinal_damping);
    spun.brake += tyre.rolling_resistance * contact.load * spun.radius;
}

// Applies the new spin of the wheel: deflects the tread and limits the force to friction. Then
// corrects the spin by the difference between the force assumed by the drive line and the actual
// force.
void grip(const ChassisFrame& frame, Car& car, DriveLineWheel& spun, Contact& contact) {
    WheelRuntime& run = car.wheels[contact.wheel];
    const TreadState& tread = contact.tread;
    const double gained = spun.spin - run.spin;
    const double assumed = spun.force + spun.slope * gained;
    const double slip = contact.longitudinal_velocity - spun.radius * spun.spin;
    run.longitudinal_deflection += frame.h * spun.radius * gained * tread.roll;
    clamp_to_friction(tread, run.longitudinal_deflection, run.lateral_deflection);
    double forward =
        tread.longitudinal_secant * run.longitudinal_deflection - tread.longitudinal_damping * slip;
    double lateral = tread.lateral_secant * run.lateral_deflection -
                     tread.lateral_damping * contact.lateral_velocity;
    const double force2 = forward * forward + lateral * lateral;
    if (force2 > tread.limit * tread.limit) {
        const double less = tread.limit / square_root(force2);
        forward *= less;
        lateral *= less;
    }
    if (spun.spin != 0)
        spun.spin += frame.h * spun.radius * (assumed - forward) / spun.effective_inertia;
    contact.longitudinal_force = run.forward = forward;
    contact.lateral_force = run.lateral = lateral;
    run.load = contact.load;
}

void drive(const ChassisFrame& frame, Car& car, DriveLineWheels& wheels, Contacts& contacts) {
    prepare_spin(car, wheels);
    for (Contact& contact : contacts) deflect_tread(frame, car, wheels[contact.wheel], contact);
    solve_drive_line(car, frame.h, wheels);
    for (Contact& contact : contacts) grip(frame, car, wheels[contact.wheel], contact);
}

// ---- resulting impulses ----

struct Push {
    Vec3 impulse = {}, angular_impulse = {};  // N s, N m s about the centre of mass
};

void apply_ground_reaction(SubstepContext& substep, const ChassisFrame& frame,
                           const Contact& contact, Vec3 impulse, Car& car) {
    Ground& ground = car.grounds[contact.wheel];
    if (!ground.dynamic) return;
    const BodyId body = car.wheels[contact.wheel].ground;
    if (!substep.add_impulse(body, -impulse, frame.center + contact.arm))
        ground.reaction_impulse += -impulse;
}

void apply_wheel_forces(SubstepContext& substep, const ChassisFrame& frame, Contacts& contacts,
                        Car& car, Push& push) {
    for (const Contact& contact : contacts) {
        const Vec3 impulse =
            (contact.normal * contact.load + contact.forward * contact.longitudinal_force +
             contact.lateral * contact.lateral_force) *
            frame.h;
        push.impulse += impulse;
        push.angular_impulse += cross(contact.arm, impulse);
        apply_ground_reaction(substep, frame, contact, impulse, car);
    }
}

// Changes of wheel spin conserve the angular momentum of the car.
void update_wheel_spin(const ChassisFrame& frame, const DriveLineWheels& wheels, Car& car,
                       Push& push) {
    constexpr double turn = 2 * pi;
    Vec3 left{};
    for (std::size_t k = 0; k < car.wheels.size(); k++) {
        WheelRuntime& run = car.wheels[k];
        left += car.wheel_axes[k].axle * (wheels[k].inertia * (wheels[k].spin - run.spin));
        run.spin = wheels[k].spin;
        run.angle += run.spin * frame.h;
        if (run.angle < 0 || run.angle > turn) run.angle -= turn * std::floor(run.angle / turn);
    }
    push.angular_impulse += frame.axes * left;
}

void apply_aerodynamics(const ChassisFrame& frame, const Car& car, Push& push) {
    push.impulse +=
        aerodynamic_impulse(car.def.aerodynamics, frame.v, frame.axes.y, car.mass, frame.h);
}

}  // namespace

// A solve that covers several sub-steps applies its whole impulse in the first one: symplectic
// Euler with the longer step. Only the support against other accelerations, which is constant, is
// applied in each sub-step, so that a standing car has no velocity.
void step_car(SubstepContext& substep, Car& car) {
    const int solve_interval = substeps_per_solve(substep, car);
    const BodyId chassis = car.def.chassis;
    if (substep.index() % solve_interval != 0) {
        if (car.supported)
            substep.add_impulse(chassis, car.support_impulse, substep.body(chassis).center);
        return;
    }
    const int left = substep.count() - substep.index(),
              steps = left < solve_interval ? left : solve_interval;
    const ChassisFrame frame = frame_of(substep, steps * substep.h(), car);
    Contacts contacts;
    find_contacts(substep, frame, car, contacts);
    solve_loads(car, frame, contacts);
    DriveLineWheels wheels;
    drive(frame, car, wheels, contacts);

    Push push;
    apply_wheel_forces(substep, frame, contacts, car, push);
    update_wheel_spin(frame, wheels, car, push);
    apply_aerodynamics(frame, car, push);
    push.angular_impulse += feet_angular_impulse(frame, car);
    car.supported = contacts.count > 0;
    car.support_impulse =
        car.supported ? car.external_acceleration * (-car.mass * substep.h()) : Vec3{};
    substep.add_impulse(chassis, push.impulse - car.support_impulse * (steps - 1), frame.center);
    substep.add_angular_impulse(chassis, push.angular_impulse);
    car.expected_v += push.impulse * (1 / car.mass);
    car.expected_w += car.inverse_inertia * push.angular_impulse;
    car.speed = -dot(frame.v, frame.axes.z);
}

}  // namespace jostle::modules::vehicle_detail
