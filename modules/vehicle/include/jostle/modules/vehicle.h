// SPDX-License-Identifier: MIT
//
// Cars: wheeled and tracked vehicles. A car is a chassis body with wheels. Wheels are not bodies,
// except with WheelCast::body: each wheel searches for the ground along its suspension once per
// step and applies the forces of suspension and tyre to the chassis in each sub-step. Springs,
// dampers, engine, clutch, gearbox, differentials and brakes are solved implicitly, so they are
// stable at any stiffness.
//
//     auto vehicles = std::make_unique<Vehicles>();
//     const CarId car = vehicles->add(world, saloon({.chassis = body})).value();
//     vehicles->set_controls(world, car, {.throttle = 1}).expect();
//     world.add_module(std::move(vehicles)).expect();
//
// The ground receives the reaction. A ground body in the sub-step group of the chassis receives it
// in the same sub-step. Any other ground body receives the sum of a step as a force during the next
// step. A chassis without contacts belongs to the group of all bodies without contacts. The
// reaction is therefore one step late if, for example, a car stands on a barge that lies on the
// ground. Cars on dynamic bodies do not sleep.
//
// Thread rule: that of the owning world.
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

/// Identifies a car. Ids start at 1 and are never reused.
using CarId = std::uint32_t;

/// Input of a car. It stays in effect until it is replaced.
struct CarControls {
    double throttle = 0;    ///< 0 to 1
    double brake = 0;       ///< 0 to 1
    double hand_brake = 0;  ///< 0 to 1; the larger of both brake torques applies at each wheel
    double steering = 0;    ///< -1 to 1, positive to the right
    double clutch = 0;      ///< 0 to 1: clutch pedal; 1 is fully disengaged
    /// -1 reverse, 0 neutral. Above 0, an automatic gearbox drives forward and a manual one selects
    /// this gear.
    std::int32_t gear = 1;

    bool operator==(const CarControls&) const = default;
};

/// Driver that follows a circle around the vertical axis through `center`, for scenes.
/// set_controls() or driver input takes over.
struct Pilot {
    Vec3 center = {};    ///< m, each component within 1e7
    double radius = 30;  ///< m, 4 to 1e4; counter-clockwise seen from above
    double speed = 10;   ///< m/s, 0 to 200
};

/// State of a wheel after the last step.
struct WheelState {
    bool touches = false;  ///< true if the wheel is in contact with the ground
    /// Body that it touches. Meaningful only if it touches.
    BodyId ground = {};
    /// Contact point (m) and ground normal (unit), world. Meaningful only if the wheel touches.
    Vec3 point = {}, normal = {0, 1, 0};
    double travel = 0;    ///< m, compression from full extension
    double load = 0;      ///< N, along the normal
    Vec3 force = {};      ///< N, tyre force on the chassis along the ground: forward, right, 0
    double spin = 0;      ///< rad/s, positive forward
    double angle = 0;     ///< rad, rotation, 0 to 2 pi
    double steering = 0;  ///< rad, positive to the right
    double stiffness = 0, damping = 0;  ///< N/m and N s/m, of its suspension
};
/// State of a car after the last step.
struct CarState {
    BodyId chassis = {};
    CarControls controls = {};
    std::int32_t gear = 0;                        ///< -1 reverse, 0 neutral
    bool shifting = false;                        ///< true while a shift keeps the clutch open
    double engine_speed = 0;                      ///< rad/s
    double engine_torque = 0, clutch_torque = 0;  ///< N m
    double speed = 0;                             ///< m/s, forward
    /// In the order of VehicleDef::wheels.
    std::vector<WheelState> wheels = {};
};

/// Module that owns the cars of a world. Tag: "vehicle".
class Vehicles final : public physics::Module {
public:
    /// The module's tag.
    static constexpr std::string_view kind = "vehicle";

    Vehicles();
    ~Vehicles() override;

    /// Adds a car. Spring stiffness is derived from the mass that rests on each wheel at this time.
    /// With WheelCast::body, the wheels are created in their positions under load.
    ///
    /// Errors: invalid_argument names the field that is out of range; failed_precondition if the
    /// chassis is not a dynamic body; already_exists if it belongs to another car. Errors of World
    /// apply too.
    physics::Result<CarId> add(physics::World& world, const VehicleDef& def);
    /// Removes a car. The chassis stays. Returns not_found for an unknown id, as all calls with a
    /// CarId do.
    physics::Status remove(physics::World& world, CarId car);
    /// All cars, in increasing order.
    std::vector<CarId> cars() const;
    /// Replaces the controls and removes a pilot. Wakes the chassis if they change.
    /// invalid_argument names the control that is out of range.
    physics::Status set_controls(physics::World& world, CarId car, const CarControls& controls);
    /// Lets a pilot drive the car. invalid_argument names the value that is out of range.
    physics::Status set_pilot(physics::World& world, CarId car, const Pilot& pilot);
    /// Returns the state after the last step.
    physics::Result<CarState> state(CarId car) const;
    /// Returns the definition, with normalized axes.
    physics::Result<VehicleDef> def(CarId car) const;

    std::string_view tag() const override { return kind; }
    void visit(physics::StateVisitor& v) override;
    /// Configures the module from a scene. Each of the bodies car, car2 ... car16 that is present
    /// becomes a car of the type `make`: 0 saloon, 1 tracked, 2 motorcycle. The other numbers apply
    /// to all cars:
    /// - track, wheel_base, height, radius, width, shortest, longest, frequency, damping, friction,
    ///   front_drive, steering_most, anti_roll and power_scale;
    /// - cast: 0 ray, 1 sphere, 2 cylinder, 3 body; motorcycles always use rays;
    /// - throttle, brake and steering;
    /// - pilot_radius and pilot_speed; pilot_radius adds a pilot.
    physics::Status configure(physics::World& world,
                              const physics::ModuleSettings& settings) override;
    /// True for the chassis of cars.
    bool is_controllable(BodyId body) const override;
    /// Applies driver input between steps. Axis 0 steers. Axis 1 is the throttle forward; backward
    /// it brakes, and drives in reverse once the car stands. Button 0 is the hand brake. Buttons 2
    /// and 3 shift a manual gearbox up and down. Driver input controls the car until set_controls()
    /// or set_pilot().
    void control(physics::World& world, BodyId body, const physics::Controls& controls) override;
    /// Returns false for cars whose wheels are bodies.
    bool visit_controlled_entity(physics::World& world, BodyId body,
                                 physics::StateVisitor& v) override;
    /// Publishes the channel "vehicle" for each chassis: gear, engine speed (8 bits, 0 to its
    /// maximum). Then for each wheel: radius (8 bits, 0 to 2 m), width (8 bits, 0 to 1 m), centre
    /// in the chassis frame (3 x 16 bits, -8 to 8 m), 1 if it touches the ground + 2 if it slides,
    /// angle (16 bits, 0 to 2 pi), spin (16 bits, -400 to 400 rad/s), steering (16 bits, -pi/2 to
    /// pi/2).
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

    std::vector<vehicle_detail::Car> cars_;  ///< sorted by id
    CarId next_ = 1;
};

}  // namespace jostle::modules
