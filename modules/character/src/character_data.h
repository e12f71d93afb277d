// SPDX-License-Identifier: MIT
//
// What is kept of a character between steps.
#pragma once

#include <vector>

#include "jostle/modules/character.h"

namespace jostle::modules::character_detail {

inline constexpr physics::Vec3 up{0, 1, 0};
inline constexpr physics::AxisLocks upright =  // of a rigid one
    physics::lock_rotation_x | physics::lock_rotation_y | physics::lock_rotation_z;

inline physics::Vec3 horizontal(physics::Vec3 v) {
    return {v.x, 0, v.z};
}

struct CharacterData {
    std::uint32_t generation = 0;
    bool alive = false;

    CharacterKind kind = CharacterKind::sweeping;
    physics::BodyId body;
    double radius = 0.3, height = 1.8, crouched_height = 1.1, skin = 0.02;  // m
    double foot_height = 0;  // m: of the body's origin over the feet
    std::uint32_t mask = 0xffffffff;
    CharacterAbilities abilities;

    CharacterControls controls;
    bool jump_armed = true;                                // the button was up since the last jump
    double stroll = 0, stroll_turn = 0, stroll_angle = 0;  // m/s, rad/s, rad; 0 m/s: stands
    double heading = 0;

    physics::Vec3 feet;
    // m/s. On the ground: over the ground. Else in the world. Of a rigid one the body knows.
    physics::Vec3 velocity;
    bool crouched = false;
    GroundKind ground = GroundKind::in_air;
    physics::BodyId ground_body;
    physics::ShapeId ground_shape;
    physics::Vec3 ground_normal, ground_point, ground_velocity;
    physics::Vec3 applied_impulse;
    physics::BodyId pushed;  // in the last step
};

struct CharacterStore {
    std::vector<CharacterData> characters;

    CharacterData* find(CharacterId id) {
        if (id.index >= characters.size()) return nullptr;
        CharacterData& record = characters[id.index];
        return record.alive && record.generation == id.generation ? &record : nullptr;
    }
};

inline double current_height(const CharacterData& record) {
    return record.crouched ? record.crouched_height : record.height;
}
// What the world sees of one that sweeps, and what is swept; of a rigid one it has no skin.
inline physics::Capsule capsule_of(const CharacterData& record, double height) {
    return {record.radius - record.skin, 0.5 * height - record.radius};
}

}  // namespace jostle::modules::character_detail
