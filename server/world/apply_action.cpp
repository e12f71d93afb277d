// SPDX-License-Identifier: MIT
#include "server/world/apply_action.h"

#include <string>
#include <utility>
#include <variant>

#include "jostle/modules/blast.h"
#include "jostle/modules/destruction.h"
#include "jostle/modules/player_interaction.h"

namespace jostle::server {

using namespace physics;

namespace {

// N s/m^2 for each m/s: a crate of a metre and 1000 kg/m^3 gets about that speed.
constexpr double blast_strength = 1000;
// m for each m of its radius and m/s: so near, walls that can break do.
constexpr double blast_breaks = 1.0 / 60;
// Shapes that overlap a body that is to be spawned. Bodies in one place make pairs with the square
// of their number.
constexpr std::size_t crowd_max = 40;

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

// One kind of action each; a kind without one does not compile.
struct Apply {
    HostedState& state;
    ClientId client;
    EntityId& about;

    Status operator()(const SpawnCommand& c) const {
        if (static_cast<int>(state.entities.size()) >= state.limits.scene.bodies_max)
            return refused(ErrorCode::resource_exhausted,
                           "the world is full: it holds " +
                               std::to_string(state.limits.scene.bodies_max) + " bodies");
        if (is_crowded(c))
            return refused(ErrorCode::resource_exhausted,
                           "more than " + std::to_string(crowd_max) +
                               " shapes are in that place; spawn it somewhere else");
        if (state.ownership.count(client) >= state.limits.bodies_owned_max)
            return refused(ErrorCode::resource_exhausted,
                           "you own " + std::to_string(state.limits.bodies_owned_max) +
                               " bodies, the most allowed; delete some first");
        const Result<BodyId> body =
            state.world.create_body(BodyDef{.pose = c.pose,
                                            .linear_velocity = c.linear_velocity,
                                            .angular_velocity = c.angular_velocity},
                                    c.shape);
        if (!body.ok()) return from_solver(body.error());
        about = state.entities.add(state.world, *body, client, c.color, {});
        state.ownership.add(client, about);
        return {};
    }

    Status operator()(const ImpulseCommand& c) const {
        about = c.entity;
        const Result<const Entity*> entity = dynamic_entity(c.entity);
        if (!entity.ok()) return entity.error();
        return from_solver(modules::apply_player_impulse(
            state.world, *state.world.body((*entity)->body), c.impulse, c.point));
    }

    Status operator()(const GrabCommand& c) const {
        about = c.entity;
        const Result<const Entity*> entity = dynamic_entity(c.entity);
        if (!entity.ok()) return entity.error();
        return from_solver(
            state.grabs.grab(state.world, client, *state.world.body((*entity)->body), c.point));
    }

    Status operator()(const DragCommand& c) const {
        const std::optional<BodyId> body = state.grabs.drag(state.world, client, c.target);
        if (!body) return refused(ErrorCode::not_found, "you hold nothing; grab an entity first");
        about = state.entities.entity_of(*body);
        return {};
    }

    Status operator()(const ReleaseCommand&) const {
        state.grabs.release(state.world, client);
        return {};
    }

    Status operator()(const DeleteCommand& c) const {
        about = c.entity;
        if (!state.entities.find(c.entity)) return no_such_entity(c.entity);
        if (!state.ownership.owns(client, c.entity))
            return refused(ErrorCode::permission_denied,
                           "entity " + std::to_string(c.entity) + " is not yours");
        remove(c.entity);
        return {};
    }

    // What a wall hides gets nothing. A click lies on a surface, so the blast stands off a little.
    Status operator()(const ExplodeCommand& c) const {
        const auto pushes =
            modules::compute_blast(state.world, {.center = c.center,
                                                 .radius = c.radius,
                                                 .strength = blast_strength * c.speed,
                                                 .falloff = 0,
                                                 .standoff = 0.3,
                                                 .points = 32,
                                                 .most_speed = 2 * c.speed});
        if (!pushes.ok()) return from_solver(pushes.error());
        if (auto* walls = dynamic_cast<modules::Destruction*>(state.world.module("destruction")))
            walls->break_near(state.world, c.center, blast_breaks * c.radius * c.speed);
        Status status;
        for (const modules::BlastImpulse& p : *pushes) {
            const Status pushed = modules::apply_limited_impulse(
                state.world, *state.world.body(p.body), p.impulse, p.center, p.angular_impulse);
            if (!pushed.ok()) status = from_solver(pushed);
        }
        return status;
    }

    Status operator()(const PossessCommand& c) const {
        about = c.entity;
        if (c.entity == 0) {
            state.controllers.release(state.world, client);
            return {};
        }
        const Entity* entity = state.entities.find(c.entity);
        if (!entity) return no_such_entity(c.entity);
        return state.controllers.possess(state.world, client, entity->body);
    }

    Status operator()(const ControlCommand& c) const {
        const std::optional<BodyId> body =
            state.controllers.control(state.world, client, c.controls);
        if (!body)
            return refused(ErrorCode::not_found, "you drive nothing; possess an entity first");
        about = state.entities.entity_of(*body);
        return {};
    }

    Status operator()(const LeaveCommand& c) const {
        if (!c.retain_bodies)
            for (const EntityId id : state.ownership.owned_by(client)) remove(id);
        state.ownership.forget(client);
        state.grabs.release(state.world, client);
        state.controllers.release(state.world, client);
        return {};
    }

    Status operator()(const DisconnectCommand&) const {
        state.grabs.release(state.world, client);
        static_cast<void>(state.controllers.control(state.world, client, {}));
        return {};
    }

private:
    bool is_crowded(const SpawnCommand& c) const {
        const auto shapes =
            state.world.queries().overlap_shape(c.shape.geometry, compose(c.pose, c.shape.pose));
        return shapes.ok() && shapes->size() > crowd_max;
    }

    void remove(EntityId id) const {
        const BodyId body = state.entities.find(id)->body;
        forget_entity(state, id);
        // The registry and the world agree, so the body is there.
        static_cast<void>(state.world.destroy_body(body).ok());
    }

    Result<const Entity*> dynamic_entity(EntityId id) const {
        const Entity* entity = state.entities.find(id);
        if (!entity) return no_such_entity(id);
        if (entity->description->type != BodyType::dynamic)
            return refused(ErrorCode::permission_denied,
                           "entity " + std::to_string(id) + " is not dynamic; it cannot be moved");
        return entity;
    }
};

}  // namespace

void forget_entity(HostedState& state, EntityId id) {
    const BodyId body = state.entities.find(id)->body;
    state.grabs.release_body(state.world, body);
    state.controllers.release_body(state.world, body);
    state.ownership.remove(id);
    state.entities.remove(id);
}

Status apply_action(HostedState& state, ClientId client, const Action& action, EntityId& about) {
    return std::visit(Apply{state, client, about}, action);
}

}  // namespace jostle::server
