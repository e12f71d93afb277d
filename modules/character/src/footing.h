// SPDX-License-Identifier: MIT
//
// Selects the contact on which a character stands.
#pragma once

#include <span>

#include "modules/character/src/environment_query.h"

namespace jostle::modules::character_detail {

struct Footing {
    GroundKind kind = GroundKind::in_air;
    physics::BodyId body;
    physics::ShapeId shape;
    physics::Vec3 normal;   // of the ground; of the tread if the edge of a step supports it
    physics::Vec3 contact;  // normal of the contact itself
    physics::Vec3 point;
    double gap = 0;
};

// Smallest upward component of the normal of a walkable surface.
double min_walkable_normal_y(const CharacterData& record);

// Selects from the contacts with a gap of at most `close` (m). `feet` is the position of the
// character for which the contacts were found, m.
Footing find_footing(const EnvironmentQuery& near, const CharacterData& record, physics::Vec3 feet,
                     std::span<const Contact> contacts, double close);

// Returns true if a steep contact is the edge of a step: the floor behind it is no higher than a
// step, and there is floor at most one step below. The second condition excludes the edge of a
// cliff.
bool is_step_edge(const EnvironmentQuery& near, const CharacterData& record, physics::Vec3 feet,
                  physics::Vec3 point, physics::Vec3 normal);

}  // namespace jostle::modules::character_detail
