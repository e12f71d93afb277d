// SPDX-License-Identifier: MIT
//
// Characters: upright capsules that walk, climb, crouch and jump as somebody steers them.
//
// A *sweeping* character is moved by questions to the world: it sweeps its capsule ahead, slides
// along what it meets, climbs steps and keeps to the floor. The world sees it as a kinematic body.
// What it meets it pushes by impulses that it feels itself. A *rigid* one is a dynamic capsule with
// locked turns, which the solver moves: others can push it.
//
//     auto characters = std::make_unique<Characters>();
//     Characters& crowd = *characters;
//     world.add_module(std::move(characters)).expect();
//     const CharacterId hero = crowd.add(world, {.feet = {0, 0, 0}}).value();
//     crowd.set_controls(hero, {.walk = {0, 0, -3}});
//
// All happens before the step: what a platform is about to do a character does with it, so what
// sets the velocities of platforms is to be done, or added to the world as a module, before. Up is
// +y. Calls are made between steps, by whoever may change the world.
#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <vector>

#include "jostle/physics/module.h"
#include "jostle/physics/world.h"

namespace jostle::modules {

// As a body's: good until the character is removed. A default id is null.
struct CharacterId {
    std::uint32_t index = 0xffffffff;
    std::uint32_t generation = 0;

    auto operator<=>(const CharacterId&) const = default;
};

enum class CharacterKind : std::uint8_t { sweeping, rigid };

enum class GroundKind : std::uint8_t {
    on_ground,        // stands and can walk
    on_steep_ground,  // touches only what is steeper than its slope limit, and slides
    in_air,
};

// What a character is able to do.
struct CharacterAbilities {
    double mass = 80;            // kg, 1 to 1e4; later changes do not reach a rigid one's body
    double slope_limit = 0.873;  // rad, 0 to 1.5: walks up what is no steeper (0.873: 50 degrees)
    // m, 0 to 2. The round foot of a capsule rolls over what is lower than
    // radius * (1 - cos(slope_limit)) even with less.
    double step_height = 0.4;
    double floor_snap = 0.4;  // m, 0 to 2: keeps to a floor that falls away by no more at a time
    double jump_speed = 5;    // m/s, 0 to 100: rises by jump_speed^2 / 2g
    double ground_acceleration = 40;  // m/s^2, 0 to 1e5
    double air_acceleration = 4;      // m/s^2, 0 to 1e5
    // N, 0 to 1e6: how hard it pushes what is in its way. What an impact takes is not bounded.
    double strength = 600;
};

struct CharacterDef {
    CharacterKind kind = CharacterKind::sweeping;
    physics::Vec3 feet = {};       // m: the lowest point
    double heading = 0;            // rad about +y, from -z
    physics::Vec3 velocity = {};   // m/s
    double radius = 0.3;           // m, 0.05 to 5
    double height = 1.8;           // m, more than 2 radius, to 20
    double crouched_height = 1.1;  // m, more than 2 radius, to height
    // m, 0.002 to half the radius: how far a sweeping one stays from what it meets. Its body is
    // smaller by that on all sides, so the solver never presses it against anything.
    double skin = 0.02;
    CharacterAbilities abilities = {};
    // Of its shape. A sweeping one meets what has a category of its mask.
    physics::Filter filter = {};
    std::uint64_t user_data = 0;  // of its body
};

// What it is asked to do, until it is asked otherwise.
struct CharacterControls {
    physics::Vec3 walk = {};  // m/s over the ground it stands on; y is not read
    bool jump = false;        // once for each time that it becomes true
    bool crouch = false;

    bool operator==(const CharacterControls&) const = default;
};

struct CharacterState {
    CharacterId id;
    CharacterKind kind = CharacterKind::sweeping;
    physics::BodyId body;    // what others see
    physics::Vec3 feet;      // m
    double heading = 0;      // rad about +y, from -z
    physics::Vec3 velocity;  // m/s
    bool crouched = false;
    GroundKind ground = GroundKind::in_air;
    // On the ground, steep or not:
    physics::BodyId ground_body;
    physics::Vec3 ground_normal;    // unit
    physics::Vec3 ground_velocity;  // m/s, of the ground under the feet
    physics::Vec3 applied_impulse;  // N s that it gave to others in the last step
};

namespace character_detail {
struct CharacterStore;
}

class Characters : public physics::Module {
public:
    static constexpr std::size_t most = 4096;  // characters of a world

    Characters();
    ~Characters() override;

    // Makes its body. Errors name the argument; resource_exhausted: there are `most`.
    physics::Result<CharacterId> add(physics::World& world, const CharacterDef& def);
    // With its body.
    physics::Status remove(physics::World& world, CharacterId id);
    bool contains(CharacterId id) const;
    std::vector<CharacterId> ids() const;  // by index

    physics::Status set_controls(CharacterId id, const CharacterControls& controls);
    physics::Result<CharacterControls> controls(CharacterId id) const;
    physics::Status set_abilities(CharacterId id, const CharacterAbilities& abilities);
    physics::Result<CharacterAbilities> abilities(CharacterId id) const;
    // A leap: nothing on the way is met.
    physics::Status set_feet(physics::World& world, CharacterId id, physics::Vec3 feet);
    physics::Status set_velocity(physics::World& world, CharacterId id, physics::Vec3 velocity);
    physics::Result<CharacterState> state(const physics::World& world, CharacterId id) const;
    // Whose body it is; null: nobody's.
    CharacterId character_of(physics::BodyId body) const;

    std::string_view tag() const override { return "character"; }
    void visit(physics::StateVisitor& v) override;
    // Each body that is named, by any name, becomes a character: a kinematic one sweeps, a dynamic
    // one is rigid. Its first shape is an upright capsule; of one that sweeps, smaller by the skin
    // than the character. The numbers are for all: those of CharacterAbilities by their names,
    // skin, crouched_height (m; default: 0.6 of the height), and stroll (m/s) and stroll_turn
    // (rad/s): how it walks about while nobody steers it.
    physics::Status configure(physics::World& world,
                              const physics::ModuleSettings& settings) override;
    bool is_controllable(physics::BodyId body) const override;
    // Sticks to the right and ahead, as seen by where the driver looks, walk at most at 5 m/s; with
    // both buttons' meanings as Controls has them.
    void control(physics::World& world, physics::BodyId body,
                 const physics::Controls& controls) override;
    bool visit_controlled_entity(physics::World& world, physics::BodyId body,
                                 physics::StateVisitor& v) override;
    // "character", of each body: kind (bit 0), crouched (bit 1) and ground (bits 2, 3); in 8 bits
    // each heading from -pi to pi, speed over the ground from 0 to 20 m/s, velocity upwards from
    // -20 to 20 m/s.
    std::vector<physics::ChannelKind> channels() const override { return {{}}; }
    void publish(const physics::World& world, physics::ChannelWriter& channels) const override;

    void before_step(physics::World& world, double dt) override;

private:
    std::unique_ptr<character_detail::CharacterStore> store_;
};

}  // namespace jostle::modules
