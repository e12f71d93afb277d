// SPDX-License-Identifier: MIT
//
// The player of the scene "katamari": a module that drives one body about as somebody would who
// plays, from a seed, and draws what is near to it. The step decides nothing else, so the same seed
// gives the same motion, which is what codecs of snapshots are compared by.
#pragma once

#include <vector>

#include "jostle/physics/module.h"
#include "jostle/physics/world.h"

namespace jostle::scenes {

class Katamari : public physics::Module {
public:
    std::string_view tag() const override { return "katamari"; }
    void visit(physics::StateVisitor& v) override;
    // The numbers seed, speed, reach and pull; the body player, which must be given.
    physics::Status configure(physics::World& world,
                              const physics::ModuleSettings& settings) override;
    void before_step(physics::World& world, double dt) override;

private:
    double random_in(double low, double high);
    // Where the player wants to go, until when, and whether it jumps on the way.
    void decide(physics::Vec3 position, double now);

    physics::BodyId player_;
    double speed_ = 6;    // m/s that it keeps, 0 to 20
    double reach_ = 2.4;  // m from its middle, 0.1 to 20
    double pull_ = 16;    // m/s^2 towards its middle, 0 to 100
    std::uint32_t random_ = 1;
    double decision_end_ = 0;  // s of the world's time
    double heading_ = 0;       // rad about y, from +x
    bool jumps_ = false;
    std::vector<physics::BodyState> bodies_;  // of this step; no part of the state
};

}  // namespace jostle::scenes
