// SPDX-License-Identifier: MIT
//
// Stages of a step of the crowd, in the order in which Crowd::before_step() calls them.
#pragma once

#include "modules/crowd/src/crowd_data.h"

namespace jostle::modules::crowd_detail {

// Computes the routes and the tree of walls if goals, walls or the grid have changed.
void update_routes(const physics::World& world, CrowdStore& store);
// Copies positions and velocities of the bodies. Agents without their body are removed; a blow
// frightens its agent.
void read_bodies(physics::World& world, CrowdStore& store);
// Frightens agents near threats. Threats whose body is gone are removed.
void watch_threats(const physics::World& world, CrowdStore& store);
// Plans the velocities of all agents and spreads panic.
void plan(const physics::World& world, CrowdStore& store, double dt);
// Removes the agents that leave the world.
void remove_leavers(physics::World& world, CrowdStore& store);
// Corrects the planned velocities so that agents do not overlap each other or walls.
void exclude_overlaps(CrowdStore& store, double dt);
// Applies the planned velocities to bodies, characters and agents without a body.
void apply_plan(physics::World& world, CrowdStore& store, double dt);

// Frightens an agent. `away`: direction of the flight, any length.
void frighten(CrowdStore& store, std::size_t agent, physics::Vec3 away);
// Removes an agent, not its body.
void forget(CrowdStore& store, std::size_t agent);

}  // namespace jostle::modules::crowd_detail
