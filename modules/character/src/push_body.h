// SPDX-License-Identifier: MIT
//
// What a character gives to a dynamic body that is in its way. The impact is plastic and keeps the
// momentum of the two. Then it makes an effort, which is bounded: with its feet on the ground the
// ground bears that, else its own mass.
#pragma once

#include "modules/character/src/environment_query.h"

namespace jostle::modules::character_detail {

struct PushState {
    physics::Vec3 initial_velocity;  // m/s of the character before it made an effort, as the body's
    physics::Vec3 velocity;          // m/s with the effort
    double effort = 0;               // N s that are left of it
    double dt = 0;                   // s of the step
    bool on_ground = false;
    bool is_new_contact = true;  // false: they were together before, and there is no impact
};
struct PushResult {
    double impact = 0, effort = 0;  // N s along -normal
    // m/s along -normal that the effort will have given, if nothing else holds the body.
    double velocity_change = 0;
};

// Pushes the body, and takes what that costs off `push`.
PushResult push_body(physics::World& world, const Contact& contact, double mass, PushState& push);

}  // namespace jostle::modules::character_detail
