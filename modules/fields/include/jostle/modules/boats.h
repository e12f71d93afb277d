// SPDX-License-Identifier: MIT
//
// Boats: bodies with a propeller and a rudder at the stern, controlled by a driver or by
// steer(). The water comes from the world's "fields" module (Waves), which also provides buoyancy.
// A propeller outside the water produces no thrust. The keel resists sideways motion.
//
//     auto boats = std::make_unique<Boats>();
//     boats->add(world, {.hull = body}).expect();
//     world.add_module(std::move(boats)).expect();
//
// In the frame of the hull, y points up and -z forward. Thread rule: that of the owning world.
#pragma once

#include <vector>

#include "jostle/modules/volume_field.h"
#include "jostle/physics/module.h"
#include "jostle/physics/world.h"

namespace jostle::modules {

/// Description of a boat.
struct BoatDef {
    physics::BodyId hull = {};  ///< a dynamic body that is not already a boat
    /// m, propeller position in the hull frame, at most 8 m from its origin
    physics::Vec3 propeller = {0, -0.4, 2.4};
    double thrust = 7000;  ///< N at standstill, 0 to 1e7; half of it astern
    /// m/s through still water at which the thrust reaches zero, 0.1 to 100
    double top_speed = 12;
    double max_rudder_angle = 0.4;  ///< rad, largest deflection of the thrust, 0 to 1.2
    /// Lateral keel force coefficient, N per (m/s)^2, 0 to 1e6: the force is keel * speed *
    /// sideways speed.
    double keel = 1500;
};

/// Module that owns the boats of a world. Tag: "boat".
class Boats final : public physics::Module {
public:
    /// Maximum number of boats in a world.
    static constexpr std::size_t boats_max = 256;

    /// State of one boat.
    struct State {
        /// The body.
        physics::BodyId hull = {};
        double throttle = 0;  ///< -1 to 1, requested thrust
        /// -1 to 1, positive to the right: current deflection, which approaches the requested one
        double rudder = 0;
        bool in_water = false;  ///< true if the propeller was in water in the last step
    };

    /// Adds a boat. Returns invalid_argument, naming the field, if the definition is invalid, and
    /// resource_exhausted if there are boats_max boats already.
    physics::Status add(const physics::World& world, const BoatDef& def);
    /// Sets throttle and rudder, each -1 to 1, until the next call. Wakes the hull. Returns
    /// not_found if the body is not a boat.
    physics::Status steer(physics::World& world, physics::BodyId hull, double throttle,
                          double rudder);
    /// All boats, in the order of add().
    std::vector<State> states() const;

    std::string_view tag() const override { return "boat"; }
    void visit(physics::StateVisitor& v) override;
    /// Configures the module from a scene: each named body, under any name, becomes a boat. Numbers
    /// apply to all boats: screw_y and screw_z (m, -5 to 5), thrust, top_speed, rudder_most and
    /// keel.
    physics::Status configure(physics::World& world,
                              const physics::ModuleSettings& settings) override;
    /// True for the hulls of boats.
    bool is_controllable(physics::BodyId body) const override { return find(body) != nullptr; }
    /// Applies driver input between steps: axis 0 is the rudder, axis 1 the throttle.
    void control(physics::World& world, physics::BodyId body,
                 const physics::Controls& controls) override;
    /// Publishes the channel "boat" for each hull: propeller position in the hull frame (3 x 16
    /// bits, -8 to 8 m), throttle and rudder (8 bits each, -1 to 1, positive to the right), and 1
    /// if the propeller is in water, otherwise 0.
    std::vector<physics::ChannelKind> channels() const override { return {{}}; }
    void publish(const physics::World& world, physics::ChannelWriter& channels) const override;

    physics::StepHooks hooks() const override { return {.substeps = !boats_.empty()}; }
    void before_step(physics::World& world, double dt) override;
    void before_substep(physics::SubstepContext& substep) override;

private:
    struct Boat {
        BoatDef def;
        double throttle = 0, rudder_target = 0, rudder = 0;
        bool in_water = false;
    };
    const Boat* find(physics::BodyId hull) const;
    Boat* find(physics::BodyId hull);
    bool in_water(const physics::SubstepContext& substep, physics::Vec3 point) const;

    std::vector<Boat> boats_;
    std::vector<VolumeField> waters_;  ///< of the current step
};

}  // namespace jostle::modules
