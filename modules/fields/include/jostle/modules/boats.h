// SPDX-License-Identifier: MIT
//
// Boats: bodies with a screw and a rudder at the stern, for somebody to drive, or as told. The
// water is that of the world's module "fields" (Waves); what floats, floats by that. A screw in the
// air pushes nothing, and a keel keeps a boat from sliding aside.
//
//     auto boats = std::make_unique<Boats>();
//     boats->add(world, {.hull = body}).expect();
//     world.add_module(std::move(boats)).expect();
//
// In the frame of the hull y is up and -z ahead. Thread rule: as of the world that owns it.
#pragma once

#include <vector>

#include "jostle/modules/volume_field.h"
#include "jostle/physics/module.h"
#include "jostle/physics/world.h"

namespace jostle::modules {

struct BoatDef {
    physics::BodyId hull = {};             // a dynamic body of no other boat
    physics::Vec3 screw = {0, -0.4, 2.4};  // m, in the hull; within 8
    double thrust = 7000;                  // N at standstill, 0 to 1e7; astern half of it
    double top_speed = 12;     // m/s through still water that the screw gives up at, 0.1 to 100
    double rudder_most = 0.4;  // rad that the thrust turns by, 0 to 1.2
    // N per (m/s)^2: of the speed times that aside, 0 to 1e6.
    double keel = 1500;
};

class Boats final : public physics::Module {
public:
    static constexpr std::size_t most = 256;

    struct State {
        physics::BodyId hull = {};
        double throttle = 0;  // -1 to 1
        double rudder = 0;    // -1 to 1, to the right: as it is, on its way to what is held
        bool wet = false;     // the screw, in the last step
    };

    // Errors name the field.
    physics::Status add(const physics::World& world, const BoatDef& def);
    // -1 to 1 each, held from now on.
    physics::Status steer(physics::World& world, physics::BodyId hull, double throttle,
                          double rudder);
    std::vector<State> states() const;  // in the order of add()

    std::string_view tag() const override { return "boat"; }
    void visit(physics::StateVisitor& v) override;
    // Makes a boat of each body that is given, by any name; all share screw_y, screw_z, thrust,
    // top_speed, rudder_most and keel.
    physics::Status configure(physics::World& world,
                              const physics::ModuleSettings& settings) override;
    // Axis 0 is the rudder, axis 1 the throttle.
    bool is_controllable(physics::BodyId body) const override { return find(body) != nullptr; }
    void control(physics::World& world, physics::BodyId body,
                 const physics::Controls& controls) override;
    // "boat", of each hull: where the screw is in it (3 x 16 bits of -8 to 8 m), throttle and
    // rudder (8 bits each of -1 to 1, to the right), 1 if the screw is in the water.
    std::vector<physics::ChannelKind> channels() const override { return {{}}; }
    void publish(const physics::World& world, physics::ChannelWriter& channels) const override;

    physics::StepHooks hooks() const override { return {.substeps = !boats_.empty()}; }
    void before_step(physics::World& world, double dt) override;
    void before_substep(physics::SubstepContext& substep) override;

private:
    struct Boat {
        BoatDef def;
        double throttle = 0, rudder_target = 0, rudder = 0;
        bool wet = false;
    };
    const Boat* find(physics::BodyId hull) const;
    Boat* find(physics::BodyId hull);
    bool in_water(const physics::SubstepContext& substep, physics::Vec3 point) const;

    std::vector<Boat> boats_;
    std::vector<VolumeField> waters_;  // of one step
};

}  // namespace jostle::modules
