// SPDX-License-Identifier: MIT
//
// State of a crowd between steps, and memory that steps reuse.
#pragma once

#include <vector>

#include "jostle/modules/character.h"
#include "jostle/modules/crowd.h"
#include "modules/crowd/src/flow_field.h"
#include "modules/crowd/src/keep_apart.h"
#include "modules/crowd/src/neighbor_lists.h"
#include "modules/crowd/src/wall_tree.h"

namespace jostle::modules::crowd_detail {

// Range of coordinates, m.
inline constexpr double coordinate_max = 1e6;

// The kind of body that an agent moves.
enum class Carrier : std::uint8_t { none, kinematic, dynamic, character };

// Description of an agent; its motion is in the arrays of AgentArrays.
struct AgentRecord {
    std::uint32_t generation = 0;
    bool alive = false;
    Carrier carrier = Carrier::none;
    AgentKind kind = AgentKind::walker;
    physics::BodyId body;
    CharacterId character;
    double speed = 0, max_speed = 0, acceleration = 0;  // m/s, m/s, m/s^2
    bool slows_in_crowds = false;
    std::uint32_t flock = 0;
    Destination destination;
    bool arrived = false;
};

// One element per agent, in order of their index.
struct AgentArrays {
    std::vector<AgentRecord> record;
    std::vector<physics::Vec3> position, velocity;  // m, m/s, world
    std::vector<double> radius;                     // m
    std::vector<double> panic;                      // s, remaining
    std::vector<physics::Vec3> flight;  // unit vector away from the cause of the panic, or zero
    std::vector<double> pace;           // m/s, highest speed in the density around a walker

    std::size_t size() const { return record.size(); }
    void resize(std::size_t size) {
        record.resize(size);
        position.resize(size), velocity.resize(size);
        radius.resize(size), panic.resize(size), flight.resize(size), pace.resize(size);
    }
};

// Not part of the state: derived from it, or valid within a step only.
struct CrowdScratch {
    // Routes, and what they were computed from.
    bool routes_stale = true;       // goals, walls or grid may have changed
    std::vector<FlowField> routes;  // one per goal; empty without a grid
    WallTree wall_tree;
    std::vector<GoalDef> route_goals;
    std::vector<Wall> route_walls;
    RouteGrid route_grid;

    NeighborLists walkers, flyers;
    std::vector<physics::Vec3> points;              // positions in plane coordinates, height last
    std::vector<physics::Vec3> velocities;          // m/s, in plane coordinates
    std::vector<physics::Vec3> wishes;              // m/s, likewise
    std::vector<physics::Vec3> planned;             // m/s, in plane coordinates
    std::vector<std::uint8_t> is_walker, is_flyer;  // living agents by kind
    std::vector<std::uint8_t> stands;               // at its destination, or has none
    std::vector<double> next_panic;
    std::vector<physics::Vec3> next_flight;
    std::vector<DiscContact> contacts;
    std::vector<WallContact> wall_contacts;
    std::vector<std::uint8_t> near_wall;  // walkers that a wall may stop in this step
    std::vector<std::uint8_t> leaves;     // reached a goal at which it leaves the world
    double planned_overlap = 0;
};

struct CrowdStore {
    CrowdSettings settings;
    AgentArrays agents;
    std::vector<GoalDef> goals;
    std::vector<FlockDef> flocks;
    std::vector<Wall> walls;
    RouteGrid grid;
    std::vector<Threat> threats;
    std::uint64_t steps = 0;  // selects the random numbers
    std::uint64_t left = 0;   // agents that left the world

    CrowdScratch scratch;

    // Plane coordinates of a world vector, with the height last, and back.
    physics::Vec3 to_plane(physics::Vec3 v) const {
        return settings.vertical ? v : physics::Vec3{v.x, v.z, v.y};
    }
    bool contains(AgentId id) const {
        return id.index < agents.size() && agents.record[id.index].alive &&
               agents.record[id.index].generation == id.generation;
    }
};

}  // namespace jostle::modules::crowd_detail
