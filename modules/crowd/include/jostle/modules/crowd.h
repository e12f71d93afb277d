// SPDX-License-Identifier: MIT
//
// Crowds and flocks: agents that walk to goals around walls and each other, or fly in flocks.
//
// A *walker* chooses its velocity by optimal reciprocal collision avoidance (ORCA; van den Berg,
// Guy, Lin and Manocha, 2011) and follows a route to its goal (fast marching on a grid). A *flyer*
// steers by separation, alignment and cohesion (Reynolds, 1987). The velocities of all agents are
// then corrected so that no two agents overlap after the step (Maury and Venel, 2011). Agents move
// kinematic or dynamic bodies, or characters, or have no body.
//
//     auto owned = std::make_unique<Crowd>();
//     Crowd& crowd = *owned;
//     world.add_module(std::move(owned)).expect();
//     const std::uint32_t exit = crowd.add_goal({.areas = {{{20, 0}}}}).value();
//     crowd.add(world, {.body = body, .destination = {.aim = Aim::goal, .goal = exit}}).value();
//
// Agents plan in before_step(). Add the crowd before the module "character" if it moves characters.
//
// Thread rule: that of World. Non-const calls are made between steps by the thread that owns the
// world. Planning uses all threads of the world; results are bit-identical for any number.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "jostle/modules/crowd_def.h"
#include "jostle/physics/module.h"
#include "jostle/physics/world.h"

namespace jostle::modules {

namespace crowd_detail {
struct CrowdStore;
}

/// Module that owns the agents of a world. Tag: "crowd".
class Crowd final : public physics::Module {
public:
    /// Maximum numbers in a world.
    static constexpr std::size_t agents_max = 16384, goals_max = 16, flocks_max = 64,
                                 walls_max = 4096, threats_max = 16;

    Crowd();
    ~Crowd() override;

    /// Replaces the settings. The error names the field that is out of range.
    physics::Status set_settings(const CrowdSettings& settings);
    const CrowdSettings& settings() const;

    // --- agents ---
    /// Adds an agent. The error names the invalid field; the code is resource_exhausted if there
    /// are agents_max agents already. Rotation of a dynamic body is locked for walkers.
    physics::Result<AgentId> add(physics::World& world, const AgentDef& def);
    /// Removes an agent and its body. Like all calls with an id, it returns not_found if the agent
    /// does not exist.
    physics::Status remove(physics::World& world, AgentId id);
    bool contains(AgentId id) const;
    /// All agents, sorted by index.
    std::vector<AgentId> ids() const;
    /// Returns the agent that moves a body; a null id if there is none. Linear in the number of
    /// agents.
    AgentId agent_of(physics::BodyId body) const;
    /// Replaces the destination. The error names the field that is out of range.
    physics::Status set_destination(AgentId id, const Destination& destination);
    physics::Result<Destination> destination(AgentId id) const;
    /// Returns the state after the last step.
    physics::Result<AgentState> state(const physics::World& world, AgentId id) const;

    // --- surroundings ---
    /// Adds a goal and returns its index.
    physics::Result<std::uint32_t> add_goal(const GoalDef& goal);
    /// Replaces a goal. Errors are those of add_goal(), and not_found for an unknown index.
    physics::Status set_goal(std::uint32_t index, const GoalDef& goal);
    /// Adds a flock and returns its index.
    physics::Result<std::uint32_t> add_flock(const FlockDef& flock);
    /// Adds a wall between two points in plane coordinates, m, each component -1e6 to 1e6.
    physics::Status add_wall(physics::Vec2 from, physics::Vec2 to);
    /// Adds the outline of a body, which walls in the plane: the convex hull of each of its boxes,
    /// hulls and round shapes. The outline does not move with the body. Errors: invalid_argument
    /// for a body without such a shape.
    physics::Status add_walls_of(const physics::World& world, physics::BodyId body);
    /// Sets the grid of routes. Routes are computed when the grid, the goals or the walls change,
    /// in the next step.
    physics::Status set_routes(const RouteGrid& grid);
    /// Adds a body from which agents flee.
    physics::Status add_threat(const physics::World& world, const Threat& threat);
    /// Frightens the agents within `radius` m (0 to 1e4) of a point.
    physics::Status alarm(physics::Vec3 center, double radius);

    // --- results ---
    /// Counts after the last step.
    struct Counts {
        std::uint32_t agents = 0;    ///< in the world
        std::uint32_t arrived = 0;   ///< at their point or goal
        std::uint32_t panicked = 0;  ///< in panic
        std::uint64_t left = 0;      ///< that left the world at a goal so far
    };
    Counts counts() const;
    /// Largest overlap of two agents that the last step planned, m. Contacts with other bodies may
    /// add to it for dynamic bodies.
    double planned_overlap() const;

    std::string_view tag() const override { return "crowd"; }
    void visit(physics::StateVisitor& v) override;
    void restored(const physics::World& world) override;
    /// Configures the module from a scene. Settings without a prefix are those of CrowdSettings.
    /// Each set of settings with a prefix adds one object: route_*, wall_*, obstacle_*, goal_*,
    /// flock_*, threat_*, agent_* and group_*. docs/reference/scene_format.md lists all settings.
    physics::Status configure(physics::World& world,
                              const physics::ModuleSettings& settings) override;
    /// Publishes two channels. "crowd": numbers of agents, of arrived ones, of ones in panic, and
    /// of ones that left. "crowd.points", every sixth step: a point object with the agents without
    /// a body, and the radius of the first of them.
    std::vector<physics::ChannelKind> channels() const override;
    void publish(const physics::World& world, physics::ChannelWriter& channels) const override;

    void before_step(physics::World& world, double dt) override;

private:
    std::unique_ptr<crowd_detail::CrowdStore> store_;
};

}  // namespace jostle::modules
