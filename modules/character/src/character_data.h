// SPDX-License-Identifier: MIT
//
// State of a character between steps.
#pragma once

#include <vector>

#include "jostle/modules/character.h"

namespace jostle::modules::character_detail {

inline constexpr physics::Vec3 up{0, 1, 0};
inline constexpr physics::AxisLocks upright =  // locks of a rigid character
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
    double foot_height = 0;  // m, height of the body's origin above the feet
    std::uint32_t mask = 0xffffffff;
    CharacterAbilities abilities;

    CharacterControls controls;
    bool jump_armed = true;  // jump was false in an earlier step since the last jump
    // m/s, rad/s, rad; a speed of 0 means no strolling
    double stroll = 0, stroll_turn = 0, stroll_angle = 0;
    double heading = 0;

    physics::Vec3 feet;
    // m/s. On the ground: relative to the ground. Otherwise: world. Unused for rigid characters,
    // whose body holds the velocity.
    physics::Vec3 velocity;
    bool crouched = false;
    GroundKind ground = GroundKind::in_air;
    physics::BodyId ground_body;
    physics::ShapeId ground_shape;
    physics::Vec3 ground_normal, ground_point, ground_velocity;
    physics::Vec3 applied_impulse;
    physics::BodyId pushed;  // body pushed in the last step
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
// The capsule in the world, which is also the one that is swept. The skin of a rigid character is
// 0.
inline physics::Capsule capsule_of(const CharacterData& record, double height) {
    return {record.radius - record.skin, 0.5 * height - record.radius};
}

}  // namespace jostle::modules::character_detail
