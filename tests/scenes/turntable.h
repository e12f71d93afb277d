// SPDX-License-Identifier: MIT
//
// A test module: rotates a kinematic disc about y with an angular acceleration.
// docs/reference/scene_format.md uses it in an example.
#pragma once

#include <memory>

#include "jostle/physics/module.h"
#include "jostle/physics/world.h"

namespace jostle::test {

class Turntable final : public physics::Module {
public:
    std::string_view tag() const override { return "turntable"; }
    void visit(physics::StateVisitor& v) override {
        v.field("disc", disc_);
        v.field("speed", speed_);
        v.field("gain", gain_);
        if (v.loading() && speed_ < 0) v.fail("speed", "is negative");
    }
    void restored(const physics::World& world) override {
        restored_in_world = world.module("turntable") == this;
    }
    Status configure(physics::World&, const physics::ModuleSettings& settings) override {
        for (const auto& [name, number] : settings.numbers) {
            order += name + " ";
            if (name != "speed" && name != "gain")
                return Error{ErrorCode::invalid_argument,
                             "has no setting \"" + name + "\"; it has gain and speed"};
            (name == "speed" ? speed_ : gain_) = number;
        }
        for (const auto& [name, body] : settings.bodies)
            if (name == "disc") disc_ = body;
        return {};
    }
    void before_step(physics::World& world, double dt) override {
        speed_ += gain_ * dt;
        world.set_velocity(disc_, {}, {0, speed_, 0}).expect();
    }

    physics::BodyId disc() const { return disc_; }
    double speed() const { return speed_; }

    std::string order;  // of the settings received, each followed by a space
    bool restored_in_world = false;

private:
    physics::BodyId disc_;
    double speed_ = 0, gain_ = 0;  // rad/s, rad/s^2
};

// May be called by several tests of a program.
inline void register_turntable() {
    static const Status known =
        physics::register_module("turntable", [] { return std::make_unique<Turntable>(); });
    known.expect();
}

}  // namespace jostle::test
