// SPDX-License-Identifier: MIT
//
// The motion rules of the scene "asteroids": each dynamic body keeps the speed with which it
// started, and a body outside a sphere about the origin is accelerated back towards its centre.
// The rules and figures are those of KinematicSoup's UnityNetworkTransformBenchmark.
#pragma once

#include <vector>

#include "jostle/physics/module.h"
#include "jostle/physics/world.h"

namespace jostle::scenes {

class Asteroids : public physics::Module {
public:
    std::string_view tag() const override { return "asteroids"; }
    void visit(physics::StateVisitor& v) override;
    // Numbers: radius, acceleration and return_acceleration. The target speed of each dynamic body
    // is its speed at this time.
    physics::Status configure(physics::World& world,
                              const physics::ModuleSettings& settings) override;
    void before_step(physics::World& world, double dt) override;

private:
    struct Target {
        physics::BodyId body;
        double speed = 0;  // m/s
    };
    void steer(physics::World& world, const physics::BodyState& body, double speed, double dt);

    double radius_ = 50;               // m, of the sphere about the origin, 1 to 1e5
    double acceleration_ = 5;          // m/s^2, towards the target speed, 0 to 1000
    double return_acceleration_ = 10;  // m/s^2, towards the origin outside the sphere, 0 to 1000
    std::vector<Target> targets_;      // in ascending order of body
};

}  // namespace jostle::scenes
