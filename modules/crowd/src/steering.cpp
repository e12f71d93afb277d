// SPDX-License-Identifier: MIT
#include "modules/crowd/src/steering.h"

#include <algorithm>

namespace jostle::modules::crowd_detail {

using namespace physics;

namespace {

constexpr double stopping_time = 0.5;  // s: agents slow down within this time of their destination
constexpr std::size_t panic_sources_max = 6;  // nearest neighbours from which panic spreads

Vec2 flat(Vec3 v) {
    return {v.x, v.y};
}

// Velocity to a point at an offset, at most `speed`.
Vec3 approach(Vec3 offset, double speed) {
    const double far = length(offset);
    return far > 1e-9 ? offset * (minimum(speed, far / stopping_time) / far) : Vec3{};
}

Vec2 nearest_point(const GoalArea& area, Vec2 p) {
    const Vec2 low = area.center - area.half_extents, high = area.center + area.half_extents;
    return {clamp(p.x, low.x, high.x), clamp(p.y, low.y, high.y)};
}

// The area with the nearest point.
const GoalArea& nearest_area(const GoalDef& goal, Vec2 p) {
    const GoalArea* nearest = &goal.areas.front();
    for (const GoalArea& area : goal.areas)
        if (length_squared(nearest_point(area, p) - p) <
            length_squared(nearest_point(*nearest, p) - p))
            nearest = &area;
    return *nearest;
}

Vec3 route_velocity(const CrowdStore& store, std::uint32_t index, Vec2 p, double speed) {
    const auto& routes = store.scratch.routes;
    if (index < routes.size())
        if (const auto direction = routes[index].direction(p))
            return Vec3{direction->x, direction->y, 0} * speed;
    const Vec2 offset = nearest_point(nearest_area(store.goals[index], p), p) - p;
    const double far = length(offset);
    return far > 0 ? Vec3{offset.x, offset.y, 0} * (speed / far) : Vec3{};
}

Wish goal_wish(CrowdStore& store, std::size_t agent, double speed) {
    AgentRecord& record = store.agents.record[agent];
    const Vec2 p = flat(store.scratch.points[agent]);
    const GoalDef& goal = store.goals[record.destination.goal];
    const GoalArea& area = nearest_area(goal, p);
    if (!is_inside(area, p)) return {route_velocity(store, record.destination.goal, p, speed)};
    if (goal.end == GoalEnd::leave) return {.velocity = {}, .arrived = true, .leaves = true};
    if (goal.end == GoalEnd::next && goal.next < store.goals.size()) {
        record.destination.goal = goal.next;
        return {route_velocity(store, goal.next, p, speed)};
    }
    // On to the middle, to leave room for those behind.
    const Vec2 offset = area.center - p;
    return {approach({offset.x, offset.y, 0}, speed), true};
}

Wish follow_wish(const World& world, const CrowdStore& store, const Destination& destination,
                 Vec3 p, double speed, bool walks) {
    const Result<BodyState> leader = world.body(destination.body);
    if (!leader.ok()) return {};
    Vec3 offset = store.to_plane(leader->center) - p;
    if (walks) offset.z = 0;
    const double far = length(offset), left = far - destination.distance;
    const bool arrived = left < 0.5;
    if (!(far > 1e-9) || left <= 0) return {{}, arrived};
    const Vec3 velocity =
        store.to_plane(leader->linear_velocity) + approach(offset * (left / far), speed);
    const double size = length(velocity);
    return {size > speed ? velocity * (speed / size) : velocity, arrived};
}

}  // namespace

Wish wish_of(const World& world, CrowdStore& store, std::size_t agent) {
    const AgentRecord& record = store.agents.record[agent];
    const CrowdSettings& settings = store.settings;
    const double panic = store.agents.panic[agent];
    const bool panicked = panic > 0 && settings.panic_time > 0;
    const double speed = panicked ? maximum(settings.panic_speed, record.speed) : record.speed;
    const Vec3 p = store.scratch.points[agent];
    Wish wish;
    switch (record.destination.aim) {
        case Aim::stand:
            break;
        case Aim::move:
            wish.velocity = store.to_plane(record.destination.velocity);
            break;
        case Aim::point: {
            Vec3 offset = store.to_plane(record.destination.point) - p;
            if (record.kind == AgentKind::walker) offset.z = 0;
            wish = {approach(offset, speed), length(offset) < store.agents.radius[agent]};
            break;
        }
        case Aim::goal:
            wish = goal_wish(store, agent, speed);
            break;
        case Aim::follow:
            wish = follow_wish(world, store, record.destination, p, speed,
                               record.kind == AgentKind::walker);
            break;
    }
    if (!panicked || store.agents.flight[agent] == Vec3{}) return wish;
    // Away from the cause at first, then more and more to the destination.
    const double share = minimum(panic / settings.panic_time, 1);
    const Vec3 away = store.to_plane(store.agents.flight[agent]);
    wish.velocity = away * (share * speed) + wish.velocity * (1 - share);
    return wish;
}

void spread_panic(CrowdStore& store, std::size_t agent, std::span<const NearPoint> neighbors,
                  double dt) {
    const AgentArrays& agents = store.agents;
    const auto is_this = [&](const Threat& t) { return t.body == agents.record[agent].body; };
    if (std::ranges::any_of(store.threats, is_this)) {  // what frightens others is not afraid
        store.scratch.next_panic[agent] = 0;
        store.scratch.next_flight[agent] = {};
        return;
    }
    double panic = maximum(agents.panic[agent] - dt, 0);
    Vec3 flight = panic > 0 ? agents.flight[agent] : Vec3{};
    std::size_t left = panic_sources_max;
    for (const NearPoint& near : neighbors) {
        if (left-- == 0) break;
        const double caught = agents.panic[near.index] * store.settings.contagion;
        // Less than a step of panic has no effect and would spread without end.
        if (caught <= panic || caught < 10 * dt) continue;
        panic = caught;
        flight = agents.flight[near.index];
    }
    store.scratch.next_panic[agent] = panic;
    store.scratch.next_flight[agent] = flight;
}

Vec3 accelerated(const CrowdStore& store, std::size_t agent, Vec3 target, double dt) {
    const Vec3 velocity = store.scratch.velocities[agent], change = target - velocity;
    const double most = store.agents.record[agent].acceleration * dt, size = length(change);
    return size > most ? velocity + change * (most / size) : target;
}

// ---- flyers ----

void plan_flyer(CrowdStore& store, std::size_t agent, double dt) {
    const AgentArrays& agents = store.agents;
    const CrowdScratch& scratch = store.scratch;
    const AgentRecord& record = agents.record[agent];
    const FlockDef& flock = store.flocks[record.flock];
    const Vec3 p = scratch.points[agent], v = scratch.velocities[agent];
    const Vec3 wish = scratch.wishes[agent];
    Vec3 apart, velocity_sum, offset_sum;
    int mates = 0;
    for (const NearPoint& near : scratch.flyers.of(agent)) {
        const Vec3 offset = scratch.points[near.index] - p;
        const double distance = length(offset);
        if (distance > flock.reach) continue;
        if (distance < flock.separation && distance > 1e-9)
            apart -= offset * ((1 - distance / flock.separation) / distance);
        if (agents.record[near.index].flock != record.flock) continue;
        velocity_sum += scratch.velocities[near.index];
        offset_sum += offset;
        mates++;
    }
    Vec3 force = apart * flock.separation_weight;  // m/s^2
    if (mates > 0) {
        force += (velocity_sum * (1.0 / mates) - v) * flock.alignment_weight;
        force += offset_sum * (flock.cohesion_weight / mates);
    }
    // Without a destination it keeps its speed.
    const bool free = record.destination.aim == Aim::stand && wish == Vec3{};
    const double speed = length(v);
    if (!free)
        force += (wish - v) * flock.aim_weight;
    else if (speed > 1e-9)
        force += v * (flock.aim_weight * (record.speed - speed) / speed);
    if (flock.roam > 0) {
        const Vec3 back = store.to_plane(flock.home) - p;
        const double far = length(back);
        if (far > flock.roam) force += (back * (record.speed / far) - v) * flock.aim_weight;
    }
    const double size = length(force);
    if (size > record.acceleration) force = force * (record.acceleration / size);
    Vec3 next = v + force * dt;
    const double limit = agents.panic[agent] > 0
                             ? maximum(store.settings.panic_speed, record.max_speed)
                             : record.max_speed;
    const double fast = length(next);
    if (fast > limit) next = next * (limit / fast);
    store.scratch.planned[agent] = next;
}

}  // namespace jostle::modules::crowd_detail
