// SPDX-License-Identifier: MIT
//
// Plans the velocity of one agent for the next step, before overlaps are excluded. Reads the state
// of the last step only, so agents are planned concurrently.
#pragma once

#include "modules/crowd/src/crowd_data.h"

namespace jostle::modules::crowd_detail {

// m: walkers that differ more in height do not meet.
inline constexpr double story_height = 1.8;

// The velocity that an agent would choose if it were alone, in plane coordinates.
struct Wish {
    physics::Vec3 velocity;  // m/s
    bool arrived = false;
    bool leaves = false;  // has reached a goal at which it leaves the world
};

// Velocity towards the destination, without regard to others. Advances to the next goal at a goal
// with GoalEnd::next.
Wish wish_of(const physics::World& world, CrowdStore& store, std::size_t agent);

// Panic of the agent after this step, from its own and that of its neighbours.
void spread_panic(CrowdStore& store, std::size_t agent, std::span<const NearPoint> neighbors,
                  double dt);

// Plan the velocity of an agent from the wishes of all agents, in plane coordinates.
void plan_walker(CrowdStore& store, std::size_t agent, double dt);
void plan_flyer(CrowdStore& store, std::size_t agent, double dt);

// Limits the change of a velocity to the acceleration of the agent.
physics::Vec3 accelerated(const CrowdStore& store, std::size_t agent, physics::Vec3 target,
                          double dt);

}  // namespace jostle::modules::crowd_detail
