// SPDX-License-Identifier: MIT
#include "host/hosted_world.h"

#include <algorithm>
#include <string>
#include <utility>

namespace jostle::server {

using namespace physics;

namespace {

constexpr double impulse_speed_max = 20;  // m/s that one impulse may give a body

Error refused(ErrorCode code, std::string message) {
    return {code, std::move(message)};
}

Error no_such_entity(EntityId id) {
    return refused(ErrorCode::not_found, "there is no entity " + std::to_string(id));
}

// What the solver says no to is an input with wrong numbers.
Status from_solver(const Status& status) {
    return status.ok() ? status : refused(ErrorCode::invalid_argument, status.error().message);
}

}  // namespace

Result<HostedWorld> HostedWorld::create(const scenes::SceneDescription& scene,
                                        const HostLimits& limits, int threads) {
    if (static_cast<int>(scene.bodies.size()) > limits.bodies_max)
        return Error{ErrorCode::invalid_argument,
                     "the scene has " + std::to_string(scene.bodies.size()) +
                         " bodies; this server allows " + std::to_string(limits.bodies_max)};
    Result<scenes::BuiltScene> built = scenes::build_scene(scene);
    if (!built.ok()) return built.error();
    if (Status s = built->world.set_threads(threads); !s.ok()) return s.error();
    HostedWorld hosted(std::move(built->world), limits);
    for (std::size_t i = 0; i < built->bodies.size(); i++)
        hosted.entities_.add(hosted.world_, built->bodies[i], 0, scene.bodies[i].color,
                             scene.bodies[i].name);
    return hosted;
}

void HostedWorld::remove(EntityId id) {
    const BodyId body = entities_.find(id)->body;
    grabs_.release_body(body);
    ownership_.remove(id);
    entities_.remove(id);
    // The registry and the world agree, so the body is there.
    static_cast<void>(world_.destroy_body(body).ok());
}

Result<const Entity*> HostedWorld::dynamic_entity(EntityId id) const {
    const Entity* entity = entities_.find(id);
    if (!entity) return no_such_entity(id);
    if (entity->description->type != BodyType::dynamic)
        return refused(ErrorCode::permission_denied,
                       "entity " + std::to_string(id) + " is not dynamic; it cannot be moved");
    return entity;
}

Status HostedWorld::accept_sequence(ClientId client, std::uint32_t sequence) {
    std::uint32_t& last = last_sequences_[client];
    if (sequence <= last)
        return refused(ErrorCode::invalid_argument, "input " + std::to_string(sequence) +
                                                        " does not come after input " +
                                                        std::to_string(last));
    last = sequence;
    return {};
}

InputResult HostedWorld::apply(const Command& command, std::uint32_t tick) {
    InputResult result{.sequence = command.sequence, .tick = tick};
    if (!std::holds_alternative<LeaveCommand>(command.action))
        result.status = accept_sequence(command.client, command.sequence);
    if (result.status.ok())
        result.status = std::visit(
            [&](const auto& action) { return apply_action(action, command.client, result.entity); },
            command.action);
    return result;
}

Status HostedWorld::apply_action(const SpawnCommand& c, ClientId client, EntityId& about) {
    if (static_cast<int>(entities_.size()) >= limits_.bodies_max)
        return refused(
            ErrorCode::resource_exhausted,
            "the world is full: it holds " + std::to_string(limits_.bodies_max) + " bodies");
    if (ownership_.count(client) >= limits_.bodies_owned_max)
        return refused(ErrorCode::resource_exhausted,
                       "you own " + std::to_string(limits_.bodies_owned_max) +
                           " bodies, the most allowed; delete some first");
    const Result<BodyId> body = world_.create_body(BodyDef{.pose = c.pose,
                                                           .linear_velocity = c.linear_velocity,
                                                           .angular_velocity = c.angular_velocity},
                                                   c.shape);
    if (!body.ok()) return from_solver(body.error());
    about = entities_.add(world_, *body, client, c.color, {});
    ownership_.add(client, about);
    return {};
}

Status HostedWorld::apply_action(const ImpulseCommand& c, ClientId, EntityId& about) {
    about = c.entity;
    const Result<const Entity*> entity = dynamic_entity(c.entity);
    if (!entity.ok()) return entity.error();
    const BodyState body = *world_.body((*entity)->body);
    const double most = body.mass * impulse_speed_max, size = length(c.impulse);
    const Vec3 impulse = size > most ? c.impulse * (most / size) : c.impulse;
    Vec3 point = c.point.value_or(body.center);
    // A point far outside the body would be a lever of any length.
    const Vec3 arm = point - body.center;
    const double reach = 2;
    if (length(arm) > reach) point = body.center + arm * (reach / length(arm));
    return from_solver(world_.apply_impulse((*entity)->body, impulse, point));
}

Status HostedWorld::apply_action(const GrabCommand& c, ClientId client, EntityId& about) {
    about = c.entity;
    const Result<const Entity*> entity = dynamic_entity(c.entity);
    if (!entity.ok()) return entity.error();
    grabs_.grab(client, *world_.body((*entity)->body), c.point);
    return {};
}

Status HostedWorld::apply_action(const DragCommand& c, ClientId client, EntityId& about) {
    const std::optional<BodyId> body = grabs_.drag(client, c.target);
    if (!body) return refused(ErrorCode::not_found, "you hold nothing; grab an entity first");
    about = entities_.entity_of(*body);
    return {};
}

Status HostedWorld::apply_action(const ReleaseCommand&, ClientId client, EntityId&) {
    grabs_.release(client);
    return {};
}

Status HostedWorld::apply_action(const DeleteCommand& c, ClientId client, EntityId& about) {
    about = c.entity;
    if (!entities_.find(c.entity)) return no_such_entity(c.entity);
    if (!ownership_.owns(client, c.entity))
        return refused(ErrorCode::permission_denied,
                       "entity " + std::to_string(c.entity) + " is not yours");
    remove(c.entity);
    return {};
}

Status HostedWorld::apply_action(const ExplodeCommand& c, ClientId, EntityId&) {
    Status status;
    for (const auto& [id, entity] : entities_.all()) {
        if (entity.description->type != BodyType::dynamic) continue;
        const BodyState body = *world_.body(entity.body);
        const Vec3 away = body.center - c.center;
        const double distance = length(away);
        if (distance >= c.radius) continue;
        const double speed = c.speed * (1 - distance / c.radius);
        const Vec3 impulse = normalized(away) * (speed * body.mass);
        if (Status pushed = world_.apply_impulse(entity.body, impulse, body.center); !pushed.ok())
            status = from_solver(pushed);
    }
    return status;
}

Status HostedWorld::apply_action(const LeaveCommand& c, ClientId client, EntityId&) {
    if (!c.keep_bodies)
        for (const EntityId id : ownership_.owned_by(client)) remove(id);
    ownership_.forget(client);
    grabs_.release(client);
    last_sequences_.erase(client);
    return {};
}

Status HostedWorld::step(double dt) {
    grabs_.pull_all(world_, dt);
    Status stepped = world_.step(dt);
    if (stepped.ok()) entities_.on_step();
    return stepped;
}

std::optional<TickEvents> HostedWorld::events_of_step(std::uint32_t tick) const {
    return copy_events(world_.events(), tick,
                       [this](BodyId body) { return entities_.entity_of(body); });
}

std::vector<std::shared_ptr<const EntityDescription>> HostedWorld::newly_quarantined() {
    std::vector<std::shared_ptr<const EntityDescription>> fresh;
    for (const BodyId body : world_.events().quarantined) {
        const EntityId id = entities_.entity_of(body);
        if (quarantined_.insert(id).second) fresh.push_back(entities_.find(id)->description);
    }
    return fresh;
}

QueryFramePtr HostedWorld::query_frame(std::uint32_t tick, CopyParts parts) {
    auto frame = std::make_shared<QueryFrame>();
    frame->tick = tick;
    frame->parts = parts;
    frame->entity_list = entities_.list();
    frame->places = entities_.places();
    copy_parts(*frame, world_, entities_.by_body());
    return frame;
}

void HostedWorld::copy_into(Frame& frame) {
    frame.entity_list = entities_.list();
    world_.copy_bodies(bodies_);
    frame.entities.clear();
    frame.entities.reserve(bodies_.size());
    frame.awake = 0;
    for (const BodyState& body : bodies_) {
        frame.awake += body.awake && body.type == BodyType::dynamic ? 1 : 0;
        frame.entities.push_back({entities_.by_body()[body.id.index], body.pose, body.awake});
    }
    // Bodies come by index; an index that was used again holds a later entity.
    std::sort(frame.entities.begin(), frame.entities.end(),
              [](const EntityPose& a, const EntityPose& b) { return a.id < b.id; });
    frame.contacts = world_.profile().touching;
    frame.step_ms = world_.profile().step_ms;
}

}  // namespace jostle::server
