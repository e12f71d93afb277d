// SPDX-License-Identifier: MIT
//
// Characters: upright capsules that walk, climb, crouch and jump according to their controls.
//
// A *sweeping* character moves by queries: it sweeps its capsule, slides along obstacles, climbs
// steps and follows the floor. The world contains it as a kinematic body. It pushes dynamic bodies
// with impulses and receives the reaction itself. A *rigid* character is a dynamic capsule with
// locked rotation that the solver moves, so other bodies can push it.
//
//     auto owned = std::make_unique<Characters>();
//     Characters& characters = *owned;
//     world.add_module(std::move(owned)).expect();
//     const CharacterId hero = characters.add(world, {.feet = {0, 0, 0}}).value();
//     characters.set_controls(hero, {.walk = {0, 0, -3}});
//
// Characters move in before_step(), and a character follows the velocity that its platform has
// then. Set platform velocities before World::step(), or in a module that was added to the world
// earlier. Up is +y.
//
// Thread rule: that of World. Non-const calls are made between steps by the thread that owns the
// world.
#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <vector>

#include "jostle/physics/module.h"
#include "jostle/physics/world.h"

namespace jostle::modules {

/// Identifies a character. Valid until the character is removed. A default id is null.
struct CharacterId {
    std::uint32_t index = 0xffffffff;
    std::uint32_t generation = 0;

    auto operator<=>(const CharacterId&) const = default;
};

/// Movement model of a character; see the top of this file.
enum class CharacterKind : std::uint8_t { sweeping, rigid };

/// Contact of a character with the ground.
enum class GroundKind : std::uint8_t {
    on_ground,        ///< stands and can walk
    on_steep_ground,  ///< touches only surfaces steeper than slope_limit, and slides
    in_air,           ///< touches no ground
};

/// Physical abilities of a character.
struct CharacterAbilities {
    double mass = 80;  ///< kg, 1 to 1e4; later changes do not affect the body of a rigid character
    /// rad, 0 to 1.5: steepest slope it can walk up (0.873 rad = 50 degrees)
    double slope_limit = 0.873;
    /// Maximum height of a step that it climbs, m, 0 to 2. The round end of the capsule rolls over
    /// obstacles lower than radius * (1 - cos(slope_limit)) regardless of this value.
    double step_height = 0.4;
    /// m, 0 to 2: maximum drop per step over which it stays on a descending floor
    double floor_snap = 0.4;
    double jump_speed = 5;            ///< m/s, 0 to 100; reaches a height of jump_speed^2 / (2 g)
    double ground_acceleration = 40;  ///< m/s^2, 0 to 1e5
    double air_acceleration = 4;      ///< m/s^2, 0 to 1e5
    /// Maximum force with which it pushes bodies in its way, N, 0 to 1e6. The impulse of an impact
    /// is not limited.
    double strength = 600;
};

/// Description of a character to create.
struct CharacterDef {
    CharacterKind kind = CharacterKind::sweeping;
    physics::Vec3 feet = {};       ///< m, lowest point, each component -9e6 to 9e6
    double heading = 0;            ///< rad about +y from -z, -1e6 to 1e6
    physics::Vec3 velocity = {};   ///< m/s, each component -5000 to 5000
    double radius = 0.3;           ///< m, 0.05 to 5
    double height = 1.8;           ///< m, at least 2 radius + 2 min_shape_size, at most 20
    double crouched_height = 1.1;  ///< m, at least 2 radius + 2 min_shape_size, at most height
    /// Distance that a sweeping character keeps from obstacles, m, 0.002 to half the radius. Its
    /// body is smaller by this margin on all sides, so the solver never presses it against other
    /// bodies. Rigid characters ignore it.
    double skin = 0.02;
    /// Ranges are documented in CharacterAbilities.
    CharacterAbilities abilities = {};
    /// Collision filter of its shape. A sweeping character collides with shapes that have a
    /// category in its mask.
    physics::Filter filter = {};
    std::uint64_t user_data = 0;  ///< of its body
};

/// Input of a character. It stays in effect until it is replaced.
struct CharacterControls {
    /// m/s relative to the ground it stands on, each component -1000 to 1000; y is ignored
    physics::Vec3 walk = {};
    bool jump = false;    ///< jumps once for each change from false to true
    bool crouch = false;  ///< crouches; stands up again only if there is room

    bool operator==(const CharacterControls&) const = default;
};

/// State of a character after the last step.
struct CharacterState {
    CharacterId id;
    CharacterKind kind = CharacterKind::sweeping;
    physics::BodyId body;    ///< the body that represents it in the world
    physics::Vec3 feet;      ///< m, lowest point
    double heading = 0;      ///< rad about +y, from -z
    physics::Vec3 velocity;  ///< m/s, world
    bool crouched = false;
    GroundKind ground = GroundKind::in_air;
    /// Ground contact. Meaningful only if `ground` is not in_air.
    physics::BodyId ground_body;
    physics::Vec3 ground_normal;    ///< unit
    physics::Vec3 ground_velocity;  ///< m/s, world, of the ground under the feet
    /// N s, sum of the impulses applied to other bodies in the last step.
    physics::Vec3 applied_impulse;
};

namespace character_detail {
struct CharacterStore;
}

/// Module that owns the characters of a world. Tag: "character".
class Characters : public physics::Module {
public:
    static constexpr std::size_t characters_max = 4096;  ///< maximum number in a world

    Characters();
    ~Characters() override;

    /// Creates a character and its body. The error names the invalid argument; the code is
    /// resource_exhausted if there are characters_max characters already.
    physics::Result<CharacterId> add(physics::World& world, const CharacterDef& def);
    /// Removes a character and its body. Like all calls with an id, it returns not_found if the
    /// character does not exist.
    physics::Status remove(physics::World& world, CharacterId id);
    /// Returns false after removal of the character.
    bool contains(CharacterId id) const;
    /// All characters, sorted by index.
    std::vector<CharacterId> ids() const;

    /// Replaces the controls and ends automatic strolling. invalid_argument if walk is out of
    /// range.
    physics::Status set_controls(CharacterId id, const CharacterControls& controls);
    physics::Result<CharacterControls> controls(CharacterId id) const;
    /// Replaces the abilities. The error names the field that is out of range.
    physics::Status set_abilities(CharacterId id, const CharacterAbilities& abilities);
    physics::Result<CharacterAbilities> abilities(CharacterId id) const;
    /// Teleports a character: it does not collide on the way.
    physics::Status set_feet(physics::World& world, CharacterId id, physics::Vec3 feet);
    /// Sets the velocity, m/s, world; each component -5000 to 5000. A sweeping character loses its
    /// ground contact until the next step.
    physics::Status set_velocity(physics::World& world, CharacterId id, physics::Vec3 velocity);
    /// Returns the state after the last step.
    physics::Result<CharacterState> state(const physics::World& world, CharacterId id) const;
    /// Returns the character that a body represents; a null id if there is none. Linear in the
    /// number of characters.
    CharacterId character_of(physics::BodyId body) const;

    std::string_view tag() const override { return "character"; }
    void visit(physics::StateVisitor& v) override;
    /// Configures the module from a scene. Each named body, under any name, becomes a character: a
    /// kinematic body a sweeping one, a dynamic body a rigid one. Its first shape must be an
    /// upright capsule. For a sweeping character, the capsule must be smaller than the character by
    /// the skin. The numbers apply to all characters:
    /// - the fields of CharacterAbilities, by name;
    /// - skin (m);
    /// - crouched_height (m; default: 0.6 of the height);
    /// - stroll (m/s, 0 to 20) and stroll_turn (rad/s, -10 to 10): speed and turn rate of a
    ///   character that has received no controls.
    physics::Status configure(physics::World& world,
                              const physics::ModuleSettings& settings) override;
    /// True for the bodies of characters.
    bool is_controllable(physics::BodyId body) const override;
    /// Applies driver input between steps. Axes 0 and 1 walk to the right and forward, relative to
    /// the view direction in axis 3, at up to 5 m/s. Buttons are those of Controls: bit 0 jumps,
    /// bit 1 crouches.
    void control(physics::World& world, physics::BodyId body,
                 const physics::Controls& controls) override;
    bool visit_controlled_entity(physics::World& world, physics::BodyId body,
                                 physics::StateVisitor& v) override;
    /// Publishes the channel "character" for each body. Values: bits 0 = rigid, 1 = crouched, 2 and
    /// 3 = GroundKind; then, in 8 bits each, heading from -pi to pi rad, speed relative to the
    /// ground from 0 to 20 m/s, and vertical velocity from -20 to 20 m/s.
    std::vector<physics::ChannelKind> channels() const override { return {{}}; }
    void publish(const physics::World& world, physics::ChannelWriter& channels) const override;

    void before_step(physics::World& world, double dt) override;

private:
    std::unique_ptr<character_detail::CharacterStore> store_;
};

}  // namespace jostle::modules
