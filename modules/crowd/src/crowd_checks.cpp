// SPDX-License-Identifier: MIT
#include "modules/crowd/src/crowd_checks.h"

#include <cstdio>
#include <string>

namespace jostle::modules::crowd_detail {

using namespace physics;

namespace {

constexpr std::size_t areas_max = 16;

std::string text(double number) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.10g", number);
    return digits;
}

// Collects the first value that is out of range.
class RangeCheck {
public:
    void number(const char* name, double value, double low, double high) {
        if (value >= low && value <= high) return;
        fail(std::string(name) + " is " + text(value) + "; it must be from " + text(low) + " to " +
             text(high));
    }
    void vector(const char* name, Vec2 value, double low, double high) {
        number((std::string(name) + ".x").c_str(), value.x, low, high);
        number((std::string(name) + ".y").c_str(), value.y, low, high);
    }
    void vector(const char* name, Vec3 value, double limit) {
        number((std::string(name) + ".x").c_str(), value.x, -limit, limit);
        number((std::string(name) + ".y").c_str(), value.y, -limit, limit);
        number((std::string(name) + ".z").c_str(), value.z, -limit, limit);
    }
    void fail(const std::string& message) {
        if (message_.empty()) message_ = message;
    }
    Status status() const {
        if (message_.empty()) return {};
        return Error{ErrorCode::invalid_argument, message_};
    }

private:
    std::string message_;
};

}  // namespace

Status check(const CrowdSettings& settings) {
    RangeCheck range;
    range.number("neighbors", settings.neighbors, 1, neighbors_max);
    range.number("reach", settings.reach, 0.2, 50);
    range.number("horizon", settings.horizon, 0.05, 20);
    range.number("wall_horizon", settings.wall_horizon, 0.05, 20);
    range.number("side_preference", settings.side_preference, -0.5, 0.5);
    range.number("noise", settings.noise, 0, 0.5);
    range.number("panic_time", settings.panic_time, 0, 1000);
    range.number("panic_speed", settings.panic_speed, 0, 50);
    range.number("contagion", settings.contagion, 0, 0.99);
    range.number("blow_speed", settings.blow_speed, 0.1, 1e3);
    return range.status();
}

Status check(const AgentDef& def) {
    RangeCheck range;
    range.vector("position", def.position, coordinate_max);
    range.number("radius", def.radius, 0.05, 5);
    range.number("speed", def.speed, 0, 50);
    range.number("max_speed", def.max_speed, def.speed, 100);
    range.number("acceleration", def.acceleration, 0.1, 1e4);
    if (def.kind > AgentKind::flyer) range.fail("kind is not one of its values");
    return range.status();
}

Status check(const FlockDef& flock) {
    RangeCheck range;
    range.number("reach", flock.reach, 0.1, 100);
    range.number("separation", flock.separation, 0, 100);
    range.number("separation_weight", flock.separation_weight, 0, 1e3);
    range.number("alignment_weight", flock.alignment_weight, 0, 100);
    range.number("cohesion_weight", flock.cohesion_weight, 0, 100);
    range.number("aim_weight", flock.aim_weight, 0, 100);
    range.number("roam", flock.roam, 0, 1e5);
    range.vector("home", flock.home, coordinate_max);
    return range.status();
}

Status check(const RouteGrid& grid) {
    RangeCheck range;
    range.vector("center", grid.center, -coordinate_max, coordinate_max);
    range.vector("half_extents", grid.half_extents, 0, 1e4);
    range.number("cell", grid.cell, 0.05, 100);
    range.number("clearance", grid.clearance, 0, 10);
    if (Status s = range.status(); !s.ok()) return s;
    const GridSize size = size_of(grid);
    const std::uint64_t cells = std::uint64_t{size.columns} * size.rows;
    if (cells > cells_max)
        range.fail("cell is " + text(grid.cell) + ", so the grid has " + std::to_string(cells) +
                   " cells; it must have at most " + std::to_string(cells_max));
    return range.status();
}

Status check(const Wall& wall) {
    RangeCheck range;
    range.vector("from", wall.from, -coordinate_max, coordinate_max);
    range.vector("to", wall.to, -coordinate_max, coordinate_max);
    return range.status();
}

Status check(const GoalDef& goal) {
    RangeCheck range;
    if (goal.areas.empty() || goal.areas.size() > areas_max)
        range.fail("areas has " + std::to_string(goal.areas.size()) +
                   " elements; it must have 1 to " + std::to_string(areas_max));
    for (const GoalArea& area : goal.areas) {
        range.vector("center", area.center, -coordinate_max, coordinate_max);
        range.vector("half_extents", area.half_extents, 0.01, 1e4);
    }
    if (goal.end > GoalEnd::next) range.fail("end is not one of its values");
    range.number("next", goal.next, 0, Crowd::goals_max - 1);
    return range.status();
}

Status check(const Destination& destination, AgentKind kind, std::size_t goals) {
    RangeCheck range;
    range.vector("velocity", destination.velocity, 100);
    range.vector("point", destination.point, coordinate_max);
    range.number("distance", destination.distance, 0, 1000);
    if (destination.aim > Aim::follow) range.fail("aim is not one of its values");
    if (destination.aim == Aim::goal && kind == AgentKind::flyer)
        range.fail("aim is a goal; only walkers have goals");
    if (destination.aim == Aim::goal && destination.goal >= goals)
        range.fail("goal is " + std::to_string(destination.goal) + "; there are " +
                   std::to_string(goals) + " goals");
    return range.status();
}

}  // namespace jostle::modules::crowd_detail
