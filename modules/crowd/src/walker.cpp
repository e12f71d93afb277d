// SPDX-License-Identifier: MIT
//
// Velocity of a walker: reciprocal collision avoidance at the speed that the density allows.
#include <array>

#include "modules/crowd/src/avoidance.h"
#include "modules/crowd/src/steering.h"
#include "modules/crowd/src/walking_speed.h"

namespace jostle::modules::crowd_detail {

using namespace physics;

namespace {

constexpr double reaction_time = 0.5;       // s, in which a walker adapts to the density
constexpr std::uint64_t noise_period = 32;  // steps with the same noise

// A standing agent steps aside for a walking one: it takes this part of their correction.
constexpr float standing_share = 0.8f;

// -1 to 1, the same for noise_period steps.
double noise_of(const CrowdStore& store, std::size_t agent) {
    // Finalizer of MurmurHash3 (A. Appleby).
    std::uint64_t x = (store.steps / noise_period) * 0x9e3779b97f4a7c15u +
                      static_cast<std::uint64_t>(agent) * 0xbf58476d1ce4e5b9u + store.settings.seed;
    x = (x ^ (x >> 33)) * 0xff51afd7ed558ccdu;
    x = (x ^ (x >> 33)) * 0xc4ceb9fe1a85ec53u;
    return static_cast<double>(x >> 40) / 8388608.0 - 1;
}

Vec2 turned(Vec2 v, double angle) {
    const SinCos turn = sin_cos(angle);
    return {v.x * turn.cos - v.y * turn.sin, v.x * turn.sin + v.y * turn.cos};
}

// Whether a neighbour ahead comes towards the walker.
bool meets_others(const CrowdStore& store, std::size_t agent, Vec2 wish) {
    const CrowdScratch& scratch = store.scratch;
    for (const NearPoint& near : scratch.walkers.of(agent)) {
        const Vec3 offset = scratch.points[near.index] - scratch.points[agent];
        const Vec3 v = scratch.velocities[near.index];
        if (offset.x * wish.x + offset.y * wish.y > 0 && v.x * wish.x + v.y * wish.y < 0)
            return true;
    }
    return false;
}

// Speed that the density ahead allows.
double density_speed(const CrowdStore& store, std::size_t agent, Vec2 direction,
                     const NearWalls& walls) {
    const CrowdScratch& scratch = store.scratch;
    const auto neighbors = scratch.walkers.of(agent);
    const Vec3 p = scratch.points[agent];
    // With fewer neighbours than the limit, the reach contains no other ones.
    double radius = store.settings.reach, ahead = 0;
    const bool full = neighbors.size() == store.settings.neighbors;
    for (std::size_t k = 0; k < neighbors.size(); k++) {
        const Vec3 offset = scratch.points[neighbors[k].index] - p;
        const bool last = full && k + 1 == neighbors.size();
        if (last) radius = length(Vec2{offset.x, offset.y});
        if (offset.x * direction.x + offset.y * direction.y > 0) ahead += last ? 0.5 : 1;
    }
    const double density =
        density_ahead(maximum(radius, 0.1), ahead, std::span(walls.walls).first(walls.count));
    return store.agents.record[agent].speed * relative_walking_speed(density);
}

// Lists neighbours for avoid_agents().
//
// ORCA starts from the current velocities. An agent that is stopped by agents that stand would wait
// for ever, because the others see no reason to move. Between an agent that walks and one that
// stands, the wish of the walking one therefore counts, and the other one steps aside.
void collect(const CrowdStore& store, std::size_t agent, RelativeNeighbors& list) {
    const CrowdScratch& scratch = store.scratch;
    const Vec3 p = scratch.points[agent];
    const double radius = store.agents.radius[agent];
    const bool stands = scratch.stands[agent];
    for (const NearPoint& near : scratch.walkers.of(agent)) {
        const Vec3 offset = scratch.points[near.index] - p;
        if (absolute(offset.z) > story_height) continue;
        const bool other_stands = scratch.stands[near.index];
        const bool unequal = stands != other_stands;
        const Vec3 v = unequal && !stands ? scratch.wishes[agent] : scratch.velocities[agent];
        const Vec3 other =
            unequal && stands ? scratch.wishes[near.index] : scratch.velocities[near.index];
        const Vec3 relative = v - other;
        const std::size_t k = list.count++;
        list.x[k] = static_cast<float>(offset.x), list.y[k] = static_cast<float>(offset.y);
        list.vx[k] = static_cast<float>(v.x), list.vy[k] = static_cast<float>(v.y);
        list.rx[k] = static_cast<float>(relative.x), list.ry[k] = static_cast<float>(relative.y);
        list.radii[k] = static_cast<float>(radius + store.agents.radius[near.index]);
        list.share[k] = !unequal ? 0.5f : (stands ? standing_share : 1 - standing_share);
    }
    // The loops of avoid_agents() process groups of four.
    for (std::size_t k = list.count; k % 4 != 0; k++) {
        list.x[k] = list.y[k] = list.vx[k] = list.vy[k] = list.rx[k] = list.ry[k] = 1;
        list.radii[k] = list.share[k] = 1;
    }
}

}  // namespace

void plan_walker(CrowdStore& store, std::size_t agent, double dt) {
    CrowdScratch& scratch = store.scratch;
    const CrowdSettings& settings = store.settings;
    const AgentRecord& record = store.agents.record[agent];
    const Vec3 p = scratch.points[agent];
    const double radius = store.agents.radius[agent];
    const bool panicked = store.agents.panic[agent] > 0;
    const double max_speed =
        panicked ? maximum(settings.panic_speed, record.max_speed) : record.max_speed;
    const bool alone = scratch.walkers.of(agent).empty();

    Vec2 wish{scratch.wishes[agent].x, scratch.wishes[agent].y};
    const double speed = length(wish);
    NearWalls walls;
    if (!scratch.wall_tree.empty())
        scratch.wall_tree.find({p.x, p.y},
                               maximum(max_speed * settings.wall_horizon + radius,
                                       record.slows_in_crowds ? settings.reach : 0),
                               walls);
    if (speed > 1e-9 && (!alone || walls.count > 0)) {
        // Plane coordinates of a horizontal plane are mirrored: right is the positive sense.
        const double right = settings.vertical ? -1 : 1;
        const double veer = meets_others(store, agent, wish) ? right * settings.side_preference : 0;
        wish = turned(wish, veer + settings.noise * noise_of(store, agent));
    }
    if (record.slows_in_crowds && !panicked && speed > 1e-9) {
        double& pace = store.agents.pace[agent];
        const double allowed = density_speed(store, agent, wish * (1 / speed), walls);
        pace += (allowed - pace) * minimum(dt / reaction_time, 1);
        if (speed > pace) wish = wish * (pace / speed);
    }

    std::array<HalfPlane, half_planes_max> planes;
    std::size_t count = 0;
    for (std::size_t k = 0; k < walls.count; k++) {
        const NearWall& wall = walls.walls[k];
        if (wall.distance - radius > max_speed * settings.wall_horizon) break;
        planes[count++] =
            avoid_wall(static_cast<float>(wall.offset.x), static_cast<float>(wall.offset.y),
                       static_cast<float>(wall.distance), static_cast<float>(radius),
                       static_cast<float>(settings.wall_horizon), static_cast<float>(dt));
    }
    const std::size_t hard = count;
    if (!alone) {
        RelativeNeighbors neighbors;
        collect(store, agent, neighbors);
        avoid_agents(neighbors, static_cast<float>(settings.horizon), static_cast<float>(dt),
                     &planes[count]);
        count += neighbors.count;
    }
    const Velocity2 next = nearest_permitted_velocity(
        {planes.data(), count}, hard, {static_cast<float>(wish.x), static_cast<float>(wish.y)},
        static_cast<float>(max_speed));
    const double stop = radius + 2 * max_speed * dt;
    scratch.near_wall[agent] = walls.count > 0 && walls.walls[0].distance < stop;
    scratch.planned[agent] = accelerated(store, agent, {next.x, next.y, 0}, dt);
}

}  // namespace jostle::modules::crowd_detail
