// SPDX-License-Identifier: MIT
#include "modules/crowd/src/crowd_step.h"

#include <algorithm>

#include "jostle/physics/limits.h"
#include "modules/crowd/src/steering.h"

namespace jostle::modules {

using namespace physics;

namespace crowd_detail {
namespace {

constexpr int agents_per_task = 32;
constexpr double overlap_tolerance = 1e-3;  // of the smallest radius
constexpr int iterations_max = 100;         // of keep_apart()
constexpr double grounded_speed = 1;  // m/s: an agent that rises or falls faster is in the air
constexpr double velocity_change_min = 1e-9;  // m/s: a smaller change must not wake the body

bool is_walker(const AgentRecord& record) {
    return record.alive && record.kind == AgentKind::walker;
}

}  // namespace

void update_routes(const World& world, CrowdStore& store) {
    CrowdScratch& scratch = store.scratch;
    if (!scratch.routes_stale) return;
    scratch.routes_stale = false;
    const bool same_walls = scratch.route_walls == store.walls;
    if (same_walls && scratch.route_goals == store.goals && scratch.route_grid == store.grid)
        return;
    scratch.route_walls = store.walls;
    scratch.route_goals = store.goals;
    scratch.route_grid = store.grid;
    scratch.wall_tree.build(store.walls);
    scratch.routes.clear();
    if (size_of(store.grid).columns == 0) return;
    scratch.routes.resize(store.goals.size());
    world.parallel_for(static_cast<int>(store.goals.size()), 1, [&](int first, int last) {
        for (int k = first; k < last; k++) {
            const auto goal = static_cast<std::size_t>(k);
            scratch.routes[goal].build(store.grid, scratch.wall_tree, store.goals[goal].areas);
        }
    });
}

void frighten(CrowdStore& store, std::size_t agent, Vec3 away) {
    AgentArrays& agents = store.agents;
    if (agents.record[agent].kind == AgentKind::walker) {
        Vec3 level = store.to_plane(away);
        level.z = 0;
        away = store.to_plane(level);
    }
    const double size = length(away);
    agents.panic[agent] = store.settings.panic_time;
    agents.flight[agent] = size > 1e-9 ? away * (1 / size) : Vec3{};
}

void forget(CrowdStore& store, std::size_t agent) {
    store.agents.record[agent].alive = false;
    store.agents.panic[agent] = 0;
}

void read_bodies(World& world, CrowdStore& store) {
    AgentArrays& agents = store.agents;
    CrowdScratch& scratch = store.scratch;
    const int count = static_cast<int>(agents.size());
    scratch.points.resize(agents.size());
    scratch.velocities.resize(agents.size());
    scratch.is_walker.resize(agents.size());
    scratch.is_flyer.resize(agents.size());
    scratch.stands.resize(agents.size());
    world.parallel_for(count, agents_per_task, [&](int first, int last) {
        for (auto k = static_cast<std::size_t>(first); k < static_cast<std::size_t>(last); k++) {
            AgentRecord& record = agents.record[k];
            if (record.alive && record.carrier != Carrier::none) {
                const Result<BodyState> body = world.body(record.body);
                if (!body.ok()) {
                    forget(store, k);
                } else {
                    Vec3 change = store.to_plane(body->linear_velocity - agents.velocity[k]);
                    if (record.kind == AgentKind::walker) change.z = 0;  // a landing is no blow
                    const double most = store.settings.blow_speed;
                    if (record.carrier == Carrier::dynamic && dot(change, change) > most * most)
                        frighten(store, k, store.to_plane(change));
                    agents.position[k] = body->center;
                    agents.velocity[k] = body->linear_velocity;
                }
            }
            scratch.is_walker[k] = is_walker(record);
            scratch.is_flyer[k] = record.alive && !scratch.is_walker[k];
            scratch.stands[k] = record.arrived || record.destination.aim == Aim::stand;
            scratch.points[k] = store.to_plane(agents.position[k]);
            scratch.velocities[k] = store.to_plane(agents.velocity[k]);
            if (scratch.is_walker[k]) scratch.velocities[k].z = 0;
        }
    });
}

void watch_threats(const World& world, CrowdStore& store) {
    std::erase_if(store.threats,
                  [&](const Threat& threat) { return !world.contains(threat.body); });
    for (const Threat& threat : store.threats) {
        const Result<BodyState> body = world.body(threat.body);
        if (!body.ok()) continue;
        for (std::size_t k = 0; k < store.agents.size(); k++) {
            const Vec3 away = store.agents.position[k] - body->center;
            if (store.agents.record[k].alive && store.agents.record[k].body != threat.body &&
                dot(away, away) < threat.radius * threat.radius)
                frighten(store, k, away);
        }
    }
}

void plan(const World& world, CrowdStore& store, double dt) {
    AgentArrays& agents = store.agents;
    CrowdScratch& scratch = store.scratch;
    const std::size_t size = agents.size();
    scratch.wishes.resize(size);
    scratch.planned.resize(size);
    scratch.next_panic.resize(size);
    scratch.next_flight.resize(size);
    scratch.near_wall.resize(size);
    scratch.leaves.resize(size);
    double flock_reach = 0.1;
    for (const FlockDef& flock : store.flocks) flock_reach = maximum(flock_reach, flock.reach);
    const std::size_t most = store.settings.neighbors;
    scratch.walkers.update(world, scratch.points, agents.radius, scratch.is_walker,
                           {store.settings.reach, most, true});
    scratch.flyers.update(world, scratch.points, agents.radius, scratch.is_flyer,
                          {flock_reach, neighbors_max, false});
    const auto for_agents = [&](const auto& function) {
        world.parallel_for(static_cast<int>(size), agents_per_task, [&](int first, int last) {
            for (auto k = static_cast<std::size_t>(first); k < static_cast<std::size_t>(last); k++)
                if (agents.record[k].alive) function(k);
        });
    };
    std::ranges::fill(scratch.near_wall, std::uint8_t{0});
    std::ranges::fill(scratch.leaves, std::uint8_t{0});
    for_agents([&](std::size_t k) {
        const Wish wish = wish_of(world, store, k);
        scratch.wishes[k] = wish.velocity;
        scratch.leaves[k] = wish.leaves;
        agents.record[k].arrived = wish.arrived;
        const NeighborLists& lists = scratch.is_walker[k] ? scratch.walkers : scratch.flyers;
        spread_panic(store, k, lists.of(k), dt);
    });
    for_agents([&](std::size_t k) {
        if (scratch.is_walker[k])
            plan_walker(store, k, dt);
        else
            plan_flyer(store, k, dt);
    });
    for (std::size_t k = 0; k < size; k++) {
        if (!agents.record[k].alive) continue;
        agents.panic[k] = scratch.next_panic[k];
        agents.flight[k] = scratch.next_flight[k];
    }
}

void remove_leavers(World& world, CrowdStore& store) {
    for (std::size_t k = 0; k < store.agents.size(); k++) {
        if (!store.scratch.leaves[k]) continue;
        const BodyId body = store.agents.record[k].body;
        forget(store, k);
        store.left++;
        if (world.contains(body)) static_cast<void>(world.destroy_body(body));
    }
}

namespace {

// Lists the pairs of agents that may touch within the step, each once, in order of their first
// agent.
void find_contacts(CrowdStore& store, const NeighborLists& lists,
                   std::span<const std::uint8_t> is_member, bool flat, double dt) {
    CrowdScratch& scratch = store.scratch;
    const auto& radius = store.agents.radius;
    for (std::size_t a = 0; a < store.agents.size(); a++) {
        if (!is_member[a] || !store.agents.record[a].alive) continue;
        for (const NearPoint& near : lists.of(a)) {
            const std::size_t b = near.index;
            if (!store.agents.record[b].alive) continue;
            const double radii = radius[a] + radius[b];
            const double closing = (length(scratch.planned[a]) + length(scratch.planned[b])) * dt;
            // gap: squared distance minus squared sum of radii
            if (near.gap > closing * (closing + 2 * radii)) continue;
            // If both list each other, the pair belongs to the smaller index.
            const auto listed = [&](const NearPoint& other) { return other.index == a; };
            if (a > b && std::ranges::any_of(lists.of(b), listed)) continue;
            Vec3 offset = scratch.points[b] - scratch.points[a];
            if (flat && absolute(offset.z) > story_height) continue;
            if (flat) offset.z = 0;
            const double distance = length(offset);
            // Agents at the same point separate along an axis.
            const Vec3 normal = distance > 1e-9 ? offset * (1 / distance) : Vec3{1, 0, 0};
            const double mass_a = radius[a] * radius[a], mass_b = radius[b] * radius[b];
            scratch.contacts.push_back({static_cast<std::uint32_t>(a),
                                        static_cast<std::uint32_t>(b), normal, distance - radii,
                                        mass_b / (mass_a + mass_b)});
        }
    }
}

void find_wall_contacts(CrowdStore& store, double dt) {
    CrowdScratch& scratch = store.scratch;
    for (std::size_t k = 0; k < store.agents.size(); k++) {
        if (!scratch.near_wall[k] || !store.agents.record[k].alive) continue;
        const double radius = store.agents.radius[k];
        NearWalls walls;
        const Vec3 p = scratch.points[k];
        scratch.wall_tree.find({p.x, p.y}, radius + 2 * length(scratch.planned[k]) * dt, walls);
        for (std::size_t w = 0; w < walls.count; w++) {
            const NearWall& wall = walls.walls[w];
            const double size = wall.distance > 0 ? wall.distance : 1;
            const Vec3 normal{-wall.offset.x / size, -wall.offset.y / size, 0};
            scratch.wall_contacts.push_back(
                {static_cast<std::uint32_t>(k), normal, wall.distance - radius});
        }
    }
}

}  // namespace

void exclude_overlaps(CrowdStore& store, double dt) {
    CrowdScratch& scratch = store.scratch;
    scratch.contacts.clear();
    scratch.wall_contacts.clear();
    find_contacts(store, scratch.walkers, scratch.is_walker, true, dt);
    find_contacts(store, scratch.flyers, scratch.is_flyer, false, dt);
    find_wall_contacts(store, dt);
    scratch.planned_overlap = 0;
    if (scratch.contacts.empty() && scratch.wall_contacts.empty()) return;
    double smallest = 1e300;
    for (const DiscContact& contact : scratch.contacts)
        smallest = minimum(smallest,
                           minimum(store.agents.radius[contact.a], store.agents.radius[contact.b]));
    for (const WallContact& contact : scratch.wall_contacts)
        smallest = minimum(smallest, store.agents.radius[contact.agent]);
    scratch.planned_overlap = keep_apart(scratch.planned, scratch.contacts, scratch.wall_contacts,
                                         dt, overlap_tolerance * smallest, iterations_max)
                                  .overlap;
}

namespace {

Vec3 within_world(Vec3 p) {
    constexpr double most = limits::max_coordinate;
    return {clamp(p.x, -most, most), clamp(p.y, -most, most), clamp(p.z, -most, most)};
}

void move_kinematic_body(World& world, BodyId id, Vec3 current, Vec3 velocity) {
    if (velocity != current) static_cast<void>(world.set_linear_velocity(id, velocity));
}

// Accelerates a dynamic body: walkers along the ground while they stand on it.
void push_dynamic_body(World& world, const AgentRecord& record, Vec3 velocity, Vec3 up, double dt) {
    const Result<BodyState> body = world.body(record.body);
    if (!body.ok() || body->type != BodyType::dynamic) return;
    Vec3 change = velocity - body->linear_velocity;
    if (record.kind == AgentKind::walker) {
        if (absolute(dot(body->linear_velocity, up)) > grounded_speed) return;
        change -= up * dot(change, up);
    }
    const double size = length(change), most = record.acceleration * dt;
    if (size < velocity_change_min) return;
    if (size > most) change = change * (most / size);
    static_cast<void>(world.apply_impulse(record.body, change * body->mass, body->center));
}

void walk_character(World& world, const AgentRecord& record, Vec3 velocity) {
    auto* characters = dynamic_cast<Characters*>(world.module("character"));
    if (characters == nullptr) return;
    Result<CharacterControls> controls = characters->controls(record.character);
    if (!controls.ok() || controls->walk == velocity) return;
    controls->walk = velocity;
    static_cast<void>(characters->set_controls(record.character, *controls));
}

}  // namespace

void apply_plan(World& world, CrowdStore& store, double dt) {
    AgentArrays& agents = store.agents;
    // In a vertical plane no direction is up, and the solver holds the third coordinate.
    const Vec3 up = store.settings.vertical ? Vec3{} : Vec3{0, 1, 0};
    for (std::size_t k = 0; k < agents.size(); k++) {
        const AgentRecord& record = agents.record[k];
        if (!record.alive) continue;
        const Vec3 velocity = store.to_plane(store.scratch.planned[k]);
        switch (record.carrier) {
            case Carrier::none:
                agents.position[k] = within_world(agents.position[k] + velocity * dt);
                agents.velocity[k] = velocity;
                break;
            case Carrier::kinematic:
                move_kinematic_body(world, record.body, agents.velocity[k], velocity);
                agents.velocity[k] = velocity;
                break;
            case Carrier::dynamic: {
                push_dynamic_body(world, record, velocity, up, dt);
                const Result<BodyState> body = world.body(record.body);
                if (body.ok()) agents.velocity[k] = body->linear_velocity;
                break;
            }
            case Carrier::character:
                walk_character(world, record, velocity);
                agents.velocity[k] = velocity;
                break;
        }
    }
}

}  // namespace crowd_detail

void Crowd::before_step(World& world, double dt) {
    crowd_detail::CrowdStore& store = *store_;
    if (store.agents.size() == 0) return;
    update_routes(world, store);
    read_bodies(world, store);
    watch_threats(world, store);
    plan(world, store, dt);
    remove_leavers(world, store);
    exclude_overlaps(store, dt);
    apply_plan(world, store, dt);
    store.steps++;
}

}  // namespace jostle::modules
