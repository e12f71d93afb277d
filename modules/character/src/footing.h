// SPDX-License-Identifier: MIT
//
// What a character stands on, of all that it touches.
#pragma once

#include <span>

#include "modules/character/src/environment_query.h"

namespace jostle::modules::character_detail {

struct Footing {
    GroundKind kind = GroundKind::in_air;
    physics::BodyId body;
    physics::ShapeId shape;
    physics::Vec3 normal;   // of the ground; of the tread, where an edge of a step holds it
    physics::Vec3 contact;  // normal of the contact itself
    physics::Vec3 point;
    double gap = 0;
};

// The least upward part of a normal that can be walked on.
double min_walkable_normal_y(const CharacterData& record);

// Of contacts that are no further than `close`. `feet`: m, of the character where they were found.
Footing find_footing(const EnvironmentQuery& near, const CharacterData& record, physics::Vec3 feet,
                     std::span<const Contact> contacts, double close);

// Whether a steep contact is the edge of a step: there is floor behind it, no higher than a step,
// and floor no more than a step below. On the edge of a cliff nobody stands by his side.
bool is_step_edge(const EnvironmentQuery& near, const CharacterData& record, physics::Vec3 feet,
                  physics::Vec3 point, physics::Vec3 normal);

}  // namespace jostle::modules::character_detail
