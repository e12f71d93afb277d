// SPDX-License-Identifier: MIT
//
// Descriptions of agents, goals, flocks and settings of a crowd (jostle/modules/crowd.h).
//
// Walkers move in a plane: x and z of the world, or x and y if CrowdSettings::vertical is set, as
// in a planar world. Plane coordinates are Vec2{x, z} or Vec2{x, y}.
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "jostle/physics/ids.h"
#include "jostle/physics/vec2.h"
#include "jostle/physics/vec3.h"

namespace jostle::modules {

/// Identifies an agent. Valid until the agent is removed. A default id is null.
struct AgentId {
    std::uint32_t index = 0xffffffff;
    std::uint32_t generation = 0;

    auto operator<=>(const AgentId&) const = default;
};

/// How an agent chooses its velocity.
enum class AgentKind : std::uint8_t {
    walker,  ///< in a plane, avoids others by reciprocal collision avoidance
    flyer,   ///< in space (in a planar world: in its plane), steers with its flock
};

/// Kind of destination.
enum class Aim : std::uint8_t {
    stand,   ///< stays where it is, but makes way
    move,    ///< moves with Destination::velocity
    point,   ///< walks straight to Destination::point and stays there
    goal,    ///< follows the route to goal number Destination::goal
    follow,  ///< follows Destination::body at Destination::distance
};

/// Destination of an agent. Only the values of its aim are used.
struct Destination {
    Aim aim = Aim::stand;
    physics::Vec3 velocity = {};  ///< m/s, each component -100 to 100
    physics::Vec3 point = {};     ///< m, each component -1e6 to 1e6
    std::uint32_t goal = 0;       ///< index of a goal
    physics::BodyId body = {};    ///< the followed body
    double distance = 1;          ///< m between the centres, 0 to 1000

    bool operator==(const Destination&) const = default;
};

/// Description of an agent to create.
struct AgentDef {
    /// The body that the agent moves. A kinematic body moves exactly as planned and pushes dynamic
    /// bodies. A dynamic body is accelerated by impulses and takes part in contacts like any other
    /// body. A body of the module "character" receives walking controls. With a null id the agent
    /// has no body and moves at `position`.
    physics::BodyId body = {};
    physics::Vec3 position = {};  ///< m, each component -1e6 to 1e6; used without a body
    AgentKind kind = AgentKind::walker;
    double radius = 0.2;       ///< m, 0.05 to 5
    double speed = 1.34;       ///< m/s, preferred speed, 0 to 50
    double max_speed = 2;      ///< m/s, at least `speed`, at most 100
    double acceleration = 20;  ///< m/s^2, 0.1 to 1e4
    /// Walks slower in dense crowds, as people do: at most at the speed of Weidmann's fundamental
    /// diagram for the density ahead. Walkers only.
    bool slows_in_crowds = false;
    std::uint32_t flock = 0;  ///< index of a flock; flyers only
    Destination destination = {};
};

/// State of an agent after the last step.
struct AgentState {
    AgentId id;
    physics::BodyId body;    ///< null if the agent has no body
    physics::Vec3 position;  ///< m, centre of mass of its body
    physics::Vec3 velocity;  ///< m/s, planned in the last step
    double panic = 0;        ///< s, remaining panic; 0: calm
    bool arrived = false;    ///< reached its point or goal
};

/// Rectangle of a goal, in plane coordinates.
struct GoalArea {
    physics::Vec2 center = {};            ///< m, each component -1e6 to 1e6
    physics::Vec2 half_extents = {1, 1};  ///< m, each component 0.01 to 1e4

    bool operator==(const GoalArea&) const = default;
};

/// Behaviour of agents that reach a goal.
enum class GoalEnd : std::uint8_t {
    stay,   ///< stand there
    leave,  ///< leave the world: the agent and its body are destroyed
    next,   ///< walk on to another goal
};

/// A goal: areas of which agents walk to the nearest one.
struct GoalDef {
    std::vector<GoalArea> areas = {};  ///< 1 to 16
    GoalEnd end = GoalEnd::stay;
    /// Index of a goal, for GoalEnd::next; 0 to 15. Agents stay if there is no such goal.
    std::uint32_t next = 0;

    bool operator==(const GoalDef&) const = default;
};

/// Grid on which routes around walls are computed. Agents outside of it, and agents of a crowd
/// without a grid, walk straight to their goals.
struct RouteGrid {
    physics::Vec2 center = {};  ///< m, each component -1e6 to 1e6
    /// m, each component 0 to 1e4; 0: no grid. At most 2^17 cells.
    physics::Vec2 half_extents = {};
    double cell = 0.5;        ///< m, 0.05 to 100
    double clearance = 0.25;  ///< m, 0 to 10, distance of the routes from walls

    bool operator==(const RouteGrid&) const = default;
};

/// Steering of a flock. A flyer accelerates by the sum of the rules, within its acceleration.
/// Source: C. Reynolds, "Flocks, herds and schools", SIGGRAPH 1987.
struct FlockDef {
    double reach = 6;       ///< m, 0.1 to 100: distance at which flyers see the nearest 16 others
    double separation = 1;  ///< m, 0 to 100: distance that flyers keep from each other
    double separation_weight = 10;  ///< m/s^2, 0 to 1e3: away from neighbours nearer than that
    double alignment_weight = 6;    ///< 1/s, 0 to 100: to the mean velocity of the neighbours
    double cohesion_weight = 2;     ///< 1/s^2, 0 to 100: to the mean position of the neighbours
    double aim_weight = 0.5;        ///< 1/s, 0 to 100: to the velocity of its own destination
    /// Flyers turn back beyond `roam` m from `home`; 0 to 1e5, 0: no limit.
    double roam = 0;
    physics::Vec3 home = {};  ///< m, each component -1e6 to 1e6
};

/// Settings of a crowd.
struct CrowdSettings {
    std::uint32_t seed = 1;        ///< of the symmetry breaking
    bool vertical = false;         ///< walkers move along x and y, as in a planar world
    std::uint32_t neighbors = 10;  ///< 1 to 16, largest number of agents that a walker avoids
    double reach = 2.5;            ///< m, 0.2 to 50, distance at which walkers see each other
    double horizon = 2;            ///< s, 0.05 to 20: walkers avoid collisions within this time
    double wall_horizon = 0.5;     ///< s, 0.05 to 20: likewise with walls
    /// rad, -0.5 to 0.5: walkers veer to the right by this angle while others come towards them, so
    /// that opposing streams pass each other. 0: no preference.
    double side_preference = 0.03;
    double noise = 0.01;  ///< rad, 0 to 0.5: random change of direction, which breaks symmetry

    // Panic: an agent flees from an alarm, a threat or a blow, and its neighbours catch it.
    double panic_time = 6;   ///< s, 0 to 1000: duration of a new panic; 0: no panic
    double panic_speed = 4;  ///< m/s, 0 to 50: speed of agents in panic
    double contagion = 0.5;  ///< 0 to 0.99: panic that a neighbour catches, relative to its source
    /// m/s, 0.1 to 1e3: a sudden change of the velocity of a body that causes panic.
    double blow_speed = 3;

    bool operator==(const CrowdSettings&) const = default;
};

/// A body from which agents within a distance flee.
struct Threat {
    physics::BodyId body = {};
    double radius = 5;  ///< m, 0.1 to 1000
};

}  // namespace jostle::modules
