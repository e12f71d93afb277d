// SPDX-License-Identifier: MIT
#include "server/world/action_context.h"

#include <cstddef>
#include <utility>

#include "jostle/base/check.h"

namespace jostle::server {

using namespace physics;

namespace {

// Limit of shapes that overlap a spawned body. The number of pairs grows with the square of the
// bodies in one place.
constexpr std::size_t spawn_overlaps_max = 40;

bool has_too_many_overlaps(const World& world, const Transform& pose, const ShapeDef& shape) {
    const auto shapes = world.queries().overlap_shape(shape.geometry, compose(pose, shape.pose));
    return shapes.ok() && shapes->size() > spawn_overlaps_max;
}

}  // namespace

Error refused(ErrorCode code, std::string message) {
    return {code, std::move(message)};
}

Error no_such_entity(EntityId id) {
    return refused(ErrorCode::not_found, "entity " + std::to_string(id) + " does not exist");
}

Status from_solver(const Status& status) {
    return status.ok() ? status : refused(ErrorCode::invalid_argument, status.error().message);
}

Status ActionContext::check_body_limits(int count, const Transform& pose,
                                        std::span<const ShapeDef> shapes) const {
    if (static_cast<int>(state.entities.size()) + count > state.limits.scene.bodies_max)
        return refused(ErrorCode::resource_exhausted,
                       "the world has " + std::to_string(state.entities.size()) +
                           " bodies; world.bodies_max allows " +
                           std::to_string(state.limits.scene.bodies_max));
    for (const ShapeDef& shape : shapes)
        if (has_too_many_overlaps(state.world, pose, shape))
            return refused(ErrorCode::resource_exhausted,
                           "more than " + std::to_string(spawn_overlaps_max) +
                               " shapes overlap the spawned body; spawn it elsewhere");
    if (client != scene_client &&
        state.ownership.count(client) + count > state.limits.bodies_owned_max)
        return refused(ErrorCode::resource_exhausted,
                       "the client owns " + std::to_string(state.ownership.count(client)) +
                           " bodies; client.bodies_owned_max allows " +
                           std::to_string(state.limits.bodies_owned_max) + "; delete a body first");
    return {};
}

void ActionContext::own(EntityId id) const {
    if (client != scene_client) state.ownership.add(client, id);
}

void ActionContext::record(UndoStep step) const {
    if (client != scene_client) state.undo.add(client, std::move(step));
}

void ActionContext::remove(EntityId id) const {
    const BodyId body = state.entities.find(id)->body;
    forget_entity(state, id);
    // The registry and the world agree, so the body exists.
    const bool destroyed = state.world.destroy_body(body).ok();
    ASSERT(destroyed);
    static_cast<void>(destroyed);
}

}  // namespace jostle::server
