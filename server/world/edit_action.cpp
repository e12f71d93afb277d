// SPDX-License-Identifier: MIT
#include "server/world/edit_action.h"

#include <optional>
#include <string>
#include <vector>

namespace jostle::server {

using namespace physics;

Status edit_body(const ActionContext& context, const EditCommand& c) {
    HostedState& state = context.state;
    context.affected.entity = c.entity;
    const Result<const Entity*> entity = editable_entity(context, c.entity, context.reachable);
    if (!entity.ok()) return entity.error();
    const EntityDescription before = *(*entity)->description;
    const BodyId body = (*entity)->body;
    const BodyAndShapes from = definition_of(state.world, body);
    BodyAndShapes to = from;
    EditFields fields = 0;
    if (c.position) to.body.pose.position = *c.position, fields |= edit_position;
    if (c.rotation) to.body.pose.rotation = *c.rotation, fields |= edit_rotation;
    if (c.linear_velocity)
        to.body.linear_velocity = *c.linear_velocity, fields |= edit_linear_velocity;
    if (c.angular_velocity)
        to.body.angular_velocity = *c.angular_velocity, fields |= edit_angular_velocity;
    if (c.density) {
        for (ShapeDef& shape : to.shapes) shape.density = *c.density, shape.mass = 0;
        to.body.mass = 0;
        fields |= edit_density;
    }
    if (c.mass) to.body.mass = *c.mass, fields |= edit_mass;
    for (ShapeDef& shape : to.shapes) {
        if (c.friction) shape.material.friction = *c.friction, fields |= edit_friction;
        if (c.restitution) shape.material.restitution = *c.restitution, fields |= edit_restitution;
    }
    if (c.gravity_scale) to.body.gravity_scale = *c.gravity_scale, fields |= edit_gravity_scale;
    if (c.color) fields |= edit_color;
    if (c.frozen) fields |= edit_frozen;
    if (fields == 0) return refused(ErrorCode::invalid_argument, "the edit changes nothing");
    const bool frozen = c.frozen.value_or(before.frozen);
    constexpr EditFields of_moving_bodies =
        edit_linear_velocity | edit_angular_velocity | edit_mass | edit_density;
    if (frozen && (fields & of_moving_bodies) != 0)
        return refused(ErrorCode::permission_denied,
                       "entity " + std::to_string(c.entity) +
                           " is frozen; only velocity, mass and density of entities that are "
                           "not frozen can be edited");
    const std::string bytes = record_body(state.world, body);
    if (Status s = write_fields(state, body, to, fields, frozen); !s.ok()) {
        static_cast<void>(write_fields(state, body, from, fields, before.frozen));
        return s;
    }
    state.entities.update(state.world, c.entity, c.color ? c.color : before.color, frozen);
    // A body that freezes stops.
    if (frozen && !before.frozen) fields |= edit_linear_velocity | edit_angular_velocity;
    if (!bytes.empty())
        context.record({.kind = UndoStep::Kind::edited,
                        .entities = {c.entity},
                        .fields = fields,
                        .record = bytes,
                        .color = before.color,
                        .frozen = before.frozen});
    return {};
}

Result<const Entity*> editable_entity(const ActionContext& context, EntityId id,
                                      Reachable reachable) {
    const Entity* const entity = context.state.entities.find(id);
    if (!entity) return no_such_entity(id);
    if (entity->description->type != BodyType::dynamic && !entity->description->frozen)
        return refused(ErrorCode::permission_denied,
                       "entity " + std::to_string(id) +
                           " is not dynamic; only dynamic and frozen entities can be edited "
                           "or cloned");
    if (context.client != scene_client && reachable == Reachable::own &&
        !context.state.ownership.owns(context.client, id))
        return refused(ErrorCode::permission_denied,
                       "entity " + std::to_string(id) +
                           " is not owned by this client; only its owner can edit it");
    return entity;
}

Status write_fields(HostedState& state, BodyId body, const BodyAndShapes& to, EditFields fields,
                    bool frozen) {
    World& world = state.world;
    const auto refusal = [](const Status& s) {
        return s.error().code == ErrorCode::failed_precondition
                   ? refused(ErrorCode::permission_denied, s.error().message)
                   : from_solver(s).error();
    };
    if ((fields & edit_frozen) != 0 && !frozen)
        if (Status s = world.set_type(body, BodyType::dynamic); !s.ok()) return refusal(s);
    if ((fields & (edit_position | edit_rotation)) != 0) {
        Transform pose = world.body(body)->pose;
        if ((fields & edit_position) != 0) pose.position = to.body.pose.position;
        if ((fields & edit_rotation) != 0) pose.rotation = to.body.pose.rotation;
        if (Status s = world.set_pose(body, pose); !s.ok()) return refusal(s);
    }
    if ((fields & edit_density) != 0) {
        if (const auto shapes = world.set_shapes(body, to.shapes); !shapes.ok())
            return refusal(shapes.error());
    } else if ((fields & (edit_friction | edit_restitution)) != 0) {
        const std::vector<ShapeId> shapes = world.shapes_of(body);
        for (std::size_t i = 0; i < shapes.size() && i < to.shapes.size(); i++) {
            Material material = world.shape(shapes[i])->material;
            if ((fields & edit_friction) != 0) material.friction = to.shapes[i].material.friction;
            if ((fields & edit_restitution) != 0)
                material.restitution = to.shapes[i].material.restitution;
            if (Status s = world.set_material(shapes[i], material); !s.ok()) return refusal(s);
        }
    }
    if ((fields & (edit_mass | edit_density)) != 0)
        if (Status s = world.set_mass(body, to.body.mass); !s.ok()) return refusal(s);
    if ((fields & edit_gravity_scale) != 0)
        if (Status s = world.set_gravity_scale(body, to.body.gravity_scale); !s.ok())
            return refusal(s);
    if ((fields & edit_linear_velocity) != 0)
        if (Status s = world.set_linear_velocity(body, to.body.linear_velocity); !s.ok())
            return refusal(s);
    if ((fields & edit_angular_velocity) != 0)
        if (Status s = world.set_angular_velocity(body, to.body.angular_velocity); !s.ok())
            return refusal(s);
    if ((fields & edit_frozen) != 0 && frozen) {
        state.grabs.release_body(world, body);
        if (Status s = world.set_type(body, BodyType::static_body); !s.ok()) return refusal(s);
    }
    return {};
}

}  // namespace jostle::server
