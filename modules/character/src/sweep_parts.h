// SPDX-License-Identifier: MIT
//
// The parts of sweep_step: climbing, pushing, and moving the body of the character.
#pragma once

#include <optional>
#include <vector>

#include "jostle/physics/world.h"
#include "modules/character/src/character_data.h"
#include "modules/character/src/environment_query.h"

namespace jostle::modules::character_detail {

// Climbing a step: up, forward and down.
//
// Returns the centre after climbing a step that blocks a horizontal displacement (m) from `from`;
// nullopt if there is no climbable step. The result advances by more than min_progress (m) along
// the displacement.
std::optional<physics::Vec3> climb(const EnvironmentQuery& near, const CharacterData& record,
                                   physics::Vec3 from, physics::Vec3 displacement,
                                   double min_progress);

// Lowers the character from `from` by at most `drop` (m). Returns the centre where it stands on
// walkable floor or on the edge of a step, at most floor_height_max (m, world y) high; otherwise
// nullopt.
std::optional<physics::Vec3> step_down(const EnvironmentQuery& near, const CharacterData& record,
                                       physics::Vec3 from, double drop, double floor_height_max);

// States of bodies before they were pushed in this step. Other bodies may block a pushed body, so
// its actual motion is known only after the world has stepped.
class PrePushStates {
public:
    // Call before the first push.
    void store(const physics::World& world, physics::BodyId id);
    // Returns the stored state; the current state of a body that was not stored.
    physics::Result<physics::BodyState> of(const physics::World& world, physics::BodyId id) const;

private:
    std::vector<physics::BodyState> bodies_;  // only dynamic bodies
};

// Impulses that a character applies to a dynamic body in its way. The impact is perfectly inelastic
// and conserves the momentum of both. The subsequent effort is limited. Its reaction acts on the
// ground if the character stands, otherwise on the character itself.
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

// Moves the body of a sweeping character to the character.
//
// Moves the body to the feet of the character within the step, no faster than `speed` (m/s). The
// rest of the displacement, from climbing a step (`rise`, m) or from leaving an overlap, is a
// teleport, so it does not strike other bodies.
void move_kinematic_body(physics::World& world, const CharacterData& record, double rise,
                         double speed, double dt);

}  // namespace jostle::modules::character_detail
