// SPDX-License-Identifier: MIT
#include "car_step.h"

#include "drive_line.h"
#include "suspension.h"
#include "tyre.h"

namespace jostle::modules::vehicle_detail {

using namespace physics;

namespace {

// s in which what else pushes the chassis (gravity, contacts) is learned. It must not be much
// quicker than a sub-step: impacts would be taken for weight.
constexpr double learns = 0.02;
constexpr double other_most = 1e5;  // m/s^2, rad/s^2

Vec3 bounded_push(Vec3 a) {
    const Vec3 most{other_most, other_most, other_most};
    return min(max(a, -most), most);
}

// What the chassis did since the last sub-step that the car did not ask for.
void learn_other_pushes(const MovingBody& chassis, double h, Car& car) {
    if (car.follows) {
        const double share = h / (h + learns);
        car.other_a +=
            ((chassis.linear_velocity - car.expected_v) / h - car.other_a) * share;
        car.other_alpha +=
            ((chassis.angular_velocity - car.expected_w) / h - car.other_alpha) * share;
        car.other_a = bounded_push(car.other_a);
        car.other_alpha = bounded_push(car.other_alpha);
    }
    car.follows = true;
}

Frame frame_of(const SubstepContext& substep, Car& car) {
    const MovingBody chassis = substep.body(car.def.chassis);
    const double h = substep.h();
    learn_other_pushes(chassis, h, car);
    Frame frame;
    frame.pose = chassis.pose;
    frame.axes = to_matrix(chassis.pose.rotation);
    frame.center = chassis.center;
    frame.v = chassis.linear_velocity;
    frame.w = chassis.angular_velocity;
    frame.next_v = frame.v + car.other_a * h;
    frame.next_w = frame.w + car.other_alpha * h;
    frame.h = h;
    frame.time = (substep.index() + 0.5) * h;
    return frame;
}

// ---- where wheels touch ----

// Of what tyres push, sideways or ahead, if all of them push alike.
double inverse_mass_at(const Car& car, const Contact& contact) {
    const auto along = [&](Vec3 direction) {
        const Vec3 turn = cross(contact.arm, direction);
        return 1 / car.mass + dot(turn, car.inverse_inertia * turn);
    };
    return maximum(along(contact.ahead), along(contact.aside)) *
           static_cast<double>(car.wheels.size());
}

bool touch(const SubstepContext& substep, const Frame& frame, std::uint32_t index, Car& car,
           Contact& contact) {
    Ground& ground = car.grounds[index];
    if (!ground.found) return false;
    const Wheel& wheel = car.def.wheels[index];
    const Rig& rig = car.rigs[index];
    const Vec3 down = frame.axes * rig.down, normal = ground.normal;
    const double facing = -dot(down, normal);
    if (facing < 0.1) return false;
    const Vec3 hub = frame.pose.position + frame.axes * wheel.attachment;
    const Vec3 plane = ground.point + ground.velocity * frame.time;
    // The suspension's length at which the wheel touches the plane.
    const double length = (dot(hub - plane, normal) - ground.reach) / facing;
    contact.pressed = wheel.suspension.longest - length;
    if (contact.pressed <= 0) return false;

    contact.wheel = index;
    contact.normal = normal;
    contact.lever = 1 / facing;
    const Vec3 axle = frame.axes * rig.axle;
    contact.ahead = normalized(cross(normal, axle), frame.axes * rig.ahead);
    contact.aside = cross(contact.ahead, normal);
    contact.arm = hub + down * length - normal * ground.reach - frame.center;
    Vec3 below = ground.velocity;
    const BodyId body = car.wheels[index].ground;
    if (ground.dynamic && substep.contains(body))
        below = substep.velocity_at(body, frame.center + contact.arm);
    contact.velocity = frame.v + cross(frame.w, contact.arm) - below;
    if (ground.inverse_mass == 0) ground.inverse_mass = inverse_mass_at(car, contact);
    contact.inverse_mass = ground.inverse_mass;
    return true;
}

void find_contacts(const SubstepContext& substep, const Frame& frame, Car& car,
                   Contacts& contacts) {
    for (std::uint32_t k = 0; k < car.wheels.size(); k++) {
        WheelRun& run = car.wheels[k];
        Contact& contact = contacts.all[contacts.count];
        run.touches = touch(substep, frame, k, car, contact);
        if (run.touches) {
            contacts.count++;
            run.travel = contact.pressed;
            run.point = frame.center + contact.arm;
            run.normal = contact.normal;
            continue;
        }
        run.travel = run.load = run.ahead = run.aside = 0;
        run.bend_ahead = run.bend_aside = 0;
    }
}

// ---- how they turn and hold ----

void prepare_spin(const Car& car, SpunWheels& wheels) {
    const CarControls& controls = car.controls;
    for (std::size_t k = 0; k < car.wheels.size(); k++) {
        const Wheel& made = car.def.wheels[k];
        const double brake = maximum(controls.brake * made.brake_torque,
                                     controls.hand_brake * made.hand_brake_torque);
        wheels[k] = {.radius = made.radius,
                     .inertia = made.inertia,
                     .share = made.drive_share,
                     .brake = brake,
                     .spin = car.wheels[k].spin};
    }
}

// How the tyre answers if the wheel spins on, and how that changes with its spin.
Tread bend_tread(const Frame& frame, const Contact& contact, Car& car, SpunWheel& spun) {
    WheelRun& run = car.wheels[contact.wheel];
    const Tyre& tyre = car.def.wheels[contact.wheel].tyre;
    const double ahead = dot(contact.velocity, contact.ahead),
                 aside = dot(contact.velocity, contact.aside);
    Tread tread = tread_of(tyre, contact, run.friction, absolute(ahead), frame.h,
                           contact.inverse_mass, run);
    const double slip = ahead - spun.radius * run.spin;
    run.bend_ahead = (run.bend_ahead - frame.h * slip) * tread.roll;
    run.bend_aside = (run.bend_aside - frame.h * aside) * tread.roll;
    hold(tread, run.bend_ahead, run.bend_aside);
    spun.force = tread.secant_ahead * run.bend_ahead - tread.damping_ahead * slip;
    spun.slope =
        spun.radius * (tread.secant_ahead * frame.h * tread.roll + tread.damping_ahead);
    spun.brake += tyre.rolling_resistance * contact.load * spun.radius;
    return tread;
}

// Once the wheel's new spin is known: bends the tread by it, and pushes at most as friction holds.
// The spin then takes what the drive line counted on and the tyre did not give.
void grip(const Frame& frame, Tread& tread, Car& car, SpunWheel& spun, Contact& contact) {
    WheelRun& run = car.wheels[contact.wheel];
    const double counted = spun.force + spun.slope * (spun.spin - run.spin);
    const double slip = dot(contact.velocity, contact.ahead) - spun.radius * spun.spin;
    run.bend_ahead += frame.h * spun.radius * (spun.spin - run.spin) * tread.roll;
    hold(tread, run.bend_ahead, run.bend_aside);
    double ahead = tread.secant_ahead * run.bend_ahead - tread.damping_ahead * slip;
    double aside = tread.secant_aside * run.bend_aside -
                   tread.damping_aside * dot(contact.velocity, contact.aside);
    const double force2 = ahead * ahead + aside * aside;
    if (force2 > tread.limit * tread.limit) {
        const double less = tread.limit / square_root(force2);
        ahead *= less;
        aside *= less;
    }
    if (spun.spin != 0)
        spun.spin += frame.h * spun.radius * (counted - ahead) / spun.answers;
    contact.force_ahead = run.ahead = ahead;
    contact.force_aside = run.aside = aside;
    run.load = contact.load;
}

void drive(const Frame& frame, Car& car, SpunWheels& wheels, Contacts& contacts) {
    prepare_spin(car, wheels);
    std::array<Tread, wheels_max> treads;
    for (std::size_t k = 0; k < contacts.count; k++)
        treads[k] =
            bend_tread(frame, contacts.all[k], car, wheels[contacts.all[k].wheel]);
    solve_drive_line(car, frame.h, wheels);
    for (std::size_t k = 0; k < contacts.count; k++)
        grip(frame, treads[k], car, wheels[contacts.all[k].wheel], contacts.all[k]);
}

// ---- what comes of it ----

struct Push {
    Vec3 impulse = {}, turn = {};  // N s, N m s about the centre of mass
};

void push_ground(SubstepContext& substep, const Frame& frame, const Contact& contact,
                 Vec3 impulse, Car& car) {
    Ground& ground = car.grounds[contact.wheel];
    if (!ground.dynamic) return;
    const BodyId body = car.wheels[contact.wheel].ground;
    if (!substep.add_impulse(body, -impulse, frame.center + contact.arm)) ground.pushed += -impulse;
}

void push_by_wheels(SubstepContext& substep, const Frame& frame, Contacts& contacts, Car& car,
                    Push& push) {
    for (const Contact& contact : contacts) {
        const Vec3 impulse = (contact.normal * contact.load + contact.ahead * contact.force_ahead +
                              contact.aside * contact.force_aside) *
                             frame.h;
        push.impulse += impulse;
        push.turn += cross(contact.arm, impulse);
        push_ground(substep, frame, contact, impulse, car);
    }
}

// Wheels take their spin from the chassis and leave it there.
void turn_wheels(const Frame& frame, const SpunWheels& wheels, Car& car, Push& push) {
    constexpr double turn = 2 * pi;
    Vec3 left{};
    for (std::size_t k = 0; k < car.wheels.size(); k++) {
        WheelRun& run = car.wheels[k];
        left += car.rigs[k].axle * (wheels[k].inertia * (wheels[k].spin - run.spin));
        run.spin = wheels[k].spin;
        run.angle += run.spin * frame.h;
        run.angle -= turn * std::floor(run.angle / turn);
    }
    push.turn += frame.axes * left;
}

void push_by_air(const Frame& frame, const Car& car, Push& push) {
    const Aerodynamics& air = car.def.aerodynamics;
    const double speed = length(frame.v), flow = 0.5 * air.density * speed * frame.h;
    const double drag = flow * air.drag_area;
    push.impulse += frame.v * (-drag / (1 + drag / car.mass));
    const double press = flow * speed * air.downforce_area;
    push.impulse += frame.axes.y * -minimum(press, 100 * car.mass * frame.h);
}

}  // namespace

void step_car(SubstepContext& substep, Car& car) {
    const Frame frame = frame_of(substep, car);
    Contacts contacts;
    find_contacts(substep, frame, car, contacts);
    solve_loads(car, frame, contacts);
    SpunWheels wheels;
    drive(frame, car, wheels, contacts);

    Push push;
    push_by_wheels(substep, frame, contacts, car, push);
    turn_wheels(frame, wheels, car, push);
    push_by_air(frame, car, push);
    substep.add_impulse(car.def.chassis, push.impulse, frame.center);
    substep.add_angular_impulse(car.def.chassis, push.turn);
    car.expected_v = frame.v + push.impulse * (1 / car.mass);
    car.expected_w = frame.w + car.inverse_inertia * push.turn;
    car.speed = -dot(frame.v, frame.axes.z);
}

}  // namespace jostle::modules::vehicle_detail
