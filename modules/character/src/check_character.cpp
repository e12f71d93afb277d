// SPDX-License-Identifier: MIT
#include "modules/character/src/check_character.h"

#include <cstdio>

namespace jostle::modules::character_detail {
namespace {

using namespace physics;

Status check(const char* name, double value, double low, double high) {
    if (value >= low && value <= high) return {};
    char text[160];
    std::snprintf(text, sizeof text, "%s is %.10g; it must be from %.10g to %.10g", name, value,
                  low, high);
    return Error{ErrorCode::invalid_argument, text};
}

Status check(const char* name, Vec3 value, double most) {
    for (const double component : {value.x, value.y, value.z})
        if (Status s = check(name, component, -most, most); !s.ok()) return s;
    return {};
}

Status check_size(const CharacterDef& def) {
    if (Status s = check("radius", def.radius, radius_min, radius_max); !s.ok()) return s;
    // A capsule needs a cylindrical section, however short.
    const double least = 2 * def.radius + 2 * min_shape_size;
    if (Status s = check("height", def.height, least, height_max); !s.ok()) return s;
    if (Status s = check("crouched_height", def.crouched_height, least, def.height); !s.ok())
        return s;
    if (def.kind == CharacterKind::rigid) return {};
    return check("skin", def.skin, skin_min, 0.5 * def.radius);
}

}  // namespace

Status check_def(const CharacterDef& def) {
    if (def.kind != CharacterKind::sweeping && def.kind != CharacterKind::rigid)
        return Error{ErrorCode::invalid_argument,
                     "kind is out of range; it must be sweeping (0) or rigid (1)"};
    if (Status s = check_feet(def.feet); !s.ok()) return s;
    if (Status s = check("heading", def.heading, -1e6, 1e6); !s.ok()) return s;
    if (Status s = check_velocity(def.velocity); !s.ok()) return s;
    if (Status s = check_size(def); !s.ok()) return s;
    return check_abilities(def.abilities);
}

Status check_abilities(const CharacterAbilities& abilities) {
    for (const Ability& a : ability_ranges)
        if (Status s = check(a.name, abilities.*a.value, a.low, a.high); !s.ok()) return s;
    return {};
}

Status check_walk(Vec3 walk) {
    return check("walk", walk, walk_speed_max);
}
Status check_feet(Vec3 feet) {
    return check("feet", feet, coordinate_max);
}
Status check_velocity(Vec3 velocity) {
    return check("velocity", velocity, speed_max);
}

}  // namespace jostle::modules::character_detail
