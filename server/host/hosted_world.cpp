// SPDX-License-Identifier: MIT
#include "host/hosted_world.h"

#include <algorithm>
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
        hosted.add(built->bodies[i], 0, scene.bodies[i].color, scene.bodies[i].name);
    return hosted;
}

EntityId HostedWorld::add(BodyId body, ClientId owner, std::optional<std::uint32_t> color,
                          std::string name) {
    const BodyState state = *world_.body(body);
    auto description = std::make_shared<EntityDescription>();
    description->id = next_id_++;
    description->type = state.type;
    for (const ShapeId shape : world_.shapes_of(body))
        description->shapes.push_back(*world_.shape(shape));
    description->owner = owner;
    description->color = color;
    description->name = std::move(name);
    description->mass = state.mass;
    const EntityId id = description->id;
    entities_.emplace(id, Entity{id, body, owner, std::move(description)});
    if (entity_of_body_.size() <= body.index) entity_of_body_.resize(body.index + 1, 0);
    entity_of_body_[body.index] = id;
    entity_list_ = nullptr;
    places_ = nullptr;
    return id;
}

void HostedWorld::remove(EntityId id) {
    const auto at = entities_.find(id);
    if (at == entities_.end()) return;
    const Entity entity = at->second;
    for (auto& [client, state] : clients_)
        if (state.hand && state.hand->body == entity.body) state.hand.reset();
    if (entity.owner != 0) clients_[entity.owner].bodies--;
    entity_of_body_[entity.body.index] = 0;
    removed_.emplace(entity.body, id);
    entities_.erase(at);
    entity_list_ = nullptr;
    places_ = nullptr;
    // The registry and the world agree, so the body is there.
    static_cast<void>(world_.destroy_body(entity.body).ok());
}

Result<const HostedWorld::Entity*> HostedWorld::dynamic_entity(EntityId id) const {
    const auto at = entities_.find(id);
    if (at == entities_.end()) return no_such_entity(id);
    if (at->second.description->type != BodyType::dynamic)
        return refused(ErrorCode::permission_denied,
                       "entity " + std::to_string(id) + " is not dynamic; it cannot be moved");
    return &at->second;
}

InputResult HostedWorld::apply(const Command& command, std::uint32_t tick) {
    InputResult result{.sequence = command.sequence, .tick = tick};
    if (!std::holds_alternative<LeaveCommand>(command.action)) {
        Client& client = clients_[command.client];
        if (command.sequence <= client.last_sequence) {
            result.status =
                refused(ErrorCode::invalid_argument, "input " + std::to_string(command.sequence) +
                                                         " does not come after input " +
                                                         std::to_string(client.last_sequence));
            return result;
        }
        client.last_sequence = command.sequence;
    }
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
    if (clients_[client].bodies >= limits_.bodies_owned_max)
        return refused(ErrorCode::resource_exhausted,
                       "you own " + std::to_string(limits_.bodies_owned_max) +
                           " bodies, the most allowed; delete some first");
    const Result<BodyId> body = world_.create_body(BodyDef{.pose = c.pose,
                                                           .linear_velocity = c.linear_velocity,
                                                           .angular_velocity = c.angular_velocity},
                                                   c.shape);
    if (!body.ok()) return from_solver(body.error());
    clients_[client].bodies++;
    about = add(*body, client, c.color, {});
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
    const BodyState body = *world_.body((*entity)->body);
    clients_[client].hand = DragSpring{(*entity)->body, apply_inverse(body.pose, c.point), c.point};
    return {};
}

Status HostedWorld::apply_action(const DragCommand& c, ClientId client, EntityId& about) {
    std::optional<DragSpring>& hand = clients_[client].hand;
    if (!hand) return refused(ErrorCode::not_found, "you hold nothing; grab an entity first");
    hand->target = c.target;
    about = entity_of_body_[hand->body.index];
    return {};
}

Status HostedWorld::apply_action(const ReleaseCommand&, ClientId client, EntityId&) {
    clients_[client].hand.reset();
    return {};
}

Status HostedWorld::apply_action(const DeleteCommand& c, ClientId client, EntityId& about) {
    about = c.entity;
    const auto at = entities_.find(c.entity);
    if (at == entities_.end()) return no_such_entity(c.entity);
    if (at->second.owner != client)
        return refused(ErrorCode::permission_denied,
                       "entity " + std::to_string(c.entity) + " is not yours");
    remove(c.entity);
    return {};
}

Status HostedWorld::apply_action(const ExplodeCommand& c, ClientId, EntityId&) {
    Status status;
    for (const auto& [id, entity] : entities_) {
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
    if (!c.keep_bodies) {
        std::vector<EntityId> owned;
        for (const auto& [id, entity] : entities_)
            if (entity.owner == client) owned.push_back(id);
        for (const EntityId id : owned) remove(id);
    }
    clients_.erase(client);
    return {};
}

Status HostedWorld::step(double dt) {
    for (auto& [id, client] : clients_)
        if (client.hand && !pull(world_, *client.hand, dt).ok()) client.hand.reset();
    Status stepped = world_.step(dt);
    if (stepped.ok()) removed_before_step_ = std::exchange(removed_, {});
    return stepped;
}

EntityId HostedWorld::entity_of(BodyId body) const {
    const auto at = removed_before_step_.find(body);
    return at != removed_before_step_.end() ? at->second : entity_of_body_[body.index];
}

std::optional<TickEvents> HostedWorld::events_of_step(std::uint32_t tick) const {
    return copy_events(world_.events(), tick, [this](BodyId body) { return entity_of(body); });
}

std::vector<std::shared_ptr<const EntityDescription>> HostedWorld::newly_quarantined() {
    std::vector<std::shared_ptr<const EntityDescription>> fresh;
    for (const BodyId body : world_.events().quarantined) {
        const EntityId id = entity_of(body);
        if (quarantined_.insert(id).second) fresh.push_back(entities_.at(id).description);
    }
    return fresh;
}

const std::shared_ptr<const EntityList>& HostedWorld::entity_list() {
    if (!entity_list_) {
        auto entity_list = std::make_shared<EntityList>();
        entity_list->reserve(entities_.size());
        for (const auto& [id, entity] : entities_) entity_list->push_back(entity.description);
        entity_list_ = std::move(entity_list);
    }
    return entity_list_;
}

QueryFramePtr HostedWorld::query_frame(std::uint32_t tick, CopyParts parts) {
    auto frame = std::make_shared<QueryFrame>();
    frame->tick = tick;
    frame->parts = parts;
    frame->entity_list = entity_list();
    if (!places_) places_ = std::make_shared<const ShapePlaces>(places_in(*entity_list_));
    frame->places = places_;
    copy_parts(*frame, world_, entity_of_body_);
    return frame;
}

void HostedWorld::copy_into(Frame& frame) {
    frame.entity_list = entity_list();
    world_.copy_bodies(bodies_);
    frame.entities.clear();
    frame.entities.reserve(bodies_.size());
    frame.awake = 0;
    for (const BodyState& body : bodies_) {
        frame.awake += body.awake && body.type == BodyType::dynamic ? 1 : 0;
        frame.entities.push_back({entity_of_body_[body.id.index], body.pose, body.awake});
    }
    // Bodies come by index; an index that was used again holds a later entity.
    std::sort(frame.entities.begin(), frame.entities.end(),
              [](const EntityPose& a, const EntityPose& b) { return a.id < b.id; });
    frame.contacts = world_.profile().touching;
    frame.step_ms = world_.profile().step_ms;
}

}  // namespace jostle::server
