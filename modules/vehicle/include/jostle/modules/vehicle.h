// SPDX-License-Identifier: MIT
//
// Cars: any number of them. A car is a chassis body and wheels. These are not bodies, unless asked
// for (WheelCast::body): each looks for the ground along its suspension once a step, and pushes the
// chassis in each sub-step by its suspension and its tyre. Springs and dampers, and engine, clutch,
// gearbox, differentials and brakes are solved implicitly: no stiffness is too stiff.
//
//     auto vehicles = std::make_unique<Vehicles>();
//     const CarId car = vehicles->add(world, saloon({.chassis = body})).value();
//     vehicles->set_controls(world, car, {.throttle = 1}).expect();
//     world.add_module(std::move(vehicles)).expect();
//
// What wheels stand on is pushed back: in the same sub-step where it is in the group of the
// chassis, else by the sum of the step, as a force during the next one. A chassis that touches
// nothing is in the group of all that touches nothing; so it is a car on a barge that lies on the
// ground that pushes a step late. Cars on dynamic bodies do not sleep.
//
// Thread rule: as of the world that owns it.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "jostle/modules/vehicle_def.h"
#include "jostle/physics/module.h"

namespace jostle::modules {

namespace vehicle_detail {
struct Car;
}

using CarId = std::uint32_t;  // from 1; never used again

struct CarControls {
    double throttle = 0;    // 0 to 1
    double brake = 0;       // 0 to 1
    double hand_brake = 0;  // 0 to 1
    double steering = 0;    // -1 to 1, right
    double clutch = 0;      // 0 to 1: the pedal, 1 is open
    // -1 reverse, 0 neutral, above: an automatic drives ahead, a manual gearbox takes that gear.
    std::int32_t gear = 1;

    bool operator==(const CarControls&) const = default;
};

// Drives a car round a circle about the y axis through `center`; for scenes. Whoever sets controls
// takes over.
struct Pilot {
    Vec3 center = {};
    double radius = 30;  // m, 4 to 1e4; driven to the left, seen from above
    double speed = 10;   // m/s, 0 to 200
};

struct WheelState {
    bool touches = false;
    BodyId ground = {};
    Vec3 point = {}, normal = {0, 1, 0};  // of the ground in the last step, world
    double travel = 0;                    // m pressed in from hanging
    double load = 0;                      // N along the normal
    Vec3 force = {};      // N of the tyre on the chassis, along the ground: ahead, right, 0
    double spin = 0;      // rad/s, ahead
    double angle = 0;     // rad that it has turned, 0 to 2 pi
    double steering = 0;  // rad, right
    double stiffness = 0, damping = 0;  // N/m, N s/m of its suspension
};
struct CarState {
    BodyId chassis = {};
    CarControls controls = {};
    std::int32_t gear = 0;
    bool shifting = false;
    double engine_speed = 0;                      // rad/s
    double engine_torque = 0, clutch_torque = 0;  // N m
    double speed = 0;                             // m/s ahead
    std::vector<WheelState> wheels = {};
};

class Vehicles final : public physics::Module {
public:
    static constexpr std::string_view kind = "vehicle";

    Vehicles();
    ~Vehicles() override;

    // The chassis is dynamic and belongs to no other car. Springs get their stiffness from the mass
    // that rests on each wheel now. Wheels that are bodies are made where they bear it.
    physics::Result<CarId> add(physics::World& world, const VehicleDef& def);
    physics::Status remove(physics::World& world, CarId car);
    std::vector<CarId> cars() const;  // rising
    // Wakes the chassis when they change.
    physics::Status set_controls(physics::World& world, CarId car, const CarControls& controls);
    physics::Status set_pilot(physics::World& world, CarId car, const Pilot& pilot);
    physics::Result<CarState> state(CarId car) const;
    physics::Result<VehicleDef> def(CarId car) const;

    std::string_view tag() const override { return kind; }
    void visit(physics::StateVisitor& v) override;
    // Makes a saloon of each body car, car2 ... car16 that is given, or what `make` says (0 saloon,
    // 1 tracked, 2 motorcycle, which is always cast by rays); all share the numbers: track,
    // wheel_base, height, radius, width, shortest, longest, frequency, damping, friction,
    // front_drive, steering_most, anti_roll, power_scale, cast (0 ray, 1 sphere, 2 cylinder, 3
    // body); throttle, brake, steering; pilot_radius and pilot_speed (with pilot_radius a pilot
    // drives).
    physics::Status configure(physics::World& world,
                              const physics::ModuleSettings& settings) override;
    // Whoever drives a chassis: axis 0 steers, axis 1 is throttle ahead, and back the brake, and
    // reverse once the car stands; button 0 the hand brake, buttons 2 and 3 shift a manual gearbox
    // up and down. He keeps the car until set_controls() or set_pilot().
    bool is_controllable(BodyId body) const override;
    void control(physics::World& world, BodyId body, const physics::Controls& controls) override;
    // Not of a car with wheels that are bodies.
    bool visit_controlled_entity(physics::World& world, BodyId body,
                                 physics::StateVisitor& v) override;
    // "vehicle", of each chassis: gear, engine (8 bits of 0 to its most); then for each wheel its
    // radius (8 bits of 0 to 2 m) and width (8 bits of 0 to 1 m), where its centre is in the
    // chassis (3 x 16 bits of -8 to 8 m), 1 if it touches + 2 if it slides, angle (16 bits of 0 to
    // 2 pi), spin (16 bits of -400 to 400 rad/s), steering (16 bits of -pi/2 to pi/2).
    std::vector<physics::ChannelKind> channels() const override { return {{}}; }
    void publish(const physics::World& world, physics::ChannelWriter& channels) const override;

    physics::StepHooks hooks() const override {
        return {.substeps = !cars_.empty(), .concurrent = true};
    }
    void before_step(physics::World& world, double dt) override;
    void before_substep(physics::SubstepContext& substep) override;
    void after_step(physics::World& world, double dt) override;

private:
    vehicle_detail::Car* find(CarId car);
    const vehicle_detail::Car* find(CarId car) const;

    std::vector<vehicle_detail::Car> cars_;  // by id
    CarId next_ = 1;
};

}  // namespace jostle::modules
