// SPDX-License-Identifier: MIT
//
// Impulses that a character applies to a dynamic body in its way. The impact is perfectly inelastic
// and conserves the momentum of both. The subsequent effort is limited. Its reaction acts on the
// ground if the character stands, otherwise on the character itself.
#pragma once

#include "modules/character/src/environment_query.h"

namespace jostle::modules::character_detail {

struct PushState {
    physics::Vec3 initial_velocity;  // m/s of the character without the effort, world
    physics::Vec3 velocity;          // m/s with the effort
    double effort = 0;               // N s, remaining budget of the step
    double dt = 0;                   // s of the step
    bool on_ground = false;
    bool is_new_contact = true;  // false if they touched in the last step; then there is no impact
};
struct PushResult {
    double impact = 0, effort = 0;  // N s along -normal
    // Velocity change along -normal by the effort, m/s, assuming that nothing else blocks the body.
    double velocity_change = 0;
};

// Pushes the body and deducts the effort and the reaction from `push`.
PushResult push_body(physics::World& world, const Contact& contact, double mass, PushState& push);

}  // namespace jostle::modules::character_detail
