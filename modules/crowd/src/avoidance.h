// SPDX-License-Identifier: MIT
//
// Half-planes of optimal reciprocal collision avoidance (ORCA): velocities of a disc that keep it
// clear of other discs and of walls for some time, if the other discs take the same care.
//
// Source: J. van den Berg, S. Guy, M. Lin, D. Manocha, "Reciprocal n-Body Collision Avoidance"
// (ISRR 2009, Springer 2011), sections 4 and 5.4.
#pragma once

#include <array>
#include <cstddef>

#include "modules/crowd/src/linear_program.h"
#include "modules/crowd/src/neighbor_lists.h"

namespace jostle::modules::crowd_detail {

// Neighbours of one agent. Single precision: positions and velocities are relative to the agent.
struct RelativeNeighbors {
    std::array<float, neighbors_max> x, y;    // m, position relative to the agent
    std::array<float, neighbors_max> vx, vy;  // m/s, velocity of the agent
    std::array<float, neighbors_max> rx, ry;  // m/s, velocity of the agent minus theirs
    std::array<float, neighbors_max> radii;   // m, sum of both radii
    std::array<float, neighbors_max> share;   // part of the correction that the agent takes
    std::size_t count = 0;
};

// Computes the permitted velocities of an agent, one half-plane for each neighbour. Agents stay
// apart for `horizon` s; agents that overlap separate within `dt`.
void avoid_agents(const RelativeNeighbors& neighbors, float horizon, float dt, HalfPlane* planes);

// Returns the permitted velocities next to a wall: the agent approaches its nearest point by at
// most the gap within `horizon` s, or leaves it within `dt` if it overlaps. (x, y): vector from the
// agent to that point, m; `distance`: its length, > 0. Standing still is permitted, so walls do not
// contradict each other unless the agent overlaps them.
HalfPlane avoid_wall(float x, float y, float distance, float radius, float horizon, float dt);

}  // namespace jostle::modules::crowd_detail
