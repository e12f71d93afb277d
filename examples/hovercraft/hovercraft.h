// SPDX-License-Identifier: MIT
//
// A hovercraft: a module written on the library's public headers alone. Four thrusters at the
// corners of a body each cast a ray down and push by what they find; a drive carries the craft
// round a circle, or where somebody steers it. Works over any ground.
#pragma once

#include <array>

#include "jostle/physics/module.h"
#include "jostle/physics/world.h"

namespace jostle::examples {

class Hovercraft : public physics::Module {
public:
    struct Settings {
        double height = 1.2;  // m that thrusters keep above the ground, 0.3 to 3
        double speed = 8;     // m/s that the drive keeps, 0 to 20
        double radius = 16;   // m of the circle about the world's y axis, 4 to 1000
    };

    Hovercraft() = default;
    explicit Hovercraft(physics::BodyId craft) : craft_(craft) {}
    Hovercraft(physics::BodyId craft, const Settings& settings)
        : craft_(craft), settings_(settings) {}

    std::string_view tag() const override { return "hovercraft"; }
    void visit(physics::StateVisitor& v) override;
    // The numbers height, speed and radius; the body craft, which must be given.
    physics::Status configure(physics::World& world,
                              const physics::ModuleSettings& settings) override;
    // "hovercraft", of its body: for each thruster where it is in the body (3 x 16 bits of -2 to 2
    // m), how long its ray is (16 bits of 0 to 4 m), how hard it pushes (8 bits of 0 to its most).
    std::vector<physics::ChannelKind> channels() const override { return {{}}; }
    void publish(const physics::World& world, physics::ChannelWriter& channels) const override;
    // Goes round its circle while nobody holds anything.
    bool is_controllable(physics::BodyId body) const override { return body == craft_; }
    void control(physics::World& world, physics::BodyId body,
                 const physics::Controls& controls) override;

    physics::StepHooks hooks() const override { return {.substeps = true}; }
    void before_substep(physics::SubstepContext& substep) override;

private:
    struct Thruster {
        double force = 0;  // N; follows what is wanted with a lag
        double ray = 0;    // m to the ground, or as far as it looks
    };

    void lift(physics::SubstepContext& substep, const physics::MovingBody& craft);
    void drive(physics::SubstepContext& substep, const physics::MovingBody& craft);
    // 1/s, about its own upward axis: towards its circle.
    double turn_to_circle(const physics::MovingBody& craft) const;

    physics::BodyId craft_;
    Settings settings_;
    std::array<Thruster, 4> thrusters_;
    double aside_ = 0, ahead_ = 0;  // what the driver holds, -1 to 1
};

}  // namespace jostle::examples
