// SPDX-License-Identifier: MIT
//
// The player of the scene "katamari": a module that moves one body like a player, controlled by a
// random generator, and attracts nearby bodies. Its decisions depend only on the seed, so equal
// seeds produce equal motion, on which snapshot codecs are compared.
#pragma once

#include <vector>

#include "jostle/physics/module.h"
#include "jostle/physics/world.h"

namespace jostle::scenes {

class Katamari : public physics::Module {
public:
    std::string_view tag() const override { return "katamari"; }
    void visit(physics::StateVisitor& v) override;
    // Numbers: seed, speed, reach and pull. Body: player (required).
    physics::Status configure(physics::World& world,
                              const physics::ModuleSettings& settings) override;
    void before_step(physics::World& world, double dt) override;

private:
    double random_in(double low, double high);
    // Chooses the direction of motion, its duration, and whether the player jumps.
    void decide(physics::Vec3 position, double now);

    physics::BodyId player_;
    double speed_ = 6;    // m/s, target speed, 0 to 20
    double reach_ = 2.4;  // m from its centre, 0.1 to 20
    double pull_ = 16;    // m/s^2 towards its centre, 0 to 100
    std::uint32_t random_ = 1;
    double decision_end_ = 0;  // s, world time
    double heading_ = 0;       // rad about y, from +x
    bool jumps_ = false;
    std::vector<physics::BodyState> bodies_;  // of this step; not part of the state
};

}  // namespace jostle::scenes
