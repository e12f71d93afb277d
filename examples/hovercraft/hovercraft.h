// SPDX-License-Identifier: MIT
//
// Hovercraft: a module that uses only public headers of the solver. Four thrusters at the corners
// of a body cast a ray down and push the body up, so that it hovers at a constant height over any
// ground. A drive moves the craft along a circle, or as a client steers it.
#pragma once

#include <array>

#include "jostle/physics/module.h"
#include "jostle/physics/world.h"

namespace jostle::examples {

class Hovercraft : public physics::Module {
public:
    struct Settings {
        double height = 1.2;  // m above the ground, 0.3 to 3
        double speed = 8;     // m/s of the drive, 0 to 20
        double radius = 16;   // m, of the circle about the world's y axis, 4 to 1000
    };

    Hovercraft() = default;
    explicit Hovercraft(physics::BodyId craft) : craft_(craft) {}
    Hovercraft(physics::BodyId craft, const Settings& settings)
        : craft_(craft), settings_(settings) {}

    std::string_view tag() const override { return "hovercraft"; }
    void visit(physics::StateVisitor& v) override;
    // Settings of a scene: the numbers height, speed and radius, and the body craft (required).
    physics::Status configure(physics::World& world,
                              const physics::ModuleSettings& settings) override;
    // Channel "hovercraft" of the craft's body. For each thruster: position in the body (3 x 16
    // bits, -2 to 2 m), length of its ray (16 bits, 0 to 4 m), force (8 bits, 0 to its maximum).
    std::vector<physics::ChannelKind> channels() const override { return {{}}; }
    void publish(const physics::World& world, physics::ChannelWriter& channels) const override;
    // Without control inputs the craft follows its circle.
    bool is_controllable(physics::BodyId body) const override { return body == craft_; }
    void control(physics::World& world, physics::BodyId body,
                 const physics::Controls& controls) override;

    physics::StepHooks hooks() const override { return {.substeps = true}; }
    void before_substep(physics::SubstepContext& substep) override;

private:
    struct Thruster {
        double force = 0;  // N; follows its target with a lag
        double ray = 0;    // m to the ground, or the maximum length of the ray
    };

    void lift(physics::SubstepContext& substep, const physics::MovingBody& craft);
    void drive(physics::SubstepContext& substep, const physics::MovingBody& craft);
    // Turn rate towards the circle about the craft's up axis, 1/s.
    double turn_to_circle(const physics::MovingBody& craft) const;

    physics::BodyId craft_;
    Settings settings_;
    std::array<Thruster, 4> thrusters_;
    double steering_ = 0, throttle_ = 0;  // control inputs, -1 to 1
};

}  // namespace jostle::examples
