// SPDX-License-Identifier: MIT
//
// Fields of a crowd, for saving, loading, hashing and restore points.
#include <string>

#include "jostle/modules/settings.h"
#include "jostle/physics/limits.h"
#include "modules/crowd/src/crowd_checks.h"

namespace jostle::modules {

using namespace physics;

namespace crowd_detail {
namespace {

// Reports an invalid loaded object.
void verify(StateVisitor& v, std::string_view name, const Status& status) {
    if (v.loading() && !status.ok()) v.fail(name, status.error().message);
}

void visit(StateVisitor& v, std::string_view name, Vec2& value) {
    v.enter(name);
    v.field("x", value.x);
    v.field("y", value.y);
    v.leave();
}

void visit_settings(StateVisitor& v, CrowdSettings& settings) {
    v.field("seed", settings.seed);
    v.field("vertical", settings.vertical);
    v.field("neighbors", settings.neighbors);
    v.field("reach", settings.reach);
    v.field("horizon", settings.horizon);
    v.field("wall_horizon", settings.wall_horizon);
    v.field("side_preference", settings.side_preference);
    v.field("noise", settings.noise);
    v.field("panic_time", settings.panic_time);
    v.field("panic_speed", settings.panic_speed);
    v.field("contagion", settings.contagion);
    v.field("blow_speed", settings.blow_speed);
    verify(v, "settings", check(settings));
}

void visit_goals(StateVisitor& v, std::vector<GoalDef>& goals) {
    v.all("goals", goals, [&](GoalDef& goal) {
        v.all("areas", goal.areas, [&](GoalArea& area) {
            visit(v, "center", area.center);
            visit(v, "half_extents", area.half_extents);
        });
        v.field("end", goal.end, GoalEnd::next);
        v.field("next", goal.next);
        verify(v, "areas", check(goal));
    });
    if (v.loading() && goals.size() > Crowd::goals_max) v.fail("goals", "are more than 16");
}

void visit_flocks(StateVisitor& v, std::vector<FlockDef>& flocks) {
    v.all("flocks", flocks, [&](FlockDef& flock) {
        v.field("reach", flock.reach);
        v.field("separation", flock.separation);
        v.field("separation_weight", flock.separation_weight);
        v.field("alignment_weight", flock.alignment_weight);
        v.field("cohesion_weight", flock.cohesion_weight);
        v.field("aim_weight", flock.aim_weight);
        v.field("roam", flock.roam);
        v.field("home", flock.home);
        verify(v, "reach", check(flock));
    });
    if (v.loading() && flocks.size() > Crowd::flocks_max) v.fail("flocks", "are more than 64");
}

void visit_surroundings(StateVisitor& v, CrowdStore& store) {
    visit_goals(v, store.goals);
    visit_flocks(v, store.flocks);
    v.all("walls", store.walls, [&](Wall& wall) {
        visit(v, "from", wall.from);
        visit(v, "to", wall.to);
        verify(v, "from", check(wall));
    });
    if (v.loading() && store.walls.size() > Crowd::walls_max) v.fail("walls", "are more than 4096");
    visit(v, "grid_center", store.grid.center);
    visit(v, "grid_half_extents", store.grid.half_extents);
    v.field("grid_cell", store.grid.cell);
    v.field("grid_clearance", store.grid.clearance);
    verify(v, "grid_cell", check(store.grid));
    v.all("threats", store.threats, [&](Threat& threat) {
        v.field("body", threat.body);
        bounded(v, "radius", threat.radius, 0.1, 1000);
    });
    if (v.loading() && store.threats.size() > Crowd::threats_max)
        v.fail("threats", "are more than 16");
}

void visit_destination(StateVisitor& v, Destination& destination) {
    v.field("aim", destination.aim, Aim::follow);
    v.field("velocity", destination.velocity);
    v.field("point", destination.point);
    v.field("goal", destination.goal);
    v.field("target", destination.body);
    v.field("distance", destination.distance);
}

void visit_record(StateVisitor& v, const CrowdStore& store, AgentRecord& record) {
    v.field("generation", record.generation);
    v.field("alive", record.alive);
    v.field("carrier", record.carrier, Carrier::character);
    v.field("kind", record.kind, AgentKind::flyer);
    v.field("body", record.body);
    v.field("character", record.character.index);
    v.field("character_generation", record.character.generation);
    v.field("speed", record.speed);
    v.field("max_speed", record.max_speed);
    v.field("acceleration", record.acceleration);
    v.field("slows_in_crowds", record.slows_in_crowds);
    v.field("flock", record.flock);
    visit_destination(v, record.destination);
    v.field("arrived", record.arrived);
    if (!v.loading()) return;
    verify(v, "speed",
           check(AgentDef{.speed = record.speed,
                          .max_speed = record.max_speed,
                          .acceleration = record.acceleration}));
    verify(v, "aim", check(record.destination, record.kind, store.goals.size()));
    if (record.kind == AgentKind::flyer && record.flock >= store.flocks.size())
        v.fail("flock", "does not exist");
    if (is_null(record.body) != (record.carrier == Carrier::none))
        v.fail("carrier", "does not fit the body");
}

// One component of all agents.
template <class Each>
void visit_column(StateVisitor& v, std::string_view name, std::size_t size, const Each& each) {
    v.enter(name);
    for (std::size_t k = 0; k < size; k++) {
        v.enter(k);
        each(k);
        v.leave();
        if (v.failed()) break;
    }
    v.leave();
}

void visit_agents(StateVisitor& v, CrowdStore& store) {
    AgentArrays& agents = store.agents;
    v.all("agents", agents.record, [&](AgentRecord& record) { visit_record(v, store, record); });
    if (v.loading() && agents.size() > Crowd::agents_max) v.fail("agents", "are more than 16384");
    if (v.failed()) return;
    if (v.loading()) agents.resize(agents.size());
    constexpr double speed_max = 2 * limits::max_speed;
    const std::size_t size = agents.size();
    visit_column(v, "positions", size, [&](std::size_t k) {
        bounded(v, "position", agents.position[k], 2 * limits::max_coordinate);
    });
    visit_column(v, "velocities", size, [&](std::size_t k) {
        v.field("velocity", agents.velocity[k]);
        if (v.loading() && !(length(agents.velocity[k]) <= speed_max))
            v.fail("velocity", "is out of range");
    });
    visit_column(v, "radii", size,
                 [&](std::size_t k) { bounded(v, "radius", agents.radius[k], 0.05, 5); });
    visit_column(v, "panic", size,
                 [&](std::size_t k) { bounded(v, "left", agents.panic[k], 0, 1000); });
    visit_column(v, "flight", size,
                 [&](std::size_t k) { bounded(v, "direction", agents.flight[k], 1.001); });
    visit_column(v, "pace", size,
                 [&](std::size_t k) { bounded(v, "speed", agents.pace[k], 0, 100); });
}

}  // namespace
}  // namespace crowd_detail

void Crowd::visit(StateVisitor& v) {
    crowd_detail::visit_settings(v, store_->settings);
    crowd_detail::visit_surroundings(v, *store_);
    v.field("steps", store_->steps);
    v.field("left", store_->left);
    if (v.failed()) return;
    crowd_detail::visit_agents(v, *store_);
}

void Crowd::restored(const World&) {
    store_->scratch.routes_stale = true;
    store_->scratch.walkers.clear();
    store_->scratch.flyers.clear();
    store_->scratch.planned_overlap = 0;
}

}  // namespace jostle::modules
