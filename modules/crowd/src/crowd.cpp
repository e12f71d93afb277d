// SPDX-License-Identifier: MIT
#include "jostle/modules/crowd.h"

#include <algorithm>
#include <string>

#include "modules/crowd/src/crowd_checks.h"
#include "modules/crowd/src/crowd_step.h"
#include "modules/crowd/src/outline.h"

namespace jostle::modules {

using namespace physics;
using crowd_detail::AgentRecord;
using crowd_detail::Carrier;
using crowd_detail::check;
using crowd_detail::CrowdStore;

namespace {

// Rotation about the axes in the plane of the ground; walkers stay upright.
constexpr AxisLocks upright = lock_rotation_x | lock_rotation_y | lock_rotation_z;

Error unknown(AgentId id) {
    return {ErrorCode::not_found, "agent {" + std::to_string(id.index) + ", " +
                                      std::to_string(id.generation) +
                                      "} does not exist or has left"};
}

Error too_many(const char* what, std::size_t most) {
    return {ErrorCode::resource_exhausted,
            "the crowd already has the maximum of " + std::to_string(most) + " " + what};
}

}  // namespace

Crowd::Crowd() : store_(std::make_unique<CrowdStore>()) {}
Crowd::~Crowd() = default;

Status Crowd::set_settings(const CrowdSettings& settings) {
    if (Status s = check(settings); !s.ok()) return s;
    store_->settings = settings;
    return {};
}

const CrowdSettings& Crowd::settings() const {
    return store_->settings;
}

// ---- agents ----

namespace {

// Fills in the body of an agent, its position and its velocity.
Status take_body(World& world, BodyId id, AgentRecord& record, Vec3& position, Vec3& velocity) {
    const Result<BodyState> body = world.body(id);
    if (!body.ok()) return Error{body.error().code, "body: " + body.error().message};
    if (body->type == BodyType::static_body)
        return Error{ErrorCode::invalid_argument,
                     "body is static; it must be kinematic or dynamic"};
    record.body = id;
    record.carrier = body->type == BodyType::dynamic ? Carrier::dynamic : Carrier::kinematic;
    position = body->center;
    velocity = body->linear_velocity;
    if (const auto* characters = dynamic_cast<const Characters*>(world.module("character")))
        record.character = characters->character_of(id);
    if (record.character != CharacterId{}) {
        record.carrier = Carrier::character;
    } else if (record.carrier == Carrier::dynamic && record.kind == AgentKind::walker) {
        return world.set_locks(id, static_cast<AxisLocks>(body->locks | upright));
    }
    return {};
}

}  // namespace

Result<AgentId> Crowd::add(World& world, const AgentDef& def) {
    if (Status s = check(def); !s.ok()) return s.error();
    if (Status s = check(def.destination, def.kind, store_->goals.size()); !s.ok())
        return Error{s.error().code, "destination: " + s.error().message};
    if (def.kind == AgentKind::flyer && def.flock >= store_->flocks.size())
        return Error{ErrorCode::invalid_argument,
                     "flock is " + std::to_string(def.flock) + "; there are " +
                         std::to_string(store_->flocks.size()) + " flocks"};
    auto& agents = store_->agents;
    std::size_t index = 0;
    while (index < agents.size() && agents.record[index].alive) index++;
    if (index == agents_max) return too_many("agents", agents_max);
    AgentRecord record{.kind = def.kind,
                       .speed = def.speed,
                       .max_speed = def.max_speed,
                       .acceleration = def.acceleration,
                       .slows_in_crowds = def.slows_in_crowds,
                       .flock = def.flock,
                       .destination = def.destination};
    Vec3 position = def.position, velocity;
    if (!is_null(def.body) && agent_of(def.body) != AgentId{})
        return Error{ErrorCode::invalid_argument, "body already belongs to an agent"};
    if (!is_null(def.body))
        if (Status s = take_body(world, def.body, record, position, velocity); !s.ok())
            return s.error();
    if (index == agents.size()) agents.resize(index + 1);
    record.generation = agents.record[index].generation + 1;
    record.alive = true;
    agents.record[index] = record;
    agents.position[index] = position;
    agents.velocity[index] = velocity;
    agents.radius[index] = def.radius;
    agents.panic[index] = 0;
    agents.flight[index] = {};
    agents.pace[index] = def.speed;
    store_->scratch.walkers.clear();
    store_->scratch.flyers.clear();
    return AgentId{static_cast<std::uint32_t>(index), record.generation};
}

Status Crowd::remove(World& world, AgentId id) {
    if (!store_->contains(id)) return unknown(id);
    const BodyId body = store_->agents.record[id.index].body;
    forget(*store_, id.index);
    if (world.contains(body)) return world.destroy_body(body);
    return {};
}

bool Crowd::contains(AgentId id) const {
    return store_->contains(id);
}

std::vector<AgentId> Crowd::ids() const {
    std::vector<AgentId> ids;
    for (std::uint32_t k = 0; k < store_->agents.size(); k++)
        if (const AgentRecord& record = store_->agents.record[k]; record.alive)
            ids.push_back({k, record.generation});
    return ids;
}

AgentId Crowd::agent_of(BodyId body) const {
    if (is_null(body)) return {};
    for (std::uint32_t k = 0; k < store_->agents.size(); k++)
        if (const AgentRecord& record = store_->agents.record[k];
            record.alive && record.body == body)
            return {k, record.generation};
    return {};
}

Status Crowd::set_destination(AgentId id, const Destination& destination) {
    if (!store_->contains(id)) return unknown(id);
    AgentRecord& record = store_->agents.record[id.index];
    if (Status s = check(destination, record.kind, store_->goals.size()); !s.ok()) return s;
    record.destination = destination;
    record.arrived = false;
    return {};
}

Result<Destination> Crowd::destination(AgentId id) const {
    if (!store_->contains(id)) return unknown(id);
    return store_->agents.record[id.index].destination;
}

Result<AgentState> Crowd::state(const World& world, AgentId id) const {
    if (!store_->contains(id)) return unknown(id);
    const auto& agents = store_->agents;
    const AgentRecord& record = agents.record[id.index];
    AgentState state{.id = id,
                     .body = record.body,
                     .position = agents.position[id.index],
                     .velocity = agents.velocity[id.index],
                     .panic = agents.panic[id.index],
                     .arrived = record.arrived};
    if (record.carrier == Carrier::none) return state;
    const Result<BodyState> body = world.body(record.body);
    if (!body.ok()) return body.error();
    state.position = body->center;
    return state;
}

// ---- surroundings ----

Result<std::uint32_t> Crowd::add_goal(const GoalDef& goal) {
    if (store_->goals.size() == goals_max) return too_many("goals", goals_max);
    if (Status s = check(goal); !s.ok()) return s.error();
    store_->goals.push_back(goal);
    store_->scratch.routes_stale = true;
    return static_cast<std::uint32_t>(store_->goals.size() - 1);
}

Status Crowd::set_goal(std::uint32_t index, const GoalDef& goal) {
    if (index >= store_->goals.size())
        return Error{ErrorCode::not_found, "goal " + std::to_string(index) + " does not exist"};
    if (Status s = check(goal); !s.ok()) return s;
    store_->goals[index] = goal;
    store_->scratch.routes_stale = true;
    return {};
}

Result<std::uint32_t> Crowd::add_flock(const FlockDef& flock) {
    if (store_->flocks.size() == flocks_max) return too_many("flocks", flocks_max);
    if (Status s = check(flock); !s.ok()) return s.error();
    store_->flocks.push_back(flock);
    return static_cast<std::uint32_t>(store_->flocks.size() - 1);
}

Status Crowd::add_wall(Vec2 from, Vec2 to) {
    if (store_->walls.size() == walls_max) return too_many("walls", walls_max);
    if (Status s = check(crowd_detail::Wall{from, to}); !s.ok()) return s;
    store_->walls.push_back({from, to});
    store_->scratch.routes_stale = true;
    return {};
}

Status Crowd::add_walls_of(const World& world, BodyId body) {
    const Result<std::vector<crowd_detail::Wall>> walls =
        crowd_detail::outline_of(world, body, store_->settings.vertical);
    if (!walls.ok()) return walls.error();
    if (store_->walls.size() + walls->size() > walls_max) return too_many("walls", walls_max);
    for (const crowd_detail::Wall& wall : *walls)
        if (Status s = check(wall); !s.ok()) return s;
    store_->walls.insert(store_->walls.end(), walls->begin(), walls->end());
    store_->scratch.routes_stale = true;
    return {};
}

Status Crowd::set_routes(const RouteGrid& grid) {
    if (Status s = check(grid); !s.ok()) return s;
    store_->grid = grid;
    store_->scratch.routes_stale = true;
    return {};
}

Status Crowd::add_threat(const World& world, const Threat& threat) {
    if (store_->threats.size() == threats_max) return too_many("threats", threats_max);
    if (!(threat.radius >= 0.1 && threat.radius <= 1000))
        return Error{ErrorCode::invalid_argument, "radius is out of range; it must be 0.1 to 1000"};
    if (!world.contains(threat.body))
        return Error{ErrorCode::not_found, "the body of the threat does not exist"};
    store_->threats.push_back(threat);
    return {};
}

Status Crowd::alarm(Vec3 center, double radius) {
    if (!is_finite(center) || !(radius >= 0 && radius <= 1e4))
        return Error{ErrorCode::invalid_argument,
                     "radius is out of range; it must be 0 to 10000, and the centre finite"};
    for (std::size_t k = 0; k < store_->agents.size(); k++) {
        const Vec3 away = store_->agents.position[k] - center;
        if (store_->agents.record[k].alive && dot(away, away) < radius * radius)
            frighten(*store_, k, away);
    }
    return {};
}

// ---- results ----

Crowd::Counts Crowd::counts() const {
    Counts counts{.left = store_->left};
    for (std::size_t k = 0; k < store_->agents.size(); k++) {
        const AgentRecord& record = store_->agents.record[k];
        if (!record.alive) continue;
        counts.agents++;
        counts.arrived += record.arrived;
        counts.panicked += store_->agents.panic[k] > 0;
    }
    return counts;
}

double Crowd::planned_overlap() const {
    return store_->scratch.planned_overlap;
}

std::vector<ChannelKind> Crowd::channels() const {
    return {{}, {.name = "points", .form = ChannelForm::points, .divisor = 6}};
}

void Crowd::publish(const World&, ChannelWriter& channels) const {
    if (channels.begin(0)) {
        const Counts now = counts();
        channels.value(static_cast<std::int32_t>(now.agents));
        channels.value(static_cast<std::int32_t>(now.arrived));
        channels.value(static_cast<std::int32_t>(now.panicked));
        channels.value(static_cast<std::int32_t>(now.left & 0x7fffffff));
    }
    if (!channels.wants_points(1)) return;
    std::vector<Vec3> points;
    std::vector<std::uint32_t> ids;
    double radius = 0;
    for (std::size_t k = 0; k < store_->agents.size(); k++)
        if (const AgentRecord& record = store_->agents.record[k];
            record.alive && record.carrier == Carrier::none) {
            points.push_back(store_->agents.position[k]);
            // Another agent may have had this index before.
            ids.push_back(record.generation << 18 ^ static_cast<std::uint32_t>(k));
            if (points.size() == 1) radius = store_->agents.radius[k];
        }
    if (!points.empty())
        channels.points(1, {.step = 0.01, .radius = radius, .positions = points, .ids = ids});
}

}  // namespace jostle::modules
