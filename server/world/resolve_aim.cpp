// SPDX-License-Identifier: MIT
#include "server/world/resolve_aim.h"

#include <utility>
#include <variant>

#include "jostle/base/check.h"
#include "server/world/rewind_view.h"

namespace jostle::server {

using namespace physics;

namespace {

struct AimHit {
    EntityId entity = 0;
    Vec3 point;  // world; at the current pose of the entity
};

QueryFilter filter_of(const HostedState& state, const Aim& aim) {
    const Entity* ignored = state.entities.find(aim.ignore);
    return {.ignore = ignored ? ignored->body : BodyId{}};
}

Result<AimHit> aim_hit_of(const HostedState& state, const Result<std::optional<RayHit>>& hit) {
    if (!hit.ok()) return hit.error();
    if (!*hit) return Error{ErrorCode::not_found, "the ray of the aim hits no shape"};
    return AimHit{state.entities.entity_of((*hit)->body), (*hit)->point};
}

Result<AimHit> cast_now(const HostedState& state, const Aim& aim) {
    return aim_hit_of(
        state, state.world.queries().cast_ray({aim.origin, aim.motion}, filter_of(state, aim)));
}

// The hit point is transformed to the current pose of its body.
Result<AimHit> cast_rewound(const HostedState& state, const RewindView& past, const EntityList& now,
                            const Aim& aim) {
    const Result<Queries> then = state.world.queries().with_shapes_at(
        past.shapes_along_segment(now, aim.origin, aim.motion));
    if (!then.ok()) return then.error();
    Result<AimHit> hit =
        aim_hit_of(state, then->cast_ray({aim.origin, aim.motion}, filter_of(state, aim)));
    if (!hit.ok()) return hit;
    ASSERT(past.pose_of(hit->entity) && state.entities.find(hit->entity));
    const Transform past_pose = *past.pose_of(hit->entity);
    const Transform pose = state.world.body(state.entities.find(hit->entity)->body)->pose;
    hit->point = apply(pose, apply_inverse(past_pose, hit->point));
    return hit;
}

const std::optional<Aim>* aim_of(const Action& action) {
    if (const auto* impulse = std::get_if<ImpulseCommand>(&action)) return &impulse->aim;
    if (const auto* grab = std::get_if<GrabCommand>(&action)) return &grab->aim;
    if (const auto* explode = std::get_if<ExplodeCommand>(&action)) return &explode->aim;
    return nullptr;
}

void set_target(Action& action, const AimHit& hit) {
    if (auto* impulse = std::get_if<ImpulseCommand>(&action)) {
        impulse->entity = hit.entity;
        impulse->point = hit.point;
    } else if (auto* grab = std::get_if<GrabCommand>(&action)) {
        grab->entity = hit.entity;
        grab->point = hit.point;
    } else if (auto* explode = std::get_if<ExplodeCommand>(&action)) {
        explode->center = hit.point;
    }
}

}  // namespace

bool has_aim(const Action& action) {
    const std::optional<Aim>* aim = aim_of(action);
    return aim && *aim;
}

Status resolve_aim(const HostedState& state, const FrameRing& past, const EntityList& now,
                   Action& action, InputResult& result) {
    const std::optional<Aim>* aim = aim_of(action);
    if (!aim || !*aim) return {};
    Result<AimHit> hit = AimHit{};
    const auto frames = (*aim)->view_time ? past.at(*(*aim)->view_time) : std::nullopt;
    if (frames) {
        const RewindView view(*frames);
        result.view_time_clamped = view.clamped();
        hit = cast_rewound(state, view, now, **aim);
    } else {
        hit = cast_now(state, **aim);
    }
    if (!hit.ok()) return hit.error();
    result.entity = hit->entity;
    set_target(action, *hit);
    return {};
}

}  // namespace jostle::server
